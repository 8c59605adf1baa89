// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace wheel_rail_contact::core
{
/// Text file that cannot be used. what() is "file:line: reason", or "file: reason" if the file as a whole is wrong.
class TextError : public std::runtime_error
{
 public:
  /// @param line  number of the line, from 1; 0 for the file as a whole
  TextError(const std::string& file, std::size_t line, const std::string& reason);

  const std::string& file() const { return file_; }
  std::size_t line() const { return line_; }
  const std::string& reason() const { return reason_; }

 private:
  std::string file_;
  std::size_t line_;
  std::string reason_;
};

/// Text file that is read line by line, with limits for its size. Every error message contains the file and the line.
class TextFile
{
 public:
  /// Reads the whole file. See decodedText() for its encoding.
  /// @param largest  largest size [bytes]
  /// @throw TextError if it is not a readable text file, empty or too large.
  explicit TextFile(const std::string& path, std::size_t largest = std::size_t{4} << 20U);

  /// Moves to the next line.
  /// @return false after the last line.
  /// @throw TextError if the line is too long.
  bool next();
  /// Moves back to the beginning of the file.
  void rewind();
  /// Current line, without white space at its ends.
  const std::string& line() const { return line_; }
  /// Number of the current line, from 1.
  std::size_t number() const { return number_; }
  /// Path of the file.
  const std::string& path() const { return path_; }

  /// Throws a TextError for the current line.
  [[noreturn]] void refuse(const std::string& reason) const;
  /// Throws a TextError for the line with the given number, from 1; 0: for the file as a whole.
  [[noreturn]] void refuse(std::size_t line, const std::string& reason) const;

 private:
  std::string path_;
  std::string text_;
  std::size_t position_ = 0;
  std::string line_;
  std::size_t number_ = 0;
};
}  // namespace wheel_rail_contact::core
