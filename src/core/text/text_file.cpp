// SPDX-License-Identifier: BSD-3-Clause
#include "core/text/text_file.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr char32_t replacement = 0xFFFD;  ///< stands for bytes that are no character

bool beginsWith(const std::string& bytes, const std::string& mark)
{
  return bytes.compare(0, mark.size(), mark) == 0;
}

std::uint32_t byteAt(const std::string& bytes, std::size_t i)
{
  return static_cast<unsigned char>(bytes[i]);
}

/// Number of bytes that follow the first byte of a character in UTF-8; 4 if it is not a first byte.
std::size_t following(std::uint32_t first)
{
  if (first < 0x80)
  {
    return 0;
  }
  return first >= 0xC2 && first < 0xE0 ? 1 : first >= 0xE0 && first < 0xF0 ? 2 : first >= 0xF0 && first < 0xF5 ? 3 : 4;
}

/// True for UTF-8 without overlong forms and surrogates (RFC 3629).
bool isUtf8(const std::string& bytes)
{
  for (std::size_t i = 0, more = 0; i < bytes.size(); i += 1 + more)
  {
    const std::uint32_t first = byteAt(bytes, i);
    more = following(first);
    if (more > 3 || i + more >= bytes.size())
    {
      return false;
    }
    for (std::size_t k = 1; k <= more; ++k)
    {
      const std::uint32_t least = k > 1 ? 0x80 : first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
      const std::uint32_t most = k > 1 ? 0xBF : first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
      if (byteAt(bytes, i + k) < least || byteAt(bytes, i + k) > most)
      {
        return false;
      }
    }
  }
  return true;
}

void append(std::string& text, char32_t character)
{
  const auto tail = [character](unsigned shift) { return static_cast<char>(0x80 | ((character >> shift) & 0x3F)); };
  if (character < 0x80)
  {
    text += static_cast<char>(character);
  }
  else if (character < 0x800)
  {
    text += {static_cast<char>(0xC0 | (character >> 6)), tail(0)};
  }
  else
  {
    text += {static_cast<char>(0xE0 | (character >> 12)), tail(6), tail(0)};
  }
}

/// Text from UTF-16 after its byte order mark. Characters beyond the first 65536 become the replacement character.
std::string fromUtf16(const std::string& bytes, bool big_endian)
{
  std::string text;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2)
  {
    const char32_t unit = (byteAt(bytes, big_endian ? i : i + 1) << 8U) | byteAt(bytes, big_endian ? i + 1 : i);
    append(text, unit >= 0xD800 && unit < 0xE000 ? replacement : unit);
  }
  return text;
}

std::string fromLatin1(const std::string& bytes)
{
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    append(text, byteAt(bytes, i));
  }
  return text;
}

/// Text in UTF-8 with the lines as they are in the file.
std::string asUtf8(const std::string& bytes)
{
  if (beginsWith(bytes, "\xFF\xFE") || beginsWith(bytes, "\xFE\xFF"))
  {
    return fromUtf16(bytes, bytes[0] == '\xFE');
  }
  const std::string text = beginsWith(bytes, "\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
  return isUtf8(text) ? text : fromLatin1(text);
}

bool isControl(char c)
{
  const auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\v' && c != '\f') || code == 0x7F;
}

std::string contentOf(const std::string& path, std::size_t largest)
{
  const auto refuse_if = [&path](bool fault, const std::string& reason)
  {
    if (fault)
    {
      throw FileError(path, 0, reason);
    }
  };
  std::error_code error;
  refuse_if(path.find('\0') != std::string::npos || !std::filesystem::is_regular_file(path, error), "no such file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  refuse_if(error || size > largest, "larger than " + std::to_string(largest >> 20U) + " MiB");
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(&bytes[0], static_cast<std::streamsize>(size));
  refuse_if(!stream, "cannot be read");
  std::string text = asUtf8(bytes);
  // Ctrl-Z ends the text of files of DOS.
  text.erase(text.find_last_not_of('\x1A') + 1);
  refuse_if(std::any_of(text.begin(), text.end(), isControl),
            "contains binary data: not a text in UTF-8, Latin-1, or UTF-16 with a byte order mark");
  refuse_if(trim(text).empty(), "is empty");
  return text;
}

/// Path for a message, which a NUL would end.
std::string printable(std::string path)
{
  std::replace(path.begin(), path.end(), '\0', '?');
  return path;
}
}  // namespace

FileError::FileError(const std::string& file, std::size_t line, const std::string& reason)
    : std::runtime_error(printable(file) + (line > 0 ? ":" + std::to_string(line) : "") + ": " + reason),
      file_(file),
      line_(line),
      reason_(reason)
{
}

TextFile::TextFile(const std::string& path, std::size_t largest, std::size_t longest_line)
    : path_(path), text_(contentOf(path, largest)), longest_line_(longest_line)
{
}

bool TextFile::next()
{
  if (position_ >= text_.size())
  {
    return false;
  }
  const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  ++number_;
  refuseIf(end - position_ > longest_line_, number_, "line has more than ", longest_line_, " characters");
  whole_line_ = text_.substr(position_, end - position_);
  line_ = trim(whole_line_);
  position_ = end + (text_.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  return true;
}

void TextFile::rewind()
{
  position_ = 0;
  number_ = 0;
  line_.clear();
  whole_line_.clear();
}

double TextFile::numberIn(const std::string& word, const std::string& column) const
{
  const std::optional<double> value = parseNumber(word);
  if (!value)
  {
    refuse((column.empty() ? "" : "column '" + column + "': ") + "'" + word + "' is not a finite number");
  }
  return *value;
}
}  // namespace wheel_rail_contact::core
