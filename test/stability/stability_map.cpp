// SPDX-License-Identifier: BSD-3-Clause
#include "stability_map.h"

#include <cmath>
#include <sstream>

namespace wheel_rail_contact::core::stability
{
namespace
{
void write(std::ostream& out, const MapTable& table)
{
  out << "\n## " << table.title << "\n\n" << table.text << "\n\n| situation |";
  for (const std::string& column : table.columns)
  {
    out << ' ' << column << " |";
  }
  out << "\n|---|";
  for (std::size_t k = 0; k < table.columns.size(); ++k)
  {
    out << "---|";
  }
  out << '\n';
  for (const MapRow& row : table.rows)
  {
    out << "| " << row.situation << " |";
    for (const std::string& verdict : row.verdicts)
    {
      out << ' ' << verdict << " |";
    }
    out << '\n';
  }
}
}  // namespace

std::string verdictOf(double relative_error)
{
  const double off = std::abs(relative_error);
  return off <= 0.02  ? "right"
         : off <= 0.1 ? "off by up to 10 %"
         : off <= 0.5 ? "off by 10 to 50 %"
                      : "off by more than 50 %";
}

std::string verdictSaid(const std::string& verdict, bool above_tolerance)
{
  const bool right = verdict.rfind("off", 0) != 0 && verdict != "no reference";
  return above_tolerance && !right ? verdict + ", and says so" : verdict;
}

std::string stabilityPage()
{
  std::ostringstream out;
  out << "# Where methods fail\n\n"
         "Situations against methods: is the highest pressure right (within 2 %), off, refused with a reason, or does "
         "the iteration diverge or stall? A test (`scripts/test -R stability`) solves every cell again and compares "
         "this page with what it finds; with `WRITE_STABILITY_PAGE` set in its environment it writes the page instead. "
         "`stability_campaign` (test/stability/campaign.cpp) does the like for random wheelsets.\n";
  for (const MapTable& table : {wheelsetMap(), shapeMap(), aspectMap(), iterationMap(), fewCellsMap(), boxMap()})
  {
    write(out, table);
  }
  return out.str();
}
}  // namespace wheel_rail_contact::core::stability
