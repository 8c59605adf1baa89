// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace wheel_rail_contact::core
{
/// Unit by its usual name.
struct NamedUnit
{
  const char* name;
  double value;  ///< in SI units
};
constexpr NamedUnit named_lengths[] = {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"in", 0.0254}};

/// Units of tables of one kind: the SI unit, a usual one, others.
struct UnitKind
{
  const char* name;
  std::vector<NamedUnit> units;
};
extern const std::vector<UnitKind> unit_kinds;
/// @param name of one of the kinds
const UnitKind& unitKind(const std::string& name);
/// Unit with this spelling; null if there is none, or if it is of another kind. Case, blanks and the signs of a
/// multiplication do not matter: mm, MM, N m, Nm, kN.m, deg, degrees, °.
const NamedUnit* unitNamed(const std::string& text, const char* kind = nullptr);
/// Usual name of a unit of length [m]; its value if it has none.
std::string nameOfLength(double unit);
/// Text of a length [m], in millimetres.
std::string millimetres(double length);
/// Title of a column.
struct TableTitle
{
  std::string name;
  std::string unit;  ///< as written, without its signs; empty if none is stated
};

/// Divides a title into name and unit: `y [mm]`, `y (mm)`, `y / mm`, `y in mm`, `y_mm`, or `y` alone. Text after a
/// first word with its unit is a remark: `z_mm worn`.
/// @param is_shape  only lengths and angles are units: `z_min` has none
TableTitle titleOf(const std::string& title, bool is_shape);
/// Titles in the cells of a row.
std::vector<TableTitle> titlesIn(const std::vector<std::string>& cells, bool is_shape);
/// Unit in a cell, without its brackets.
std::string bareUnit(const std::string& cell);
}  // namespace wheel_rail_contact::core
