// SPDX-License-Identifier: BSD-3-Clause
#include "core/text/words.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <locale>
#include <sstream>

namespace wheel_rail_contact::core
{
namespace
{
constexpr const char* white_space = " \t\r\n\v\f";
constexpr const char* exponent_letters = "eEdD";
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

std::vector<std::string> splitFields(const std::string& line, char separator)
{
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1)
  {
    end = line.find(separator, begin);
    fields.push_back(trim(line.substr(begin, end - begin)));
  }
  return fields;
}

std::vector<std::string> splitAt(const std::string& line, char separator, std::size_t least)
{
  std::vector<std::string> fields = separator == ' ' ? splitWords(line) : splitFields(line, separator);
  while (fields.size() > least && fields.back().empty())
  {
    fields.pop_back();
  }
  return fields;
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
