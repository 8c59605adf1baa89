// SPDX-License-Identifier: BSD-3-Clause
#include "core/text/words.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <locale>
#include <regex>
#include <sstream>

namespace wheel_rail_contact::core
{
namespace
{
constexpr const char* white_space = " \t\r\n\v\f";
constexpr std::size_t longest_missing = 100;  ///< sign of a missing value [bytes]
constexpr const char* exponent_letters = "eEdD";

/// Place of the sign that closes the quotation or bracket that opens at a place; this place if there is none.
std::size_t closing(const std::string& line, std::size_t open)
{
  const std::size_t kind = std::string("\"[(").find(line[open]);
  std::size_t end = kind == std::string::npos ? kind : line.find("\"])"[kind], open + 1);
  while (end != std::string::npos && line.compare(end, 2, "\"\"") == 0)
  {
    end = line.find('"', end + 2);
  }
  return end == std::string::npos ? open : end;
}

/// Cell without white space at its ends. If it is a quotation, its quotation marks are removed.
std::string cellOf(const std::string& text)
{
  std::string cell = trim(text);
  if (cell.size() > 1 && cell.front() == '"' && closing(cell, 0) + 1 == cell.size())
  {
    cell.erase(std::remove(cell.begin(), cell.end(), '"'), cell.end());
  }
  return trim(cell);
}
}  // namespace

std::optional<double> parseNumber(std::string word)
{
  const std::size_t exponent = word.find_first_of("dD");
  if (exponent != std::string::npos)
  {
    word[exponent] = 'e';
  }
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double value = 0;
  if (!(stream >> std::noskipws >> value) || stream.peek() != std::char_traits<char>::eof() || !std::isfinite(value))
  {
    return std::nullopt;
  }
  return value;
}

bool isMissing(const std::string& cell)
{
  static const std::regex missing(R"([+-]?nan(\(\w*\))?|[+-]?1\.#(qnan|ind)\d*|#?n/a|na|null|-*)",
                                  std::regex::ECMAScript | std::regex::icase);
  return !parseNumber(cell) && cell.size() < longest_missing && std::regex_match(cell, missing);
}

int decimalPlaces(const std::string& number)
{
  const std::size_t end = std::min(number.find_first_of(exponent_letters), number.size());
  const double exponent = end < number.size() ? parseNumber(number.substr(end + 1)).value_or(0) : 0;
  std::size_t places = 0;
  if (const std::size_t point = number.find('.'); point < end)
  {
    const std::string fraction = number.substr(point + 1, end - point - 1);
    places = fraction.find_last_not_of('0') + 1;  // npos + 1 is 0
  }
  return static_cast<int>(places) - static_cast<int>(std::clamp(exponent, -300.0, 300.0));
}

std::vector<std::string> splitWords(const std::string& line)
{
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

std::vector<std::string> splitCells(const std::string& line, char separator)
{
  const bool at_blanks = separator == ' ';
  const std::string ends = at_blanks ? white_space : std::string(1, separator);
  std::vector<std::string> cells;
  for (std::size_t begin = 0, end = 0; begin <= line.size(); begin = end + 1)
  {
    const std::size_t text = std::min(line.find_first_not_of(' ', begin), line.size());
    for (end = text; end < line.size() && ends.find(line[end]) == std::string::npos; ++end)
    {
      end = at_blanks || (end == text && line[end] == '"') ? closing(line, end) : end;
    }
    const std::string cell = cellOf(line.substr(begin, end - begin));
    const char last = cells.empty() || cells.back().empty() ? ' ' : cells.back().back();
    const bool in_brackets = (line[text] == '[' || line[text] == '(') && last != ']' && last != ')';
    if (at_blanks && end > text && !cells.empty() && (last == '/' || line[text] == '/' || in_brackets))
    {
      cells.back() += " " + cell;
    }
    else if (!at_blanks || end > text)
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

char separatorIn(const std::string& line)
{
  for (const char separator : {';', '\t', ','})
  {
    if (line.find(separator) != std::string::npos)
    {
      return separator;
    }
  }
  return ' ';
}

std::string trim(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(white_space);
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(white_space) - begin + 1);
}

std::string lowerCase(std::string text)
{
  for (char& c : text)
  {
    if (c >= 'A' && c <= 'Z')
    {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return text;
}

std::string withoutComment(const std::string& line)
{
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const bool begins_word = i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t';
    if (line[i] == '#' || line[i] == '%' || line[i] == '!' || (begins_word && line.compare(i, 2, "//") == 0))
    {
      return trim(line.substr(0, i));
    }
  }
  return line;
}

std::string withoutCommentSign(const std::string& line)
{
  return trim(line.substr(std::min(line.find_first_not_of("#%!/"), line.size())));
}

std::string withPoint(std::string number)
{
  const std::size_t comma = number.find(',');
  if (comma != std::string::npos && comma + 1 < number.size() &&
      number.find_first_of(",.", comma + 1) == std::string::npos && number.find('.') == std::string::npos)
  {
    number[comma] = '.';
  }
  return number;
}
}  // namespace wheel_rail_contact::core
