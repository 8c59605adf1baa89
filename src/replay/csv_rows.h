// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include <wheel_rail_contact/WheelsetContact.h>

namespace wheel_rail_contact
{
/// A line for each patch of an answer; one with empty cells at the patch for an answer that has none.
/// @param number of the answer in the output
std::string csvRows(const WheelsetContact& result, std::uint64_t number, const std::string& wheelset);

/// The table on its way to a file.
class CsvFile
{
 public:
  /// @throw std::runtime_error if the file exists, or with `resume` does not.
  static void requirePlace(const std::string& path, bool resume);

  /// @param resume true: goes on with the file that is there, which is left as it is until write() or finish()
  /// @throw std::runtime_error as requirePlace() does, or if the file cannot be written.
  CsvFile(const std::string& path, bool resume);

  /// Adds the rows of an answer. When a table is resumed, the first rows replace those of this answer and after it.
  /// @throw std::runtime_error if rows of the answers before are missing.
  void write(std::uint64_t number, const std::string& rows);
  /// @throw std::runtime_error if not everything could be written.
  void flush();
  /// After the last rows: the table is that of so many answers.
  /// @throw std::runtime_error as write() and flush() do.
  void finish(std::uint64_t results);

 private:
  void cut(std::uint64_t number);
  std::uint64_t resultOf(const std::string& row) const;

  std::string path_;
  bool uncut_;  ///< resumed, and nothing was written since
  std::ofstream file_;
};
}  // namespace wheel_rail_contact
