// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "core/profile/profile_file.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Length unit of the columns [m]; nothing if the line states none.
std::optional<double> statedUnit(const std::string& line)
{
  const std::vector<std::string> fields = splitFields(line[0] == '#' ? trim(line.substr(1)) : line);
  // Text after the second name, separated by white space, is a comment.
  const std::string second = fields.size() > 1 ? fields[1].substr(0, fields[1].find_first_of(" \t")) : "";
  if (fields[0] == "y_mm" && second == "z_mm")
  {
    return 1e-3;
  }
  if (fields[0] == "y_m" && second == "z_m")
  {
    return 1.0;
  }
  return std::nullopt;
}

SampledPoint pointOf(const ProfileFile& file, double unit)
{
  const std::vector<std::string> fields = splitFields(file.line());
  if (fields.size() != 2)
  {
    file.refuse("number of columns is " + std::to_string(fields.size()) + ", must be 2");
  }
  const auto value_of = [&](const std::string& field)
  {
    const std::optional<double> value = parseNumber(field);
    if (!value)
    {
      file.refuse("'" + field + "' is not a number");
    }
    return *value * unit;
  };
  return {value_of(fields[0]), value_of(fields[1])};
}
}  // namespace

FileProfile readCsv(ProfileFile& file)
{
  FileProfile content;
  std::optional<double> unit;
  while (file.next())
  {
    if (file.line().empty())
    {
      continue;
    }
    if (!unit)
    {
      unit = statedUnit(file.line());
      if (!unit)
      {
        file.refuse("no unit stated: the first line must be y_mm,z_mm or y_m,z_m");
      }
    }
    else if (file.line()[0] != '#')
    {
      addPoint(file, content, pointOf(file, *unit));
    }
  }
  return content;
}

FileProfile readTwoColumns(ProfileFile& file)
{
  FileProfile content;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  while (file.next())
  {
    const std::vector<std::string> words = splitWords(file.line().substr(0, file.line().find('%')));
    if (words.empty())
    {
      continue;
    }
    const std::optional<double> y = parseNumber(words[0]), z = words.size() == 2 ? parseNumber(words[1]) : std::nullopt;
    if (!y || !z)
    {
      file.refuse("must contain two numbers");
    }
    least = std::min(least, *y);
    most = std::max(most, *y);
    addPoint(file, content, {*y, -*z});
  }
  const double unit = most - least < 1 ? 1 : 1e-3;
  for (FilePoint& point : content.points)
  {
    point.point.y *= unit;
    point.point.z *= unit;
  }
  return content;
}
}  // namespace wheel_rail_contact::core
