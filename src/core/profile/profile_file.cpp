// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/profile_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>
#include <system_error>

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::uintmax_t largest_file = 4U << 20U;  ///< [bytes]
constexpr std::size_t most_points = 20000;
constexpr std::size_t longest_line = 1000;
constexpr const char* white_space = " \t\r\v\f";
constexpr const char* byte_order_mark = "\xEF\xBB\xBF";

bool isBinary(char c)
{
  const auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && c != '\n' && c != '\t' && c != '\r' && c != '\v' && c != '\f') || code == 0x7F;
}

std::string contentOf(const std::string& path)
{
  const auto refuse = [&path](const std::string& reason) { throw ProfileError(path, 0, reason); };
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    refuse("no such file");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > largest_file)
  {
    refuse("larger than " + std::to_string(largest_file >> 20U) + " MiB: not a profile");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  stream.read(&text[0], static_cast<std::streamsize>(size));
  if (!stream)
  {
    refuse("cannot be read");
  }
  if (std::any_of(text.begin(), text.end(), isBinary))
  {
    refuse("contains binary data: not a profile");
  }
  if (text.find_first_not_of(std::string(white_space) + "\n") == std::string::npos)
  {
    refuse("is empty");
  }
  return text;
}

std::string located(const std::string& file, std::size_t line, const std::string& reason)
{
  return file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + reason;
}
}  // namespace

ProfileError::ProfileError(const std::string& file, std::size_t line, const std::string& reason)
    : std::runtime_error(located(file, line, reason)), file_(file), line_(line), reason_(reason)
{
}

ProfileFile::ProfileFile(const std::string& path) : path_(path), text_(contentOf(path))
{
  if (text_.compare(0, 3, byte_order_mark) == 0)
  {
    position_ = 3;
  }
}

bool ProfileFile::next()
{
  if (position_ >= text_.size())
  {
    return false;
  }
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  ++number_;
  if (end - position_ > longest_line)
  {
    refuse("line has more than " + std::to_string(longest_line) + " characters: not a profile");
  }
  line_ = trim(text_.substr(position_, end - position_));
  position_ = end + 1;
  return true;
}

void ProfileFile::refuse(const std::string& reason) const
{
  refuse(number_, reason);
}

void ProfileFile::refuse(std::size_t line, const std::string& reason) const
{
  throw ProfileError(path_, line, reason);
}

void addPoint(const ProfileFile& file, FileProfile& content, const SampledPoint& point)
{
  if (content.points.size() >= most_points)
  {
    file.refuse("more than " + std::to_string(most_points) + " points");
  }
  content.points.push_back({point, file.number()});
}

std::optional<double> parseNumber(const std::string& word)
{
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double value = 0;
  if (!(stream >> std::noskipws >> value) || stream.peek() != std::char_traits<char>::eof() || !std::isfinite(value))
  {
    return std::nullopt;
  }
  return value;
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
}  // namespace wheel_rail_contact::core
