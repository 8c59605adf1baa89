// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/profile/files/content.h"
#include "core/text/text_table.h"
#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Names of the two coordinates: across and up. With all of x, y and z, x is along the track.
constexpr std::array<std::array<const char*, 2>, 6> names{
    {{"y", "z"}, {"x", "y"}, {"x", "z"}, {"lateral", "vertical"}, {"horizontal", "vertical"}, {"width", "height"}}};

struct Columns
{
  std::size_t y = none, z = none;
};

Columns columnsOf(const std::vector<TableTitle>& titles)
{
  const auto column_of = [&titles](const char* name)
  {
    const auto found = std::find_if(titles.begin(), titles.end(),
                                    [&](const TableTitle& title) { return lowerCase(title.name) == name; });
    return found == titles.end() ? none : static_cast<std::size_t>(found - titles.begin());
  };
  for (const auto& pair : names)
  {
    const Columns columns{column_of(pair[0]), column_of(pair[1])};
    if (columns.y != none && columns.z != none)
    {
      return columns;
    }
  }
  return {};
}

/// True if a comment is the line of titles: it names both columns with their unit.
bool areTitles(const std::vector<TableTitle>& titles)
{
  const Columns columns = columnsOf(titles);
  return columns.y != none && !titles[columns.y].unit.empty();
}

/// Unit of the two columns [m]; nothing if none is stated.
std::optional<double> unitOf(const TextFile& file, const TextTable& table, const Columns& columns)
{
  const std::string &y = table.titles()[columns.y].unit, &z = table.titles()[columns.z].unit;
  file.refuseIf(y != z, table.titleLine(), "units of the two columns, '" + y + "' and '" + z + "', must be the same");
  if (y.empty())
  {
    return std::nullopt;
  }
  const NamedUnit* unit = unitNamed(y, "length");
  file.refuseIf(unit == nullptr, table.titleLine(), "unit '" + y + "' must be m, cm, mm, um or in");
  return unit->value;
}

/// @throw FileError if a title of y or z occurs twice: which of the two rails of a file is meant?
void checkTitles(const TextFile& file, const TextTable& table, const Columns& columns)
{
  for (std::size_t i = 0; i < table.titles().size(); ++i)
  {
    for (const std::size_t column : {columns.y, columns.z})
    {
      file.refuseIf(i != column && lowerCase(table.titles()[i].name) == lowerCase(table.titles()[column].name),
                    table.titleLine(), "column '" + table.titles()[i].name + "' is given twice");
    }
  }
}

/// Reads the titles. @return the columns of y and z
Columns readTitles(const TextFile& file, const TextTable& table, FileProfile& content)
{
  if (table.titles().empty())
  {
    file.refuseIf(table.columns() != 2, 0,
                  std::to_string(table.columns()) +
                      " columns without titles: a line of titles must name y and z, for example y_mm,z_mm");
    return {0, 1};
  }
  const Columns columns = columnsOf(table.titles());
  file.refuseIf(columns.y == none, table.titleLine(),
                "is neither a comment nor a row of numbers nor titles of columns y and z, such as y_mm,z_mm");
  checkTitles(file, table, columns);
  content.unit = unitOf(file, table, columns);
  content.unit_in_file = content.unit.has_value();
  content.y = ProfileReading::Y::outward;
  content.z = ProfileReading::Z::up;
  for (std::size_t i = 0; i < table.titles().size(); ++i)
  {
    if (i != columns.y && i != columns.z)
    {
      content.remark += (content.remark.empty() ? "ignored column " : ", ") + table.titles()[i].name;
    }
  }
  return columns;
}
}  // namespace

bool namesCoordinates(const std::string& line)
{
  const std::string titles = withoutCommentSign(line);
  return areTitles(titlesIn(splitCells(titles, separatorIn(titles)), true));
}

FileProfile readProfileTable(TextFile& file)
{
  FileProfile content;
  TextTable table(file, areTitles);
  const Columns columns = readTitles(file, table, content);
  std::vector<std::string> fields;
  while (table.next(fields))
  {
    const std::string& z = fields[columns.z];
    addPoint(file, content, {file.numberIn(fields[columns.y]), file.numberIn(z)}, z);
  }
  return content;
}
}  // namespace wheel_rail_contact::core
