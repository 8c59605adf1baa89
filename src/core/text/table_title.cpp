// SPDX-License-Identifier: BSD-3-Clause
#include "core/text/table_title.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <map>

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

/// Text with `to` in place of each of some signs.
void replaceAll(std::string& text, const std::initializer_list<const char*>& from, const char* to)
{
  for (const std::string sign : from)
  {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at))
    {
      text.replace(at, sign.size(), to);
    }
  }
}

/// Spelling of a unit without what does not matter.
std::string plainUnit(std::string text)
{
  replaceAll(text, {"\xC2\xB5", "\xCE\xBC"}, "u");
  replaceAll(text, {"\xC2\xBA"}, "\xC2\xB0");
  replaceAll(text, {".", "*", "-", "\xC2\xB7", "\xE2\x8B\x85"}, " ");
  return joined(splitWords(lowerCase(text)), " ");
}

bool isUnit(const std::string& text, bool is_shape)
{
  const NamedUnit* unit = unitNamed(text);
  return unit != nullptr && (!is_shape || unitNamed(text, "length") != nullptr || unitNamed(text, "angle") != nullptr);
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

const std::vector<NamedUnit> table_units{{"m", 1},
                                         {"mm", 1e-3},
                                         {"um", 1e-6},
                                         {"cm", 1e-2},
                                         {"km", 1e3},
                                         {"in", 0.0254},
                                         {"ft", 0.3048},
                                         {"mi", 1609.344},
                                         {"rad", 1, "angle"},
                                         {"mrad", 1e-3, "angle"},
                                         {"deg", degree, "angle"},
                                         {"1/m", 1, "curvature"},
                                         {"1/km", 1e-3, "curvature"},
                                         {"m/m", 1, "slope"},
                                         {"permil", 1e-3, "slope"},
                                         {"mm/m", 1e-3, "slope"},
                                         {"%", 0.01, "slope"},
                                         {"s", 1, "time"},
                                         {"ms", 1e-3, "time"},
                                         {"us", 1e-6, "time"},
                                         {"min", 60, "time"},
                                         {"N", 1, "force"},
                                         {"kN", 1e3, "force"},
                                         {"lbf", pound_force, "force"},
                                         {"kip", 1e3 * pound_force, "force"},
                                         {"N m", 1, "torque"},
                                         {"kN m", 1e3, "torque"},
                                         {"lbf ft", 0.3048 * pound_force, "torque"},
                                         {"m/s", 1, "velocity"},
                                         {"mm/s", 1e-3, "velocity"},
                                         {"km/h", 1 / 3.6, "velocity"},
                                         {"rad/s", 1, "rate"},
                                         {"mrad/s", 1e-3, "rate"},
                                         {"deg/s", degree, "rate"}};

const NamedUnit* unitNamed(const std::string& text, const char* kind)
{
  static const std::map<std::string, std::string> others{
      {"sec", "s"},        {"inch", "in"},    {"inches", "in"},     {"feet", "ft"},
      {"\xC2\xB0", "deg"}, {"degree", "deg"}, {"degrees", "deg"},   {"kips", "kip"},
      {"nm", "n m"},       {"knm", "kn m"},   {"ft lbf", "lbf ft"}, {"\xE2\x80\xB0", "permil"}};
  const std::string plain = plainUnit(text);
  const auto other = others.find(plain);
  const auto found = std::find_if(table_units.begin(), table_units.end(),
                                  [&](const NamedUnit& unit)
                                  { return lowerCase(unit.name) == (other == others.end() ? plain : other->second); });
  return found != table_units.end() && (kind == nullptr || std::string(kind) == found->kind) ? &*found : nullptr;
}

std::vector<std::string> unitNames(const char* kind)
{
  std::vector<std::string> names;
  for (const NamedUnit& unit : table_units)
  {
    if (std::string(kind) == unit.kind)
    {
      names.emplace_back(unit.name);
    }
  }
  return names;
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
