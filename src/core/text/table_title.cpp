// SPDX-License-Identifier: BSD-3-Clause
#include "core/text/table_title.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <regex>

#include "core/constants.h"
#include "core/text/formatted.h"
#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr const char* signs = "/_ \t";                ///< before a unit
constexpr std::size_t longest_unit = 20;              ///< of a title, with blanks [bytes]
constexpr double pound_force = 0.45359237 * 9.80665;  ///< of 1959, at standard gravity [N]

/// Spelling of a unit without what does not matter; empty if the text is longer than a unit.
std::string plainUnit(const std::string& text)
{
  static const std::regex micro("\xC2\xB5|\xCE\xBC"), degrees("\xC2\xBA"), times("[.*-]|\xC2\xB7|\xE2\x8B\x85");
  std::string plain = std::regex_replace(text.size() > longest_unit ? "" : text, micro, "u");
  plain = std::regex_replace(std::regex_replace(plain, degrees, "\xC2\xB0"), times, " ");
  return joined(splitWords(lowerCase(plain)), " ");
}

bool isUnit(const std::string& text, bool is_shape)
{
  return is_shape ? unitNamed(text, "length") != nullptr || unitNamed(text, "angle") != nullptr
                  : unitNamed(text) != nullptr;
}

/// Title with the longest unit after a sign at its end; no unit if none is there.
TableTitle withUnitAtEnd(const std::string& text, bool is_shape)
{
  const std::size_t first = text.size() - std::min(text.size(), longest_unit);
  for (std::size_t at = text.find_first_of(signs, first); at != std::string::npos;
       at = text.find_first_of(signs, at + 1))
  {
    const std::string unit = trim(text.substr(at + 1));
    if (isUnit(unit, is_shape))
    {
      const std::string name = text.substr(0, text.find_last_not_of(signs, at) + 1), in = " in";
      const bool has_in = name.size() > in.size() && name.compare(name.size() - in.size(), in.size(), in) == 0;
      return {trim(has_in ? name.substr(0, name.size() - in.size()) : name), unit};
    }
  }
  return {text, ""};
}
}  // namespace

const std::vector<UnitKind> unit_kinds{
    {"time", {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60}}},
    {"length",
     {{"m", 1},
      {"mm", 1e-3},
      {"um", 1e-6},
      {"cm", 1e-2},
      {"km", 1e3},
      {"in", 0.0254},
      {"ft", 0.3048},
      {"mi", 1609.344}}},
    {"angle", {{"rad", 1}, {"mrad", 1e-3}, {"deg", degree}}},
    {"curvature", {{"1/m", 1}, {"1/km", 1e-3}}},
    {"slope", {{"m/m", 1}, {"permil", 1e-3}, {"mm/m", 1e-3}, {"%", 0.01}}},
    {"force", {{"N", 1}, {"kN", 1e3}, {"lbf", pound_force}, {"kip", 1e3 * pound_force}}},
    {"torque", {{"N m", 1}, {"kN m", 1e3}, {"lbf ft", 0.3048 * pound_force}}},
    {"velocity", {{"m/s", 1}, {"mm/s", 1e-3}, {"km/h", 1 / 3.6}}},
    {"rate", {{"rad/s", 1}, {"mrad/s", 1e-3}, {"deg/s", degree}}}};

const NamedUnit* unitNamed(const std::string& text, const char* kind)
{
  static const std::map<std::string, std::string> others{
      {"sec", "s"},        {"inch", "in"},    {"inches", "in"},     {"feet", "ft"},
      {"\xC2\xB0", "deg"}, {"degree", "deg"}, {"degrees", "deg"},   {"kips", "kip"},
      {"nm", "n m"},       {"knm", "kn m"},   {"ft lbf", "lbf ft"}, {"\xE2\x80\xB0", "permil"}};
  const std::string plain = plainUnit(text);
  const auto other = others.find(plain);
  const std::string& name = other == others.end() ? plain : other->second;
  for (const UnitKind& units : unit_kinds)
  {
    const auto unit = std::find_if(units.units.begin(), units.units.end(),
                                   [&name](const NamedUnit& named) { return lowerCase(named.name) == name; });
    if (unit != units.units.end())
    {
      return kind == nullptr || std::string(kind) == units.name ? &*unit : nullptr;
    }
  }
  return nullptr;
}

const UnitKind& unitKind(const std::string& name)
{
  return *std::find_if(unit_kinds.begin(), unit_kinds.end(), [&](const UnitKind& kind) { return name == kind.name; });
}

std::string nameOfLength(double unit)
{
  for (const NamedUnit& named : named_lengths)
  {
    if (std::abs(unit / named.value - 1) < 1e-9)
    {
      return named.name;
    }
  }
  return std::to_string(unit) + " m";
}

std::string millimetres(double length)
{
  return formatted("%.4g mm", length * 1e3);
}

std::string bareUnit(const std::string& cell)
{
  const bool is_bracketed =
      cell.size() > 1 && ((cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')'));
  return is_bracketed ? trim(cell.substr(1, cell.size() - 2)) : cell;
}

std::vector<TableTitle> titlesIn(const std::vector<std::string>& cells, bool is_shape)
{
  std::vector<TableTitle> titles;
  std::transform(cells.begin(), cells.end(), std::back_inserter(titles),
                 [is_shape](const std::string& cell) { return titleOf(cell, is_shape); });
  return titles;
}

TableTitle titleOf(const std::string& title, bool is_shape)
{
  for (const char sign : {'[', '('})
  {
    const std::size_t open = title.rfind(sign);
    const std::string brackets = open == std::string::npos ? "" : title.substr(open), unit = bareUnit(brackets);
    if (unit != brackets && (sign == '[' || isUnit(unit, is_shape)))
    {
      return {trim(title.substr(0, open)), unit};
    }
  }
  const TableTitle whole = withUnitAtEnd(title, is_shape);
  const TableTitle first = withUnitAtEnd(title.substr(0, title.find_first_of(" \t")), is_shape);
  return whole.unit.empty() && !first.unit.empty() ? first : whole;
}
}  // namespace wheel_rail_contact::core
