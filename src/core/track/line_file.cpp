// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "core/profile/profile_file.h"
#include "core/track/line_station.h"
#include "wheel_rail_contact/core/track_line.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Largest difference from the nominal gauge [m]: a larger one is a deviation, or another unit.
constexpr double largest_widening = 0.2;

/// Quantities of a table.
enum Column
{
  x,
  gauge,
  alignment,
  alignment_left,
  alignment_right,
  level,
  level_left,
  level_right,
  cross_level,
  rail_lateral_left,
  rail_vertical_left,
  rail_roll_left,
  rail_lateral_right,
  rail_vertical_right,
  rail_roll_right,
  columns
};

struct ColumnRule
{
  const char* name;
  bool is_angle;
  double railway_sign;  ///< -1: its sign changes in railway axes
};

constexpr std::array<ColumnRule, columns> rules{{{"x", false, 1},
                                                 {"gauge", false, 1},
                                                 {"alignment", false, -1},
                                                 {"alignment_left", false, -1},
                                                 {"alignment_right", false, -1},
                                                 {"level", false, -1},
                                                 {"level_left", false, -1},
                                                 {"level_right", false, -1},
                                                 {"cross_level", false, 1},
                                                 {"rail_lateral_left", false, 1},
                                                 {"rail_vertical_left", false, -1},
                                                 {"rail_roll_left", true, 1},
                                                 {"rail_lateral_right", false, 1},
                                                 {"rail_vertical_right", false, -1},
                                                 {"rail_roll_right", true, 1}}};

const std::map<std::string, double> lengths{{"m", 1}, {"mm", 1e-3}, {"um", 1e-6}};
const std::map<std::string, double> angles{{"rad", 1}, {"mrad", 1e-3}, {"deg", 3.14159265358979323846 / 180}};

/// A row of the table in SI units and REP-103 axes; nothing where the column is missing.
using Row = std::array<std::optional<double>, columns>;

/// Table of a file, read line by line.
class LineFile
{
 public:
  LineFile(const std::string& path, LineAxes axes) : path_(path), stream_(path), axes_(axes)
  {
    if (!stream_)
    {
      throw std::invalid_argument(path + ": cannot be read");
    }
    if (!nextLine())
    {
      throw std::invalid_argument(path + ": is empty");
    }
    separator_ = *std::max_element(separators.begin(), separators.end(),
                                   [this](char one, char other) { return count(one) < count(other); });
    for (const std::string& title : splitFields(line_, separator_))
    {
      addColumn(title);
    }
    checkColumns();
  }

  /// Reads the next row. @return false at the end
  bool next(Row& row)
  {
    if (!nextLine())
    {
      return false;
    }
    const std::vector<std::string> fields = splitFields(line_, separator_);
    if (fields.size() != column_.size())
    {
      refuse("has " + std::to_string(fields.size()) + " values, must have " + std::to_string(column_.size()));
    }
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      const std::optional<double> value = parseNumber(fields[i]);
      if (!value)
      {
        refuse("column '" + std::string(rules[column_[i]].name) + "': '" + fields[i] + "' is not a finite number");
      }
      row[column_[i]] = *value * factor_[i];
    }
    return true;
  }

  [[noreturn]] void refuse(const std::string& reason) const
  {
    throw std::invalid_argument(path_ + ":" + std::to_string(number_) + ": " + reason);
  }

 private:
  static constexpr std::array<char, 3> separators{',', ';', '\t'};

  long count(char c) const { return std::count(line_.begin(), line_.end(), c); }

  bool nextLine()
  {
    while (std::getline(stream_, line_))
    {
      ++number_;
      if (number_ == 1 && line_.compare(0, 3, "\xEF\xBB\xBF") == 0)
      {
        line_.erase(0, 3);
      }
      if (!trim(line_).empty() && trim(line_)[0] != '#')
      {
        return true;
      }
    }
    return false;
  }

  void addColumn(const std::string& title)
  {
    const std::size_t open = title.find('['), close = title.find(']');
    if (open == std::string::npos || close != title.size() - 1)
    {
      refuse("column '" + title + "': must be a name with its unit, for example 'gauge [mm]'");
    }
    const std::string name = trim(title.substr(0, open)), unit = trim(title.substr(open + 1, close - open - 1));
    const auto rule = std::find_if(rules.begin(), rules.end(), [&](const ColumnRule& r) { return name == r.name; });
    if (rule == rules.end())
    {
      refuse("column '" + name + "': unknown quantity; valid names are " + validNames());
    }
    const auto column = static_cast<std::size_t>(rule - rules.begin());
    if (has(column))
    {
      refuse("column '" + name + "' is given twice");
    }
    const auto& units = rule->is_angle ? angles : lengths;
    const auto found = units.find(unit);
    if (found == units.end())
    {
      refuse("column '" + name + "': unknown unit '" + unit + "'; valid units are " +
             (rule->is_angle ? "rad, mrad, deg" : "m, mm, um"));
    }
    column_.push_back(column);
    factor_.push_back(found->second * (axes_ == LineAxes::railway ? rule->railway_sign : 1));
  }

  bool has(std::size_t column) const { return std::count(column_.begin(), column_.end(), column) > 0; }

  void checkColumns() const
  {
    if (!has(x))
    {
      refuse("column 'x' is missing");
    }
    const auto both = [this](std::size_t one, std::size_t other)
    {
      if (has(one) && has(other))
      {
        refuse(std::string("give either '") + rules[one].name + "' or '" + rules[other].name + "'");
      }
    };
    both(alignment, alignment_left);
    both(alignment, alignment_right);
    both(level, level_left);
    both(level, level_right);
    for (std::size_t track = gauge; track <= cross_level; ++track)
    {
      for (std::size_t rail = rail_lateral_left; rail < columns; ++rail)
      {
        both(track, rail);
      }
    }
  }

  static std::string validNames()
  {
    std::string names;
    for (const ColumnRule& rule : rules)
    {
      names += (names.empty() ? "" : ", ") + std::string(rule.name);
    }
    return names;
  }

  std::string path_;
  std::ifstream stream_;
  LineAxes axes_;
  std::string line_;
  std::size_t number_ = 0;
  char separator_ = ',';
  std::vector<std::size_t> column_;  ///< Column of each field
  std::vector<double> factor_;       ///< from its unit and axes to SI units and REP-103 axes
};

/// Mean and difference of a quantity of both rails, left and right, from what is given.
struct Pair
{
  double middle = 0, difference = 0;

  Pair(const std::optional<double>& mean, const std::optional<double>& left, const std::optional<double>& right,
       const std::optional<double>& given_difference)
  {
    difference = given_difference ? *given_difference : left && right ? *left - *right : 0;
    middle = mean            ? *mean
             : left && right ? 0.5 * (*left + *right)
             : left          ? *left - 0.5 * difference
             : right         ? *right + 0.5 * difference
                             : 0;
  }
};

LineStation stationOf(const Row& row, double nominal_gauge)
{
  const auto value = [&row](std::size_t column) { return row[column].value_or(0); };
  const auto widening = row[gauge] ? std::optional(*row[gauge] - nominal_gauge) : std::nullopt;
  const Pair lateral(row[alignment], row[alignment_left], row[alignment_right], widening);
  const Pair vertical(row[level], row[level_left], row[level_right], row[cross_level]);
  LineStation station;
  station.x = value(x);
  station.cross_level = vertical.difference;
  station.rail[0] = {lateral.middle + 0.5 * lateral.difference + value(rail_lateral_left),
                     vertical.middle + value(rail_vertical_left), value(rail_roll_left)};
  station.rail[1] = {-lateral.middle + 0.5 * lateral.difference + value(rail_lateral_right),
                     vertical.middle + value(rail_vertical_right), value(rail_roll_right)};
  return station;
}
}  // namespace

TrackLine readTrackLine(const std::string& path, double gauge_at_rest, LineAxes axes)
{
  LineFile file(path, axes);
  std::vector<LineStation> stations;
  Row row;
  while (file.next(row))
  {
    if (row[gauge] && !(std::abs(*row[gauge] - gauge_at_rest) <= largest_widening))
    {
      file.refuse("gauge = " + std::to_string(*row[gauge]) +
                  " m: must be the whole gauge, within 0.2 m of track/gauge");
    }
    stations.push_back(stationOf(row, gauge_at_rest));
    if (const std::string_view reason = fault(stations.back()); !reason.empty())
    {
      file.refuse(std::string(reason));
    }
    if (stations.size() > 1 && !(stations.back().x > stations[stations.size() - 2].x))
    {
      file.refuse("x must increase");
    }
  }
  return {path, stations};
}
}  // namespace wheel_rail_contact::core
