// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/text/text_file.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
namespace line_quantity
{
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
}  // namespace line_quantity

struct LineColumn
{
  const char* name;
  bool is_angle;
  double railway_sign;  ///< -1: its sign changes in railway axes
};

inline constexpr std::array<LineColumn, line_quantity::columns> line_columns{{{"x", false, 1},
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
struct LineRow
{
  std::array<std::optional<double>, line_quantity::columns> value;
  std::array<bool, line_quantity::columns> nines{};  ///< the cell contains only nines, as fillers do
  std::size_t line = 0;
};

LineStation stationOf(const LineRow& row);
/// Makes deviations of the gauge from the nominal one. @return true if they are
bool isDeviation(std::vector<LineRow>& rows, double nominal, const TextFile& file);
/// Puts the rows in the order of x. @return true if they were in the opposite order
bool isReversed(std::vector<LineRow>& rows, const TextFile& file);
/// Refuses values that no track has.
void checkValues(const std::vector<LineRow>& rows, double nominal_gauge, const TextFile& file);
/// Questions on rows in the order of x, each naming columns and values: a quantity that is given twice with two values,
/// a value that stays where the others move, values and distances of stations that their unit makes implausible.
/// @param units  of the columns as written [m], [rad]
std::vector<std::string> lineDoubts(const std::vector<LineRow>& rows,
                                    const std::array<double, line_quantity::columns>& units);
}  // namespace wheel_rail_contact::core
