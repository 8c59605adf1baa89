// SPDX-License-Identifier: BSD-3-Clause
#include "core/text/text_table.h"

#include <algorithm>

#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::size_t longest_head = 100;  ///< [lines] without comments

bool isNumber(const std::string& cell)
{
  return parseNumber(withPoint(cell)).has_value();
}

/// Number of cells up to the last one that is not empty.
std::size_t filled(const std::vector<std::string>& cells)
{
  const auto last = std::find_if(cells.rbegin(), cells.rend(), [](const std::string& cell) { return !cell.empty(); });
  return static_cast<std::size_t>(cells.rend() - last);
}
}  // namespace

CellTable::CellTable(TextFile& file, bool of_numbers) : file_(file), of_numbers_(of_numbers)
{
  std::vector<Line> lines, comments;
  while (file_.next())
  {
    const Line line{file_.number(), rowText()};
    if (line.text.empty() && !file_.line().empty())
    {
      comments_.push_back(withoutCommentSign(file_.line()));
      comments.push_back({line.number, comments_.back()});
    }
    else if (lines.size() < longest_head && !trim(line.text).empty())
    {
      lines.push_back(line);
    }
  }
  file_.refuseIf(lines.empty(), 0, "is empty");
  findSeparator(lines);
  head_in_comments_ = head_.empty();
  for (const Line& comment : comments)
  {
    std::vector<std::string> cells = splitCells(comment.text, of_numbers_ ? separatorIn(comment.text) : separator_);
    cells.resize(filled(cells));
    if (head_in_comments_ && comment.number < first_line_ && cells.size() == columns_)
    {
      head_.push_back({comment.number, cells});
    }
  }
  // Names, and perhaps their units: other comments are above them. TextTable recognises its titles.
  if (head_in_comments_ && !of_numbers_ && head_.size() > 2)
  {
    head_.erase(head_.begin(), head_.end() - 2);
  }
  rewind();
}

void CellTable::findSeparator(std::vector<Line>& lines)
{
  std::string separators = of_numbers_ ? "; \t," : ";\t, ";  // numbers may be between tabs and blanks
  // Spreadsheets write the separator in a line of its own, other programs the number of rows.
  const std::string first = lines.front().text.substr(lines.front().text.find_first_not_of(' '));
  const bool names_separator = first.size() > 4 && first.compare(0, 4, "sep=") == 0 && first[4] > 0;
  if (lines.size() > 1 && (names_separator || trim(first).find_first_not_of("0123456789") == std::string::npos))
  {
    separators = names_separator ? first.substr(4, 1) : separators;
    lines.erase(lines.begin());
  }
  const auto divides = [&](bool own_of_titles)
  {
    return std::any_of(separators.begin(), separators.end(),
                       [&](char separator) { return divide(lines, separator, own_of_titles); });
  };
  if (!divides(false) && !(of_numbers_ && divides(true)))
  {
    divide(lines, separators.size() > 1 ? separatorIn(lines.front().text) : separators.front(), false);
  }
}

/// Divides head and first row.
/// @param own_of_titles  each line of the head is divided by the separator that occurs in it
/// @return false if titles and first row do not have as many cells
bool CellTable::divide(const std::vector<Line>& lines, char separator, bool own_of_titles)
{
  separator_ = separator;
  head_.clear();
  first_line_ = lines.back().number + 1;
  std::vector<std::string> row;
  for (const Line& line : lines)
  {
    row = splitCells(line.text, separator);
    if (std::any_of(row.begin(), row.end(), isNumber))
    {
      first_line_ = line.number;
      break;
    }
    head_.push_back({line.number, own_of_titles ? splitCells(line.text, separatorIn(line.text)) : row});
    head_.back().cells.resize(of_numbers_ ? filled(head_.back().cells) : head_.back().cells.size());
  }
  row.resize(head_.empty() ? filled(row) : row.size());
  const bool are_numbers = std::all_of(row.begin(), row.end(), isNumber);
  if (head_.empty())
  {
    columns_ = row.size();
    return columns_ > 1 && are_numbers;
  }
  const std::vector<std::string>& titles = head_.back().cells;
  // A row of units may be shorter than that of the names.
  const std::size_t above = head_.size() > 1 && separator != ' ' ? head_[head_.size() - 2].cells.size() : 0;
  columns_ = std::max(titles.size(), above);
  const bool has_row = first_line_ <= lines.back().number && (are_numbers || !of_numbers_ || separator != ' ');
  return has_row && titles.size() > 1 && filled(titles) <= row.size() && filled(row) <= titles.size();
}

/// Current line as a row; empty if it is a comment.
std::string CellTable::rowText() const
{
  const std::string text = withoutComment(file_.wholeLine());
  return of_numbers_ || (text.empty() && file_.line().compare(0, 4, "#N/A") != 0) ? text : file_.wholeLine();
}

bool CellTable::next(TableRow& row)
{
  while (file_.next())
  {
    row = {file_.number(), splitCells(rowText(), separator_)};
    const std::size_t count = filled(row.cells);
    if (count == 0)
    {
      continue;
    }
    file_.refuseIf(
        std::any_of(row.cells.begin(), row.cells.end(), [](const std::string& cell) { return cell[0] == '"'; }),
        "a quotation mark is not closed at the end of a cell");
    if (count > columns_ || (row.cells.size() < columns_ && (of_numbers_ || separator_ == ' ')))
    {
      const std::string hint =
          separator_ == ',' && count == 2 * columns_ ? "; with decimal commas, columns must be separated by semicolons"
          : separator_ == ' ' && count < columns_    ? "; with empty cells, columns must be separated by semicolons"
                                                     : "";
      file_.refuse("number of columns is " + std::to_string(count) + ", must be " + std::to_string(columns_) + hint);
    }
    row.cells.resize(columns_);
    return true;
  }
  return false;
}

void CellTable::rewind()
{
  file_.rewind();
  while (file_.number() + 1 < first_line_ && file_.next())
  {
  }
}

TableTitles titlesWithUnits(const TextFile& file, const std::vector<TableRow>& rows, std::size_t last, bool is_shape)
{
  const std::vector<std::string>& cells = rows[last].cells;
  const auto filled = [](const std::vector<std::string>& row)
  { return std::count_if(row.begin(), row.end(), [](const std::string& cell) { return !bareUnit(cell).empty(); }); };
  const std::ptrdiff_t filled_cells = filled(cells);
  std::ptrdiff_t known = 0, alike = 0;
  for (const std::string& cell : cells)
  {
    const std::string unit = bareUnit(cell);
    known += unitNamed(unit) != nullptr ? 1 : 0;
    alike += unitNamed(unit) != nullptr || unit.find('/') != std::string::npos ? 1 : 0;
  }
  const bool are_units =
      last > 0 && known > 0 && 2 * alike >= filled_cells && filled(rows[last - 1].cells) >= filled_cells;
  TableTitles result{{}, are_units ? last - 1 : last, are_units};
  const std::vector<std::string>& texts = rows[result.row].cells;
  result.titles = titlesIn(texts, is_shape);
  for (std::size_t i = 0; are_units && i < std::min(cells.size(), texts.size()); ++i)
  {
    TableTitle& title = result.titles[i];
    const std::string below = bareUnit(cells[i]);
    const NamedUnit *own = unitNamed(title.unit), *unit = unitNamed(below);
    if (below.empty() || below == "-" || (own != nullptr && own == unit))
    {
      continue;
    }
    file.refuseIf(own != nullptr && unit != nullptr, rows[last].line,
                  "unit '" + below + "' contradicts '" + title.unit + "' in the title");
    title = {title.unit.empty() || title.unit == below ? title.name : texts[i], below};
  }
  return result;
}

TextTable::TextTable(TextFile& file, const TitleRule& are_titles) : file_(file), cells_(file, true)
{
  const std::vector<TableRow>& head = cells_.head();
  if (!cells_.isHeadInComments())
  {
    const TableTitles below = titlesWithUnits(file_, head, head.size() > 1 ? 1 : 0, true);
    titles_ = below.has_units ? below.titles : titlesIn(head.front().cells, true);
    title_line_ = head.front().line;
    const std::size_t known = below.has_units ? 2 : 1;
    unknown_line_ = head.size() > known ? head[known].line : 0;
    return;
  }
  const auto row = std::find_if(head.rbegin(), head.rend(),
                                [&](const TableRow& comment) { return are_titles(titlesIn(comment.cells, true)); });
  if (row != head.rend())
  {
    titles_ = titlesIn(row->cells, true);
    title_line_ = row->line;
  }
}

bool TextTable::next(std::vector<std::string>& fields)
{
  file_.refuseIf(unknown_line_ > 0, unknown_line_, "is neither a row of numbers nor, below the titles, of units");
  TableRow row;
  const bool is_row = cells_.next(row);
  fields = std::move(row.cells);
  std::transform(fields.begin(), fields.end(), fields.begin(), withPoint);
  return is_row;
}
}  // namespace wheel_rail_contact::core
