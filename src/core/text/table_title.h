// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wheel_rail_contact::core
{
/// Units by name, with their value in SI units.
using Units = std::map<std::string, double>;

/// Unit of length by its usual name.
struct NamedUnit
{
  const char* name;
  double value;  ///< [m]
};
constexpr NamedUnit named_lengths[] = {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"in", 0.0254}};

/// Units of length [m]: named_lengths, and other spellings of them.
const Units& lengthUnits();
/// Usual name of a unit of length [m]; its value if it has none.
std::string nameOfLength(double unit);
/// Text of a length [m], in millimetres.
std::string millimetres(double length);
/// Units of angle [rad]: rad, mrad, deg (or °).
const Units& angleUnits();

/// Title of a column.
struct TableTitle
{
  std::string name;
  std::string unit;  ///< as written, without its signs; empty if none is stated
};

/// Value of a unit, in upper or lower case; nothing if it is not among the units.
std::optional<double> unitNamed(const Units& units, const std::string& text);
/// True if the text is a unit of length or angle.
bool isUnit(const std::string& text);
/// Titles in the cells of a row.
std::vector<TableTitle> titlesIn(const std::vector<std::string>& cells);
/// Divides a title into name and unit: `y [mm]`, `y (mm)`, `y / mm`, `y_mm`, or `y` alone. Text after a first word with
/// its unit is a remark: `z_mm worn`.
TableTitle titleOf(const std::string& title);
}  // namespace wheel_rail_contact::core
