// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>

#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Text file that is read line by line, with limits for its size. Every error message contains the file and the line.
class TextFile
{
 public:
  /// Reads the whole file. A byte order mark shows UTF-8 and UTF-16 of both byte orders. Without a mark, bytes that are
  /// not valid UTF-8 are taken as Latin-1. Lines may end with \n, \r\n or \r.
  /// @param largest       largest size [bytes]
  /// @param longest_line  largest size of a line [bytes]
  /// @throw FileError if it is not a readable text file, empty or too large.
  explicit TextFile(const std::string& path, std::size_t largest = std::size_t{4} << 20U,
                    std::size_t longest_line = 1000);

  /// Moves to the next line.
  /// @return false after the last line.
  /// @throw FileError if the line is too long.
  bool next();
  /// Moves back to the beginning of the file.
  void rewind();
  /// Current line, without white space at its ends.
  const std::string& line() const { return line_; }
  /// Current line with its white space.
  const std::string& wholeLine() const { return whole_line_; }
  /// Number of the current line, from 1.
  std::size_t number() const { return number_; }
  /// Path of the file.
  const std::string& path() const { return path_; }

  /// Number in a word of the current line.
  /// @param column  its name in the message; empty: not named
  /// @throw FileError if it is not a finite number.
  double numberIn(const std::string& word, const std::string& column = "") const;
  /// Throws a FileError for the current line.
  [[noreturn]] void refuse(const std::string& reason) const { refuse(number_, reason); }
  /// Throws a FileError for the line with the given number, from 1; 0: for the file as a whole.
  [[noreturn]] void refuse(std::size_t line, const std::string& reason) const { throw FileError(path_, line, reason); }
  /// The same if there is a fault.
  void refuseIf(bool fault, std::string_view reason) const { refuseIf(fault, number_, reason); }
  template <typename... Parts>
  void refuseIf(bool fault, std::size_t line, const Parts&... parts) const
  {
    if (fault)
    {
      std::ostringstream reason;
      (reason << ... << parts);
      refuse(line, reason.str());
    }
  }

 private:
  std::string path_;
  std::string text_;
  std::size_t longest_line_;
  std::size_t position_ = 0;
  std::string line_, whole_line_;
  std::size_t number_ = 0;
};
}  // namespace wheel_rail_contact::core
