// SPDX-License-Identifier: BSD-3-Clause
#include "core/text/text_file.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/text/encoding.h"
#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::size_t longest_line = 1000;

std::string contentOf(const std::string& path, std::size_t largest)
{
  const auto refuse = [&path](const std::string& reason) { throw TextError(path, 0, reason); };
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    refuse("no such file");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > largest)
  {
    refuse("larger than " + std::to_string(largest >> 20U) + " MiB");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(&bytes[0], static_cast<std::streamsize>(size));
  if (!stream)
  {
    refuse("cannot be read");
  }
  const std::optional<std::string> text = decodedText(bytes);
  if (!text)
  {
    refuse("contains binary data: not a text file");
  }
  if (trim(*text).empty())
  {
    refuse("is empty");
  }
  return *text;
}

std::string located(const std::string& file, std::size_t line, const std::string& reason)
{
  return file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + reason;
}
}  // namespace

TextError::TextError(const std::string& file, std::size_t line, const std::string& reason)
    : std::runtime_error(located(file, line, reason)), file_(file), line_(line), reason_(reason)
{
}

TextFile::TextFile(const std::string& path, std::size_t largest) : path_(path), text_(contentOf(path, largest)) {}

bool TextFile::next()
{
  if (position_ >= text_.size())
  {
    return false;
  }
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  ++number_;
  if (end - position_ > longest_line)
  {
    refuse("line has more than " + std::to_string(longest_line) + " characters");
  }
  line_ = trim(text_.substr(position_, end - position_));
  position_ = end + 1;
  return true;
}

void TextFile::rewind()
{
  position_ = 0;
  number_ = 0;
  line_.clear();
}

void TextFile::refuse(const std::string& reason) const
{
  refuse(number_, reason);
}

void TextFile::refuse(std::size_t line, const std::string& reason) const
{
  throw TextError(path_, line, reason);
}
}  // namespace wheel_rail_contact::core
