// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

namespace wheel_rail_contact::core
{
/// A CSV file that a command reads again. Each line is flushed at once to detect a full disk.
///
/// @throw std::runtime_error with the name of the file if it cannot be written: from all functions that end a line.
class Csv
{
 public:
  /// @param digits  significant digits of each number; without: all, so that it is read as the same number
  explicit Csv(const std::filesystem::path& file, int digits = std::numeric_limits<double>::max_digits10)
      : file_(file), stream_(file)
  {
    stream_.precision(digits);
    check();
  }

  /// Writes a line as it is: titles or a comment.
  void line(const std::string& text)
  {
    stream_ << text;
    endRow();
  }

  /// Writes a row of cells.
  template <typename... Cells>
  void row(const Cells&... cells)
  {
    add(cells...);
    endRow();
  }

  /// Adds cells to the present row.
  template <typename... Cells>
  void add(const Cells&... cells)
  {
    (addCell(cells), ...);
  }

  /// Adds empty cells to the present row.
  void addEmpty(int cells)
  {
    for (int i = 0; i < cells; ++i)
    {
      add("");
    }
  }

  void endRow()
  {
    stream_ << std::endl;
    is_begun_ = false;
    check();
  }

 private:
  template <typename Cell>
  void addCell(const Cell& cell)
  {
    stream_ << (is_begun_ ? "," : "") << cell;
    is_begun_ = true;
  }

  void check() const
  {
    if (!stream_)
    {
      throw std::runtime_error(file_.string() + ": cannot be written");
    }
  }

  std::filesystem::path file_;
  std::ofstream stream_;
  bool is_begun_ = false;  ///< whether the present row has a cell
};
}  // namespace wheel_rail_contact::core
