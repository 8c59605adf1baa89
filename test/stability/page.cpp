// SPDX-License-Identifier: BSD-3-Clause
#include "stability_map.h"

#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
/// Reasons of all refusals, in the order in which they occur.
std::vector<std::string> reasonsOf(const std::vector<MapTable>& tables)
{
  std::vector<std::string> reasons;
  for (const MapTable& table : tables)
  {
    for (const MapRow& row : table.rows)
    {
      for (const Verdict& verdict : row.verdicts)
      {
        const std::string& reason = verdict.reason();
        if (!reason.empty() && std::find(reasons.begin(), reasons.end(), reason) == reasons.end())
        {
          reasons.push_back(reason);
        }
      }
    }
  }
  return reasons;
}

/// (a), (b), ...
std::string letter(std::size_t index)
{
  return {'(', static_cast<char>('a' + index), ')'};
}

std::string entry(const Verdict& verdict, const std::vector<std::string>& reasons)
{
  const auto reason = std::find(reasons.begin(), reasons.end(), verdict.reason());
  return verdict.text() +
         (reason == reasons.end() ? "" : " " + letter(static_cast<std::size_t>(reason - reasons.begin())));
}

void writeLegend(std::ostream& out, const std::vector<std::string>& reasons)
{
  out << "| entry | meaning |\n|---|---|\n| " << error_classes.front().text << " | error of the highest pressure up to "
      << std::lround(100 * error_classes.front().upper) << " % |\n| ";
  for (std::size_t k = 1; k < error_classes.size(); ++k)
  {
    out << (k > 1 ? "; " : "") << error_classes[k].text;
  }
  out << " | error of the highest pressure |\n"
         "| flagged | the error estimate of the result is above the tolerance. The node reports this in `status_text`. "
         "Results that are right are not marked |\n"
         "| no reference | the reference itself may be wrong by more than "
      << std::lround(100 * error_classes.front().upper)
      << " % |\n"
         "| no contact | neither wheel touches its rail, in the reference too |\n"
         "| refused | no result; the letter gives the reason |\n";
  for (std::size_t k = 0; k < reasons.size(); ++k)
  {
    out << "| " << letter(k) << " | " << reasons[k] << " |\n";
  }
}

void writeTable(std::ostream& out, const MapTable& table, const std::vector<std::string>& reasons)
{
  out << headOf(table);
  for (const MapRow& row : table.rows)
  {
    out << "| " << row.situation << " |";
    for (const Verdict& verdict : row.verdicts)
    {
      out << ' ' << entry(verdict, reasons) << " |";
    }
    out << '\n';
  }
}
}  // namespace

std::string digits(double value)
{
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
}

const std::vector<MapTable>& stabilityMaps()
{
  static const std::vector<MapTable> maps{wheelsetMap(),  sweepMap(),    conformalMap(), shapeMap(),   aspectMap(),
                                          iterationMap(), fewCellsMap(), boxMap(),       frictionMap()};
  return maps;
}

std::vector<std::string> methodNames()
{
  std::vector<std::string> names;
  for (const NormalMethod method : all_normal_methods)
  {
    names.emplace_back(toString(method));
  }
  return names;
}

std::string headOf(const MapTable& table)
{
  std::string columns = "| situation |", line = "|---|";
  for (const std::string& column : table.columns)
  {
    columns += ' ' + column + " |";
    line += "---|";
  }
  return "\n## " + table.title + "\n\n" + table.text + "\n\n" + columns + '\n' + line + '\n';
}

void writePage(std::ostream& out, const std::vector<MapTable>& tables)
{
  out << "# Stability of the methods\n\n"
         "<!-- This page is generated. To generate it again after a change of a method:\n"
         "cmake --build build --target stability_page\n"
         "build/devel/lib/wheel_rail_contact/stability_page > doc/stability.md\n"
         "-->\n\n"
         "This page shows in which situations each method is accurate, inaccurate, or without a result.\n\n";
  const std::vector<std::string> reasons = reasonsOf(tables);
  writeLegend(out, reasons);
  out << "\n`auto` is right, refused or flagged in each situation (`test_stability_page`). `stability_campaign` checks "
         "random wheelsets ([CONTRIBUTING](../CONTRIBUTING.md#stability)).\n";
  for (const MapTable& table : tables)
  {
    writeTable(out, table, reasons);
  }
}
}  // namespace wheel_rail_contact::core::stability
