// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "config/parameter_tree.h"
#include "core/text/words.h"

namespace wheel_rail_contact
{
/// Rule for a number, with its text for the message "... must be TEXT".
struct NumberRule
{
  const char* text;       ///< noun phrase, for example "a finite number > 0"
  bool (*holds)(double);  ///< true for a valid value
};

/// Common rules; `whole` permits whole numbers from -1000000 to 1000000.
namespace rules
{
extern const NumberRule finite, positive, not_negative, whole;
}  // namespace rules

/// Reads a tree of parameters strictly: each value by name, with a check of its type and its rule. The variable of a
/// parameter that is not given stays unchanged. Defaults are therefore defined only where the variables are declared.
/// Given parameters that were never read have unknown names.
///
/// Every error is a std::invalid_argument with the full name, the value and the violated rule.
class ParameterReader
{
 public:
  /// @param prefix text before every name in messages: the namespace of the node with '/', or a file and ": "
  ParameterReader(ParameterTree tree, std::string prefix);

  /// Makes a name known without reading it.
  void know(const std::string& name) { known_.insert(name); }
  /// True if the parameter is given.
  bool has(const std::string& name) const { return tree_.count(name) > 0; }

  /// Reads a number, or a string that consists of a number: YAML 1.1 parsers read 210e9 as a string.
  void read(const std::string& name, const NumberRule& rule, double& value);
  /// Reads a number with a rule that permits only whole numbers in the range of int.
  void read(const std::string& name, const NumberRule& rule, int& value);
  /// Reads `value` = N from a string 1:N. The rule is that for N.
  /// @return false if the parameter is not given or does not begin with "1:"; `value` is unchanged then.
  bool readRatio(const std::string& name, const NumberRule& rule, double& value);
  /// Reads a string. A number is read as its text.
  void read(const std::string& name, std::string& value);
  /// Reads a list of strings.
  void read(const std::string& name, std::vector<std::string>& words);
  /// Reads a list of finite numbers.
  void read(const std::string& name, std::vector<double>& numbers);
  /// Reads one of several words, and sets `value` to its constant.
  template <typename Choice>
  void read(const std::string& name, const std::vector<std::pair<std::string, Choice>>& choices, Choice& value);
  /// Reads a list of groups. Call refuseUnknown() of each returned reader.
  /// @return a reader for each group, with this name in its prefix
  std::vector<ParameterReader> readGroups(const std::string& name);

  /// True if the value is a number; false if it is another string, a list, or not given.
  bool isNumber(const std::string& name) const;

  /// @param why end of the message "... is missing: WHY"
  /// @throw std::invalid_argument if `name` is not given.
  void require(const std::string& name, const std::string& why) const;
  /// @throw std::invalid_argument if a given parameter was never read.
  void refuseUnknown() const;
  /// @throw std::invalid_argument "parameter NAME = VALUE must be RULE", always.
  [[noreturn]] void refuse(const std::string& name, const std::string& rule) const;
  /// The same if there is a fault.
  void refuseIf(bool fault, const std::string& name, const std::string& rule) const
  {
    if (fault)
    {
      refuse(name, rule);
    }
  }

 private:
  const YAML::Node* find(const std::string& name);
  const std::string& scalar(const std::string& name, const YAML::Node& node, const std::string& rule) const;
  std::string knownBeside(const std::string& name) const;

  ParameterTree tree_;
  std::string prefix_;
  std::set<std::string> known_;  ///< names that were read
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
  refuse(name, "one of " + core::joined(words, ", "));
}
}  // namespace wheel_rail_contact
