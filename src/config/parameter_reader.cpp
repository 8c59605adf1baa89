// SPDX-License-Identifier: BSD-3-Clause
#include "config/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "core/option_check.h"

namespace wheel_rail_contact
{
namespace rules
{
const NumberRule finite{"a finite number", [](double v) { return std::isfinite(v); }};
const NumberRule positive{"a finite number > 0", [](double v) { return std::isfinite(v) && v > 0; }};
const NumberRule not_negative{"a finite number >= 0", [](double v) { return std::isfinite(v) && v >= 0; }};
const NumberRule whole{"a whole number from -1000000 to 1000000",
                       [](double v) { return std::abs(v) <= 1e6 && std::floor(v) == v; }};
}  // namespace rules

namespace
{
/// Value of a text that consists of a number, including YAML's names of infinity and not-a-number; else nothing.
std::optional<double> parseNumber(const std::string& text)
{
  const std::size_t sign = (text.rfind('-', 0) == 0 || text.rfind('+', 0) == 0) ? 1 : 0;
  const std::string word = text.substr(sign);
  if (word == ".inf" || word == "inf")
  {
    return (text[0] == '-' ? -1 : 1) * std::numeric_limits<double>::infinity();
  }
  if (word == ".nan" || word == "nan")
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return core::parseNumber(text);
}
}  // namespace

ParameterReader::ParameterReader(ParameterTree tree, std::string prefix)
    : tree_(std::move(tree)), prefix_(std::move(prefix))
{
}

const YAML::Node* ParameterReader::find(const std::string& name)
{
  known_.insert(name);
  const auto entry = tree_.find(name);
  if (entry == tree_.end())
  {
    return nullptr;
  }
  core::refuseIf(entry->second.IsNull(), "parameter " + prefix_ + name + " has no value");
  return &entry->second;
}

const std::string& ParameterReader::scalar(const std::string& name, const YAML::Node& node,
                                           const std::string& rule) const
{
  refuseIf(!node.IsScalar(), name, rule);
  return node.Scalar();
}

void ParameterReader::read(const std::string& name, const NumberRule& rule, double& value)
{
  if (const YAML::Node* node = find(name))
  {
    const auto number = parseNumber(scalar(name, *node, rule.text));
    refuseIf(!number || !rule.holds(*number), name, rule.text);
    value = *number;
  }
}

void ParameterReader::read(const std::string& name, const NumberRule& rule, int& value)
{
  double number = value;
  read(name, rule, number);
  value = static_cast<int>(number);
}

bool ParameterReader::readRatio(const std::string& name, const NumberRule& rule, double& value)
{
  const YAML::Node* node = find(name);
  if (!node || !node->IsScalar() || node->Scalar().rfind("1:", 0) != 0)
  {
    return false;
  }
  const auto number = parseNumber(node->Scalar().substr(2));
  refuseIf(!number || !rule.holds(*number), name, rule.text);
  value = *number;
  return true;
}

void ParameterReader::read(const std::string& name, std::string& value)
{
  if (const YAML::Node* node = find(name))
  {
    value = scalar(name, *node, "a string");
  }
}

void ParameterReader::read(const std::string& name, std::vector<std::string>& words)
{
  if (const YAML::Node* node = find(name))
  {
    refuseIf(!node->IsSequence(), name, "a list of strings");
    words.clear();
    for (const auto& entry : *node)
    {
      words.push_back(scalar(name, entry, "a list of strings"));
    }
  }
}

void ParameterReader::read(const std::string& name, std::vector<double>& numbers)
{
  std::vector<std::string> words;
  read(name, words);
  for (const std::string& word : words)
  {
    const auto number = parseNumber(word);
    refuseIf(!number || !std::isfinite(*number), name, "a list of finite numbers");
    numbers.push_back(*number);
  }
}

std::vector<ParameterReader> ParameterReader::readGroups(const std::string& name)
{
  std::vector<ParameterReader> groups;
  const YAML::Node* node = find(name);
  if (!node)
  {
    return groups;
  }
  refuseIf(!node->IsSequence(), name, "a list of groups");
  for (const auto& entry : *node)
  {
    refuseIf(!entry.IsMap(), name, "a list of groups");
    groups.emplace_back(parameterTree(entry), prefix_ + name + "/");
  }
  return groups;
}

bool ParameterReader::isNumber(const std::string& name) const
{
  const auto entry = tree_.find(name);
  return entry != tree_.end() && entry->second.IsScalar() && parseNumber(entry->second.Scalar()).has_value();
}

void ParameterReader::require(const std::string& name, const std::string& why) const
{
  core::refuseIf(!has(name), "parameter " + prefix_ + name + " is missing: " + why);
}

void ParameterReader::refuseUnknown() const
{
  for (const auto& entry : tree_)
  {
    core::refuseIf(known_.count(entry.first) == 0,
                   "parameter " + prefix_ + entry.first + " is unknown; known names" + knownBeside(entry.first));
  }
}

void ParameterReader::refuse(const std::string& name, const std::string& rule) const
{
  const auto entry = tree_.find(name);
  std::string value;
  if (entry != tree_.end())
  {
    YAML::Emitter text;
    text << YAML::Flow << entry->second;
    value = std::string(" = ") + text.c_str();
  }
  throw std::invalid_argument("parameter " + prefix_ + name + value + " must be " + rule);
}

/// Known names in the innermost group of `name` that has any, or all groups and names outside of groups: the end of a
/// message.
std::string ParameterReader::knownBeside(const std::string& name) const
{
  std::set<std::string> known;
  for (auto slash = name.rfind('/'); slash != std::string::npos; slash = name.substr(0, slash).rfind('/'))
  {
    const std::string group = name.substr(0, slash + 1);
    std::copy_if(known_.begin(), known_.end(), std::inserter(known, known.end()),
                 [&group](const std::string& candidate) { return candidate.rfind(group, 0) == 0; });
    if (!known.empty())
    {
      return " in this group: " + core::joined(known, ", ");
    }
  }
  for (const std::string& candidate : known_)
  {
    known.insert(candidate.substr(0, candidate.find('/')));
  }
  return ": " + core::joined(known, ", ");
}
}  // namespace wheel_rail_contact
