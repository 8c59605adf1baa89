// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ros/parameters/parameter_tree.h"

namespace wheel_rail_contact
{
/// What a number must meet, and how to say so: "must be " + text.
struct NumberRule
{
  const char* text;       ///< what the value must be
  bool (*holds)(double);  ///< true for a value that is
};

namespace rules
{
extern const NumberRule finite, positive, not_negative, whole;
}  // namespace rules

/// Reads a tree of parameters strictly: each value by its name, its type and its rule. A value that is not given leaves
/// the variable as it is, so that defaults stand where the variable is declared and nowhere else. Values given but
/// never asked for are unknown names.
///
/// Every error is a std::invalid_argument with the full name, the value and the broken rule.
class ParameterReader
{
 public:
  /// @param prefix is written before every name in messages: the node's namespace, or a file and ": "
  ParameterReader(ParameterTree tree, std::string prefix);

  /// True if a value is given.
  bool has(const std::string& name) const { return tree_.count(name) > 0; }

  /// A number, or a string that is a number from end to end (YAML 1.1 readers deliver 210e9 as a string).
  void read(const std::string& name, const NumberRule& rule, double& value);
  /// Likewise, a whole number.
  void read(const std::string& name, const NumberRule& rule, int& value);
  /// Reads `value` = N from a word 1:N. @return false, and `value` unchanged, if the parameter is not given or is not
  /// such a word.
  bool readRatio(const std::string& name, const NumberRule& rule, double& value);
  /// A word; a number counts as the text it is written as.
  void read(const std::string& name, std::string& value);
  /// A list of words.
  void read(const std::string& name, std::vector<std::string>& words);
  /// One of several words.
  template <typename Choice>
  void read(const std::string& name, const std::vector<std::pair<std::string, Choice>>& choices, Choice& value);
  /// A list of groups: a reader for each, whose messages begin with this name. Each must be asked refuseUnknown().
  std::vector<ParameterReader> readGroups(const std::string& name);

  /// True if the value is written as a number; false if it is a word, a list, or not given.
  bool isNumber(const std::string& name) const;

  /// @throw if `name` is not given. `why` completes the sentence "... is missing: ".
  void require(const std::string& name, const std::string& why) const;
  /// @throw if a name was given that nobody asked for.
  void refuseUnknown() const;
  /// Throws for the parameter `name`: full name, value if given, and the rule.
  [[noreturn]] void refuse(const std::string& name, const std::string& rule) const;

  /// Every name that was asked for, given or not.
  const std::set<std::string>& askedNames() const { return asked_; }

 private:
  const YAML::Node* find(const std::string& name);
  const std::string& scalar(const std::string& name, const YAML::Node& node, const std::string& rule) const;
  [[noreturn]] void refuseChoice(const std::string& name, const std::vector<std::string>& words) const;
  std::string siblingsOf(const std::string& name) const;

  ParameterTree tree_;
  std::string prefix_;
  std::set<std::string> asked_;
};

template <typename Choice>
void ParameterReader::read(const std::string& name, const std::vector<std::pair<std::string, Choice>>& choices,
                           Choice& value)
{
  std::string word;
  read(name, word);
  if (!has(name))
  {
    return;
  }
  std::vector<std::string> words;
  for (const auto& choice : choices)
  {
    if (choice.first == word)
    {
      value = choice.second;
      return;
    }
    words.push_back(choice.first);
  }
  refuseChoice(name, words);
}
}  // namespace wheel_rail_contact
