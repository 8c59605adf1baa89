// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wheel_rail_contact::core
{
/// Converts a word to a finite number, in any locale; nothing if it is not one. The exponent may begin with e or d
/// (Fortran).
std::optional<double> parseNumber(std::string word);
/// True if a cell contains no value, as programs write it: empty, -, NaN, NA or null.
bool isMissing(const std::string& cell);
/// Number of decimal places of a number as written, with a decimal point, without zeros at its end: 1 for "40.60", -1
/// for "2e1".
int decimalPlaces(const std::string& number);
/// Words of a line, separated by white space.
std::vector<std::string> splitWords(const std::string& line);
/// Cells of a line, without white space at their ends. A cell may be in quotation marks. Separator ' ': white space,
/// but not before a unit in brackets, in it, or beside a slash.
std::vector<std::string> splitCells(const std::string& line, char separator);
/// First of semicolon, tab and comma that occurs in a line; otherwise ' '.
char separatorIn(const std::string& line);
/// Words in one text, with a separator between them.
template <typename Words>
std::string joined(const Words& words, const std::string& separator)
{
  std::string text;
  for (const auto& word : words)
  {
    text += (text.empty() ? "" : separator) + word;
  }
  return text;
}
/// Text without white space at its ends.
std::string trim(const std::string& text);
/// Text with the letters A to Z in lower case.
std::string lowerCase(std::string text);
/// Line up to a comment, which begins with #, %, !, or with // at the beginning of a word.
std::string withoutComment(const std::string& line);
/// Line without the sign of a comment at its beginning.
std::string withoutCommentSign(const std::string& line);
/// Number with a decimal comma as one with a decimal point. A comma at the end is none.
std::string withPoint(std::string number);
}  // namespace wheel_rail_contact::core
