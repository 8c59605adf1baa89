// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/line_rows.h"

#include <algorithm>
#include <cmath>

#include "core/text/formatted.h"
#include "core/text/table_title.h"

namespace wheel_rail_contact::core
{
using namespace line_quantity;

namespace
{
/// Largest change between two stations: slope [-], and change of any two [share of the gauge], far above those of real
/// track (1:20 on the worst one, steps of a millimetre). A larger one is a filler for a missing value, or a fault.
constexpr double steepest = 0.1, step_share = 0.003;
constexpr double least_filler = 0.005;     ///< change to a value of nines from which it is a filler [m], [rad]
constexpr double cant_base = 1.5 / 1.435;  ///< length over which the cant is measured, over the gauge (EN 13803)
constexpr double least_contained = 0.02;   ///< cross level that may be the cant [m]

/// Mean and difference of a quantity of both rails, left and right, from what is given.
struct PairOfRails
{
  double middle = 0, difference = 0;

  PairOfRails(const std::optional<double>& mean, const std::optional<double>& left, const std::optional<double>& right,
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

/// Refuses a cross level that contains the cant: most of what is large of it would be a deviation from it.
void checkCrossLevel(const std::vector<LineRow>& rows, const TextFile& file)
{
  double large = 0, beside = 0, most = 0;  // sums; of a row [m]
  const LineRow* worst = nullptr;
  for (const LineRow& row : rows)
  {
    const double whole = row.value[cross_level].value_or(0), of_design = row.value[cant].value_or(0);
    if (std::abs(whole) > least_contained)
    {
      large += std::abs(whole);
      beside += std::abs(whole - of_design);
      worst = std::abs(whole) > most ? &row : worst;
      most = std::max(most, std::abs(whole));
    }
  }
  if (worst != nullptr && beside < 0.5 * large)
  {
    file.refuse(worst->line,
                formatted("cross_level is %.4g mm and cant %.4g mm: beside a column 'cant', the cross level "
                          "is the deviation from it",
                          1e3 * *worst->value[cross_level], 1e3 * worst->value[cant].value_or(0)));
  }
}
}  // namespace

LineStation stationOf(const LineRow& row, double nominal_gauge)
{
  const auto value = [&row](std::size_t column) { return row.value[column].value_or(0); };
  const PairOfRails lateral(row.value[alignment], row.value[alignment_left], row.value[alignment_right],
                            row.value[gauge]);
  const PairOfRails vertical(row.value[level], row.value[level_left], row.value[level_right], row.value[cross_level]);
  LineStation station;
  station.x = value(x);
  station.cross_level = vertical.difference;
  station.rail.left = {lateral.middle + 0.5 * lateral.difference + value(rail_lateral_left),
                       vertical.middle + value(rail_vertical_left), value(rail_roll_left)};
  station.rail.right = {-lateral.middle + 0.5 * lateral.difference + value(rail_lateral_right),
                        vertical.middle + value(rail_vertical_right), value(rail_roll_right)};
  station.design = {value(curvature), std::asin(std::clamp(value(cant) / (cant_base * nominal_gauge), -1.0, 1.0)),
                    value(gradient)};
  return station;
}

bool isDeviation(std::vector<LineRow>& rows, double nominal, const TextFile& file)
{
  if (rows.empty() || !rows.front().value[gauge])
  {
    return false;
  }
  const bool is_deviation = std::abs(*rows.front().value[gauge]) < 0.5 * nominal;
  for (LineRow& row : rows)
  {
    double& value = *row.value[gauge];
    if (!(std::abs(value - (is_deviation ? 0 : nominal)) <= largest_line_value))
    {
      file.refuse(row.line, "gauge = " + std::to_string(value) +
                                " m: must be the whole gauge, within 0.2 m of track/gauge" +
                                ", or in all rows the deviation from it");
    }
    value -= is_deviation ? 0 : nominal;
  }
  return is_deviation;
}

void checkValues(const std::vector<LineRow>& rows, double nominal_gauge, const TextFile& file)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const LineRow &row = rows[i], &before = rows[i > 0 ? i - 1 : 0];
    const double distance = *row.value[x] - *before.value[x];
    for (std::size_t column = gauge; column < columns; ++column)
    {
      const double value = row.value[column].value_or(0), change = value - before.value[column].value_or(0);
      const bool is_large = std::abs(value) > largest_line_value;
      const bool is_filler = std::abs(change) > least_filler &&
                             ((row.nines[column] && std::abs(change) > 0.5 * std::abs(value)) ||
                              (before.nines[column] && std::abs(change) > 0.5 * std::abs(change - value)));
      const bool is_steep = column != curvature && std::abs(change) > steepest * distance + step_share * nominal_gauge;
      if (is_large || is_filler || is_steep)
      {
        file.refuse(row.line,
                    formatted("column '%s': %s %.4g %s%s: another unit%s, or a filler for a missing value, "
                              "which must be an empty cell",
                              line_columns[column].name, is_large ? "a value of" : "a change by",
                              is_large ? value : change, unitKind(line_columns[column].kind).units.front().name,
                              is_large ? "" : formatted(" within %.4g m", distance).c_str(),
                              column == curvature ? ", the radius" : ""));
      }
    }
  }
  checkCrossLevel(rows, file);
}

bool isReversed(std::vector<LineRow>& rows, const TextFile& file)
{
  const bool reversed = rows.size() > 1 && *rows.front().value[x] > *rows.back().value[x];
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    const double step = *rows[i].value[x] - *rows[i - 1].value[x];
    const bool is_design = std::any_of(rows[i].value.begin() + curvature, rows[i].value.end(),
                                       [](const std::optional<double>& value) { return value.has_value(); });
    file.refuseIf(step == 0 && is_design, rows[i].line,
                  "a second row at this x: a design has one curvature, cant and gradient at each place, the end of one "
                  "element and begin of the next; a step of the curvature is a short clothoid");
    file.refuseIf(!(reversed ? step < 0 : step > 0), rows[i].line,
                  reversed ? "x must decrease, as from the first row to the last" : "x must increase");
  }
  if (reversed)
  {
    std::reverse(rows.begin(), rows.end());
  }
  return reversed;
}

std::string designText(const std::vector<LineRow>& rows)
{
  double most = 0;
  for (const LineRow& row : rows)
  {
    const double curve = row.value[curvature].value_or(0);
    most = std::abs(curve) > std::abs(most) ? curve : most;
  }
  const char* side = most > 0 ? "left" : "right";
  return most == 0 ? "" : formatted("; smallest radius %.4g m, to the %s", 1 / std::abs(most), side);
}
}  // namespace wheel_rail_contact::core
