// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/text/table_title.h"
#include "core/text/text_file.h"

namespace wheel_rail_contact::core
{
/// Row of a table.
struct TableRow
{
  std::size_t line = 0;            ///< its number, from 1
  std::vector<std::string> cells;  ///< without white space at their ends
};

/// Cells of a table in a text file, as spreadsheets and programs write it.
///
/// *Columns* are separated by semicolons, tabs, commas or white space: the first of these that divides titles and first
/// row into as many cells, or else the first that occurs. In a table of numbers, white space comes before tabs. A line
/// `sep=;` above the table names another one. Cells may be in quotation marks. *Comments* are lines that begin with #,
/// %, ! or //. *Head*: the rows above the first one with a number in a cell. If there are none: the comments above it
/// that have as many cells; if the table is not of numbers, the last two of them.
class CellTable
{
 public:
  /// Finds head and separator. Keeps a reference to `file`, which must outlive the table.
  /// @param of_numbers  each row has a number in every column, and a comment may follow it
  /// @throw FileError if the file contains only comments.
  CellTable(TextFile& file, bool of_numbers);

  const std::vector<TableRow>& head() const { return head_; }
  /// True if the head consists of comments.
  bool isHeadInComments() const { return head_in_comments_; }
  /// All comments, without their signs.
  const std::vector<std::string>& comments() const { return comments_; }
  std::size_t columns() const { return columns_; }
  /// Reads the next row. Rows without any content are omitted. Cells that the line does not have are empty.
  /// @return false after the last row
  /// @throw FileError if the row has too many cells; of numbers or between white space, also if it has too few.
  bool next(TableRow& row);
  /// Moves back to the first row.
  void rewind();

 private:
  struct Line
  {
    std::size_t number;
    std::string text;
  };

  void findSeparator(std::vector<Line>& lines);
  bool divide(const std::vector<Line>& lines, char separator, bool own_of_titles);
  std::string rowText() const;

  TextFile& file_;
  bool of_numbers_;
  char separator_ = ' ';  ///< ' ': white space
  std::size_t columns_ = 0;
  std::vector<std::string> comments_;
  std::vector<TableRow> head_;
  bool head_in_comments_ = false;
  std::size_t first_line_ = 0;  ///< number of the line of the first row
};

/// Titles of columns, with the units of a row of units below them.
struct TableTitles
{
  std::vector<TableTitle> titles;
  std::size_t row = 0;     ///< of the titles, from 0
  bool has_units = false;  ///< the next row contains units
};
/// Titles in a row, or in the one before it if it contains units: at least half of its cells do, of which one is known.
/// @throw FileError if a unit contradicts that of a title.
TableTitles titlesWithUnits(const TextFile& file, const std::vector<TableRow>& rows, std::size_t last, bool is_shape);

/// Table of numbers. *Titles* are the first line of the head, the second one may contain their units; or they are a
/// comment above the first row. A number may have a decimal comma where commas do not separate the columns.
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
  std::size_t columns() const { return cells_.columns(); }
  /// Reads the fields of the next row, with a decimal point.
  /// @return false after the last row
  /// @throw FileError if the row has another number of columns.
  bool next(std::vector<std::string>& fields);

 private:
  TextFile& file_;
  CellTable cells_;
  std::vector<TableTitle> titles_;
  std::size_t title_line_ = 0;
  std::size_t unknown_line_ = 0;  ///< line above the rows that contains neither titles nor units; 0: none
};
}  // namespace wheel_rail_contact::core
