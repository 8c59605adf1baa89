// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/track.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "core/option_check.h"
#include "core/profile/curve/monotone_cubic.h"
#include "core/text/text_table.h"

namespace wheel_rail_contact::core
{
namespace
{
// Far wider than on real tracks and wheelsets, but without a usual length in millimetres.
constexpr LengthRange gauges{0.2, 3};  ///< and flange back distances
constexpr LengthRange gauge_depths{1e-5, 0.1};
constexpr LengthRange rolling_radii{0.05, 2};
constexpr LengthRange tape_circles{0.005, 0.5};

constexpr double largest_value = 0.2;  ///< of a cross level or displacement [m], [rad]

/// Reason why the values of a station are refused; empty if they are finite and not above 0.2 m or 0.2 rad.
std::string_view fault(const LineStation& station)
{
  const auto valid = [](double value) { return std::abs(value) <= largest_value; };
  const auto placed = [&valid](const RailDeflection& rail)
  { return valid(rail.lateral) && valid(rail.vertical) && valid(rail.roll); };
  const bool all = valid(station.cross_level) && placed(station.rail.left) && placed(station.rail.right);
  return all ? std::string_view() : "a cross level or displacement is above 0.2 m or 0.2 rad";
}

/// Largest difference from the nominal gauge [m]: a larger one is a deviation, or another unit.
constexpr double largest_widening = 0.2;
constexpr std::size_t largest_file = std::size_t{256} << 20U;  ///< of a line of some thousand kilometres [bytes]

/// Quantities of a table.
enum Quantity
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

/// A row of the table in SI units and REP-103 axes; nothing where the column is missing.
using Row = std::array<std::optional<double>, columns>;

/// Table of a file, row by row.
class LineFile
{
 public:
  LineFile(const std::string& path, LineAxes axes) : file_(path, largest_file), table_(file_, areTitles), axes_(axes)
  {
    file_.refuseIf(table_.titles().empty(), 0,
                   "has no titles of columns with their units, for example 'x [m], gauge [mm]'");
    for (const TableTitle& title : table_.titles())
    {
      addColumn(title);
    }
    checkColumns();
  }

  /// Reads the next row. @return false at the end
  bool next(Row& row)
  {
    if (!table_.next(fields_))
    {
      return false;
    }
    for (std::size_t i = 0; i < fields_.size(); ++i)
    {
      row[column_[i]] = file_.numberIn(fields_[i], rules[column_[i]].name) * factor_[i];
    }
    return true;
  }

  [[noreturn]] void refuse(const std::string& reason) const { file_.refuse(reason); }

 private:
  static bool areTitles(const std::vector<TableTitle>& titles)
  {
    return std::any_of(titles.begin(), titles.end(),
                       [](const TableTitle& title) { return title.name == rules[x].name; });
  }

  void refuseTitlesIf(bool fault, const std::string& reason) const
  {
    file_.refuseIf(fault, table_.titleLine(), reason);
  }

  void addColumn(const TableTitle& title)
  {
    const auto rule =
        std::find_if(rules.begin(), rules.end(), [&](const ColumnRule& r) { return title.name == r.name; });
    refuseTitlesIf(rule == rules.end(),
                   "column '" + title.name + "': unknown quantity; valid names are " + validNames());
    const auto column = static_cast<std::size_t>(rule - rules.begin());
    refuseTitlesIf(has(column), "column '" + title.name + "' is given twice");
    refuseTitlesIf(title.unit.empty(), "column '" + title.name + "': must have a unit, for example '" + title.name +
                                           (rule->is_angle ? " [mrad]'" : " [mm]'"));
    const std::optional<double> unit = unitNamed(rule->is_angle ? angleUnits() : lengthUnits(), title.unit);
    refuseTitlesIf(!unit, "column '" + title.name + "': unknown unit '" + title.unit + "'; valid units are " +
                              (rule->is_angle ? "rad, mrad, deg" : "m, cm, mm, um, in"));
    column_.push_back(column);
    factor_.push_back(*unit * (axes_ == LineAxes::railway ? rule->railway_sign : 1));
  }

  bool has(std::size_t column) const { return std::count(column_.begin(), column_.end(), column) > 0; }

  void checkColumns() const
  {
    refuseTitlesIf(!has(x), "column 'x' is missing");
    const auto both = [this](std::size_t one, std::size_t other)
    {
      refuseTitlesIf(has(one) && has(other),
                     std::string("give either '") + rules[one].name + "' or '" + rules[other].name + "'");
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

  TextFile file_;
  TextTable table_;
  LineAxes axes_;
  std::vector<std::string> fields_;
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
  station.rail.left = {lateral.middle + 0.5 * lateral.difference + value(rail_lateral_left),
                       vertical.middle + value(rail_vertical_left), value(rail_roll_left)};
  station.rail.right = {-lateral.middle + 0.5 * lateral.difference + value(rail_lateral_right),
                        vertical.middle + value(rail_vertical_right), value(rail_roll_right)};
  return station;
}

std::vector<LineStation> stationsOf(LineFile& file, double gauge_at_rest)
{
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
  return stations;
}
}  // namespace

void validate(const TrackConfig& track)
{
  requireLength("track/gauge", track.gauge, gauges);
  requireLength("track/gauge_depth", track.gauge_depth, gauge_depths);
  for (const Side side : sides)
  {
    requireWithin(optionOf(track.rail_inclination, side, "track/rail_inclination", "rail", "inclination"),
                  track.rail_inclination[side], 0.2, "must be within ±0.2 rad");
  }
}

void validate(const WheelsetConfig& wheelset)
{
  for (const Side side : sides)
  {
    requireLength(optionOf(wheelset.rolling_radius, side, "wheelset/rolling_radius", "wheel", "rolling_radius"),
                  wheelset.rolling_radius[side], rolling_radii);
  }
  requireLength("wheelset/flange_back_distance", wheelset.flange_back_distance, gauges);
  requireLength("wheelset/tape_circle", wheelset.tape_circle, tape_circles);
}

TrackLine::Quantities TrackLine::quantitiesOf(const LineStation& station)
{
  const RailDeflection &left = station.rail.left, &right = station.rail.right;
  return {station.cross_level, left.lateral, left.vertical, left.roll, right.lateral, right.vertical, right.roll};
}

TrackLine::TrackLine(std::string name, const std::vector<LineStation>& stations) : name_(std::move(name))
{
  const auto require = [this](std::size_t station, std::string_view reason)
  {
    if (!reason.empty())
    {
      throw std::invalid_argument(name_ + ": station " + std::to_string(station + 1) + ": " + std::string(reason));
    }
  };
  refuseIf(stations.size() < 2, name_ + ": a line needs at least two stations");
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    x_.push_back(stations[i].x);
    values_.push_back(quantitiesOf(stations[i]));
    require(i, std::isfinite(x_[i]) && (i == 0 || x_[i] > x_[i - 1]) ? "" : "x must increase");
    require(i, fault(stations[i]));
  }
  slopes_.resize(x_.size());
  for (std::size_t k = 0; k < quantities; ++k)
  {
    const auto rise = [&](std::size_t i) { return (values_[i + 1][k] - values_[i][k]) / (x_[i + 1] - x_[i]); };
    const std::size_t last = x_.size() - 1;
    slopes_.front()[k] = rise(0);
    slopes_.back()[k] = rise(last - 1);
    for (std::size_t i = 1; i < last; ++i)
    {
      slopes_[i][k] = monotoneSlope(rise(i - 1), rise(i), x_[i] - x_[i - 1], x_[i + 1] - x_[i]);
    }
  }
}

LineStation TrackLine::at(double x) const
{
  const auto after = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto i = static_cast<std::size_t>(after - x_.begin());
  const double t = x - x_[i - 1];
  Quantities q;
  for (std::size_t k = 0; k < quantities; ++k)
  {
    double c[4];
    setCubic(values_[i - 1][k], values_[i][k], slopes_[i - 1][k], slopes_[i][k], x_[i] - x_[i - 1], c);
    q[k] = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
  }
  return {x, q[0], {RailDeflection{q[1], q[2], q[3]}, RailDeflection{q[4], q[5], q[6]}}};
}

TrackLine readTrackLine(const std::string& path, double gauge_at_rest, LineAxes axes)
{
  try
  {
    LineFile file(path, axes);
    return {path, stationsOf(file, gauge_at_rest)};
  }
  catch (const FileError& error)
  {
    throw std::invalid_argument(error.what());
  }
}
}  // namespace wheel_rail_contact::core
