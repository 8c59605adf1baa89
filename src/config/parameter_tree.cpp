// SPDX-License-Identifier: BSD-3-Clause
#include "config/parameter_tree.h"

#include <stdexcept>

#include "core/option_check.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int max_depth = 16;       ///< of nested groups
constexpr int max_entries = 10000;  ///< necessary because of aliases: a short file can have any number of entries

/// Adds the parameters of nested groups to a tree.
/// @param entries  number of names so far, of groups and parameters
void collect(const YAML::Node& group, const std::string& prefix, int depth, int& entries, ParameterTree& tree)
{
  core::refuseIf(depth > max_depth, "parameters: more than " + std::to_string(max_depth) + " nested groups");
  for (const auto& entry : group)
  {
    core::refuseIf(!entry.first.IsScalar(), "parameters: the group '" + prefix + "' has a key that is not a name");
    core::refuseIf(++entries > max_entries, "parameters: more than " + std::to_string(max_entries) + " names");
    const std::string name = prefix + entry.first.Scalar();
    if (entry.second.IsMap())
    {
      collect(entry.second, name + "/", depth + 1, entries, tree);
    }
    else if (!tree.emplace(name, entry.second).second)
    {
      throw std::invalid_argument("parameter " + name + " is given twice");
    }
  }
}

/// True if a group with parameters in the tree has this name.
bool containsOne(const std::string& name, const ParameterTree& tree)
{
  const auto next = tree.lower_bound(name + '/');
  return next != tree.end() && next->first.compare(0, name.size() + 1, name + '/') == 0;
}

/// True if a parameter of the tree has the name of a group with this name in it.
bool isWithin(const std::string& name, const ParameterTree& tree)
{
  for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1))
  {
    if (tree.count(name.substr(0, slash)) > 0)
    {
      return true;
    }
  }
  return false;
}

ParameterTree readParameters(const ParameterSource& source, const FileSearch& search)
{
  if (source.kind == ParameterSource::file)
  {
    return readParameterFile(search.find(source.value));
  }
  try
  {
    return parameterTree(YAML::Load(source.value));
  }
  catch (const YAML::Exception& error)
  {
    throw std::invalid_argument(std::string("parameters: ") + error.what());
  }
}
}  // namespace

ParameterTree parameterTree(const YAML::Node& document)
{
  if (!document.IsDefined() || document.IsNull())
  {
    return {};
  }
  core::refuseIf(!document.IsMap(), "parameters: the document must be a map of names and values");
  ParameterTree tree;
  int entries = 0;
  collect(document, "", 1, entries, tree);
  return tree;
}

ParameterTree readParameterFile(const std::string& file)
{
  try
  {
    return parameterTree(YAML::LoadFile(file));
  }
  catch (const YAML::Exception& error)
  {
    throw std::invalid_argument(file + ": " + error.what());
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(file + ": " + error.what());
  }
}

ParameterTree overlay(const ParameterTree& base, const ParameterTree& upper)
{
  ParameterTree result = upper;
  for (const auto& entry : base)
  {
    if (!isWithin(entry.first, upper) && !containsOne(entry.first, upper))
    {
      result.insert(entry);
    }
  }
  return result;
}

ParameterTree readParameters(const std::vector<ParameterSource>& sources, const FileSearch& search)
{
  ParameterTree tree;
  for (const ParameterSource& source : sources)
  {
    tree = overlay(tree, readParameters(source, search));
  }
  return tree;
}
}  // namespace wheel_rail_contact
