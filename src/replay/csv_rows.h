// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include <wheel_rail_contact/WheelsetContact.h>

namespace wheel_rail_contact
{
/// Rows of a result in the table: one per patch, or one with empty patch columns if the result has no patches.
/// @param number of the result in the output, counted from 0
std::string csvRows(const WheelsetContact& result, std::uint64_t number, const std::string& wheelset);

/// Writer of the table of patches. Units are in the column names of its first line.
class CsvFile
{
 public:
  /// @throw std::runtime_error if the file exists without `resume`, or does not exist with `resume`.
  static void requireUsablePath(const std::string& path, bool resume);

  /// @param resume true: continues the existing file. The file is not changed before the first write() or finish()
  /// @throw std::runtime_error as requireUsablePath(), or if the file cannot be written.
  CsvFile(const std::string& path, bool resume);

  /// Appends the rows of a result. The first call after resuming replaces the rows of this and of all later results.
  /// @throw std::runtime_error if the file is not such a table, or if rows of earlier results are missing.
  void write(std::uint64_t number, const std::string& rows);
  /// Writes buffered rows to the file.
  /// @throw std::runtime_error if the file cannot be written.
  void flush();
  /// Completes the table. Afterwards it contains the rows of the first `results` results and no others.
  /// @throw std::runtime_error as write() and flush().
  void finish(std::uint64_t results);

 private:
  void truncate(std::uint64_t number);
  std::uint64_t resultOf(const std::string& row) const;

  std::string path_;
  bool truncation_pending_;  ///< resumed, and not yet written to
  std::ofstream file_;
};
}  // namespace wheel_rail_contact
