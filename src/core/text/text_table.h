// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/text/table_title.h"
#include "core/text/text_file.h"

namespace wheel_rail_contact::core
{
/// Table of numbers in a text file, as spreadsheets and programs write it.
///
/// *Columns* are separated by semicolons, tabs, commas or spaces. With another separator than the comma, numbers may
/// have a decimal comma. *Comments* begin with #, %, ! or //. *Titles* are the first line that is no comment, unless it
/// begins with a number; a line of units may follow. Titles may also be in a comment before the first row.
class TextTable
{
 public:
  /// Decides whether a line of comment contains the titles.
  using TitleRule = std::function<bool(const std::vector<TableTitle>&)>;

  /// Finds titles and separator. Keeps a reference to `file`, which must outlive the table.
  /// @throw FileError if the file contains only comments.
  TextTable(TextFile& file, const TitleRule& are_titles);

  /// Titles of the columns; empty if the file has none.
  const std::vector<TableTitle>& titles() const { return titles_; }
  /// Number of the line with the titles; 0 if there is none.
  std::size_t titleLine() const { return title_line_; }
  /// Number of columns.
  std::size_t columns() const { return columns_; }
  /// Reads the fields of the next row, with a decimal point.
  /// @return false after the last row
  /// @throw FileError if the row has another number of columns.
  bool next(std::vector<std::string>& fields);
  /// Number in a field of the current row.
  /// @param column  its name in the message; empty: not named
  /// @throw FileError if it is not a finite number.
  double number(const std::string& field, const std::string& column = "") const;

 private:
  struct Line
  {
    std::size_t number;
    std::string text;
  };

  std::optional<Line> nextLine(std::vector<Line>& comments);
  void takeTitles(const Line& line);
  bool takeUnits(const Line& line);
  void takeFirstRow(const Line& line);
  void takeComment(const std::vector<Line>& comments, const TitleRule& are_titles);
  std::vector<std::string> fieldsOf(const std::string& line) const;

  TextFile& file_;
  char separator_ = ' ';  ///< ' ': white space
  std::size_t columns_ = 0;
  std::vector<TableTitle> titles_;
  std::size_t title_line_ = 0;
  std::optional<Line> row_;  ///< the first row, until it has been read
};
}  // namespace wheel_rail_contact::core
