// SPDX-License-Identifier: BSD-3-Clause
#include "core/text/table_title.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/constants.h"
#include "core/text/formatted.h"
#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Text in brackets that open at `open` and close at the end of the text; empty if its last character is not `close`.
std::string insideBrackets(const std::string& text, std::size_t open, char close)
{
  return text.back() == close ? trim(text.substr(open + 1, text.size() - open - 2)) : "";
}

/// Title with the unit after the last sign of its kind; no unit if the word there is none.
TableTitle withUnitAtEnd(const std::string& text)
{
  const std::size_t sign = text.find_last_of("/_ \t");
  const std::string unit = sign == std::string::npos ? "" : text.substr(sign + 1);
  if (!isUnit(unit))
  {
    return {text, ""};
  }
  const std::size_t end = text.find_last_not_of("/_ \t", sign);
  return {end == std::string::npos ? "" : text.substr(0, end + 1), unit};
}
}  // namespace

const Units& lengthUnits()
{
  static const Units units = []
  {
    Units all;
    for (const NamedUnit& unit : named_lengths)
    {
      all[unit.name] = unit.value;
    }
    all["\xC2\xB5m"] = all["\xCE\xBCm"] = all["um"];
    all["ft"] = all["feet"] = 0.3048;  // of places along a line
    all["km"] = 1e3;
    all["mi"] = 1609.344;
    all["inch"] = all["inches"] = all["in"];
    return all;
  }();
  return units;
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

const Units& angleUnits()
{
  static const Units units{{"rad", 1}, {"mrad", 1e-3}, {"deg", degree}, {"\xC2\xB0", degree}};
  return units;
}

std::optional<double> unitNamed(const Units& units, const std::string& text)
{
  const auto found = units.find(text);
  const auto lower = units.find(lowerCase(text));
  return found != units.end()   ? std::optional(found->second)
         : lower != units.end() ? std::optional(lower->second)
                                : std::nullopt;
}

bool isUnit(const std::string& text)
{
  return unitNamed(lengthUnits(), text) || unitNamed(angleUnits(), text);
}

std::vector<TableTitle> titlesIn(const std::vector<std::string>& cells)
{
  std::vector<TableTitle> titles;
  std::transform(cells.begin(), cells.end(), std::back_inserter(titles), titleOf);
  return titles;
}

TableTitle titleOf(const std::string& title)
{
  for (const char* brackets : {"[]", "()"})
  {
    const std::size_t open = title.find(brackets[0]);
    const std::string unit = open == std::string::npos ? "" : insideBrackets(title, open, brackets[1]);
    if (brackets[0] == '[' ? !unit.empty() : isUnit(unit))
    {
      return {trim(title.substr(0, open)), unit};
    }
  }
  const TableTitle whole = withUnitAtEnd(title);
  const TableTitle first = withUnitAtEnd(title.substr(0, title.find_first_of(" \t")));
  return whole.unit.empty() && !first.unit.empty() ? first : whole;
}
}  // namespace wheel_rail_contact::core
