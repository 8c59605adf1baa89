// SPDX-License-Identifier: BSD-3-Clause
#include "core/text/text_table.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
bool isLoneNumber(const std::string& line)
{
  return line.find_first_not_of("0123456789") == std::string::npos;
}

bool beginsWithNumber(const std::string& line)
{
  return parseNumber(withPoint(line.substr(0, line.find_first_of("; \t")))) ||
         parseNumber(line.substr(0, line.find_first_of(",; \t")));
}
}  // namespace

TextTable::TextTable(TextFile& file, const TitleRule& are_titles) : file_(file)
{
  std::vector<Line> comments;
  std::optional<Line> line = nextLine(comments);
  if (!line)
  {
    file_.refuse(0, "is empty");
  }
  // Spreadsheets write the separator in a line of its own, other programs the number of rows.
  if (line->text.compare(0, 4, "sep=") == 0 || isLoneNumber(line->text))
  {
    line = nextLine(comments);
  }
  const bool has_titles = line && !beginsWithNumber(line->text);
  if (has_titles)
  {
    takeTitles(*line);
    line = nextLine(comments);
    if (line && takeUnits(*line))
    {
      line = nextLine(comments);
    }
  }
  if (line)
  {
    takeFirstRow(*line);
  }
  if (!has_titles)
  {
    takeComment(comments, are_titles);
  }
}

/// Next line that is no comment; nothing at the end. Comments before it are added to `comments`.
std::optional<TextTable::Line> TextTable::nextLine(std::vector<Line>& comments)
{
  while (file_.next())
  {
    const std::string text = withoutComment(file_.line());
    if (!text.empty())
    {
      return Line{file_.number(), text};
    }
    if (!file_.line().empty())
    {
      comments.push_back({file_.number(), withoutCommentSign(file_.line())});
    }
  }
  return std::nullopt;
}

void TextTable::takeTitles(const Line& line)
{
  titles_ = titlesIn(line.text);
  title_line_ = line.number;
  columns_ = titles_.size();
}

/// Takes the units of the titles from a line of units. @return false if it is none
bool TextTable::takeUnits(const Line& line)
{
  const std::vector<TableTitle> units = titlesIn(line.text);
  const auto unit_of = [](const TableTitle& title) { return title.name.empty() ? title.unit : title.name; };
  const bool are_units = units.size() == columns_ &&
                         std::all_of(units.begin(), units.end(),
                                     [&](const TableTitle& title)
                                     { return isUnit(unit_of(title)) && (title.name.empty() || title.unit.empty()); });
  for (std::size_t i = 0; are_units && i < columns_; ++i)
  {
    if (!titles_[i].unit.empty() && titles_[i].unit != unit_of(units[i]))
    {
      file_.refuse(line.number, "unit '" + unit_of(units[i]) + "' contradicts '" + titles_[i].unit + "' in the title");
    }
    titles_[i].unit = unit_of(units[i]);
  }
  return are_units;
}

/// Finds the separator: the first one by which the row has as many columns as there are titles, or at least two without
/// titles. White space separates only numbers.
void TextTable::takeFirstRow(const Line& line)
{
  row_ = line;
  for (const char separator : {';', ' ', '\t', ','})
  {
    const std::vector<std::string> fields = splitAt(line.text, separator);
    const auto is_number = [&](const std::string& field)
    { return parseNumber(separator == ',' ? field : withPoint(field)).has_value(); };
    const auto numbers = static_cast<std::size_t>(std::count_if(fields.begin(), fields.end(), is_number));
    const bool enough = separator == ' ' ? numbers == fields.size() : numbers > 0;
    const bool fits = enough && (columns_ > 0 ? fields.size() == columns_ : fields.size() > 1);
    if (fits)
    {
      separator_ = separator;
      columns_ = fields.size();
      return;
    }
  }
  separator_ = line.text.find(',') != std::string::npos ? ',' : ' ';
  columns_ = columns_ > 0 ? columns_ : splitAt(line.text, separator_).size();
}

void TextTable::takeComment(const std::vector<Line>& comments, const TitleRule& are_titles)
{
  for (auto line = comments.rbegin(); line != comments.rend(); ++line)
  {
    const std::vector<TableTitle> titles = titlesIn(line->text);
    if (titles.size() == columns_ && are_titles(titles))
    {
      titles_ = titles;
      title_line_ = line->number;
      return;
    }
  }
}

std::vector<std::string> TextTable::fieldsOf(const std::string& line) const
{
  std::vector<std::string> fields = splitAt(line, separator_, columns_);
  if (separator_ != ',')
  {
    std::transform(fields.begin(), fields.end(), fields.begin(), withPoint);
  }
  return fields;
}

bool TextTable::next(std::vector<std::string>& fields)
{
  std::vector<Line> comments;
  const std::optional<Line> line = row_ ? std::exchange(row_, std::nullopt) : nextLine(comments);
  if (!line)
  {
    return false;
  }
  fields = fieldsOf(line->text);
  if (fields.size() != columns_)
  {
    const bool decimal_commas = separator_ == ',' && fields.size() == 2 * columns_;
    file_.refuse(line->number,
                 "number of columns is " + std::to_string(fields.size()) + ", must be " + std::to_string(columns_) +
                     (decimal_commas ? "; with decimal commas, columns must be separated by semicolons" : ""));
  }
  return true;
}

double TextTable::number(const std::string& field, const std::string& column) const
{
  const std::optional<double> value = parseNumber(field);
  if (!value)
  {
    file_.refuse((column.empty() ? "" : "column '" + column + "': ") + "'" + field + "' is not a finite number");
  }
  return *value;
}
}  // namespace wheel_rail_contact::core
