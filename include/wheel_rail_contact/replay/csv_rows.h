// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "wheel_rail_contact/ros/messages.h"

namespace wheel_rail_contact
{
/// Names of the columns with their units, as a line.
std::string csvHeader();

/// A line for each patch of an answer; one with empty cells at the patch for an answer that has none.
/// @param number of the answer in the output
std::string csvRows(const WheelsetContactMsg& answer, std::uint64_t number, const std::string& wheelset);

/// The table on its way to a file.
class CsvFile
{
 public:
  /// @param resume true: the file must exist; cut() must be called before anything is written
  /// @throw std::runtime_error if the file exists, or with `resume` does not, or cannot be written.
  CsvFile(const std::string& path, bool resume);

  /// Removes the lines of the answers from `number` on, and goes on after those before.
  /// @throw std::runtime_error if lines of those before are missing.
  void cut(std::uint64_t number);
  void write(const std::string& rows) { file_ << rows; }
  /// @throw std::runtime_error if not everything could be written.
  void flush();

 private:
  std::string path_;
  std::ofstream file_;
};
}  // namespace wheel_rail_contact
