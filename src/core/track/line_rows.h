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
/// Quantities of a table; those from the curvature on are the design.
inline constexpr std::size_t x = 0, gauge = 1, alignment = 2, alignment_left = 3, alignment_right = 4, level = 5,
                             level_left = 6, level_right = 7, cross_level = 8, rail_lateral_left = 9,
                             rail_vertical_left = 10, rail_roll_left = 11, rail_lateral_right = 12,
                             rail_vertical_right = 13, rail_roll_right = 14, curvature = 15, cant = 16, gradient = 17,
                             columns = 18;
}  // namespace line_quantity

struct LineColumn
{
  const char* name;
  const char* kind;     ///< of its unit
  double railway_sign;  ///< -1: its sign changes in railway axes
};

inline constexpr std::array<LineColumn, line_quantity::columns> line_columns{{{"x", "length", 1},
                                                                              {"gauge", "length", 1},
                                                                              {"alignment", "length", -1},
                                                                              {"alignment_left", "length", -1},
                                                                              {"alignment_right", "length", -1},
                                                                              {"level", "length", -1},
                                                                              {"level_left", "length", -1},
                                                                              {"level_right", "length", -1},
                                                                              {"cross_level", "length", 1},
                                                                              {"rail_lateral_left", "length", 1},
                                                                              {"rail_vertical_left", "length", -1},
                                                                              {"rail_roll_left", "angle", 1},
                                                                              {"rail_lateral_right", "length", 1},
                                                                              {"rail_vertical_right", "length", -1},
                                                                              {"rail_roll_right", "angle", 1},
                                                                              {"curvature", "curvature", -1},
                                                                              {"cant", "length", 1},
                                                                              {"gradient", "slope", 1}}};

/// Largest displacement, difference from the nominal gauge, and value of the design [m], [rad], [1/m], [-].
inline constexpr double largest_line_value = 0.2;

/// A row of the table in SI units and REP-103 axes; nothing where the column is missing.
struct LineRow
{
  std::array<std::optional<double>, line_quantity::columns> value;
  std::array<bool, line_quantity::columns> nines{};  ///< the cell contains only nines, as fillers do
  std::size_t line = 0;
};

LineStation stationOf(const LineRow& row, double nominal_gauge);
/// Makes deviations of the gauge from the nominal one. @return true if they are
bool isDeviation(std::vector<LineRow>& rows, double nominal, const TextFile& file);
/// Puts the rows in the order of x. @return true if they were in the opposite order
bool isReversed(std::vector<LineRow>& rows, const TextFile& file);
/// Refuses values that no track has, and a cross level that contains the cant.
void checkValues(const std::vector<LineRow>& rows, double nominal_gauge, const TextFile& file);
/// Questions on rows in the order of x, each naming columns and values: a quantity that is given twice with two values,
/// a value that stays where the others move, values and distances of stations that their unit makes implausible.
/// @param units  of the columns as written, in SI units
std::vector<std::string> lineDoubts(const std::vector<LineRow>& rows,
                                    const std::array<double, line_quantity::columns>& units);
/// Smallest radius, and its side.
std::string designText(const std::vector<LineRow>& rows);
}  // namespace wheel_rail_contact::core
