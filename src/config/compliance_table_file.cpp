// SPDX-License-Identifier: BSD-3-Clause
#include "config/compliance_table_file.h"

#include <algorithm>
#include <cmath>

#include "config/parameter_reader.h"
#include "config/text.h"
#include "core/option_check.h"

namespace wheel_rail_contact
{
namespace
{
const NumberRule positive_or_infinite{"a number > 0 or .inf", [](double v) { return v > 0; }};
const NumberRule fixed_depth{"0.014 [m]", [](double v) { return v == core::ComplianceTable::reference_depth; }};

void readRequired(ParameterReader& reader, const std::string& name, const NumberRule& rule, double& value)
{
  reader.require(name, "every key of the table is required");
  reader.read(name, rule, value);
}

core::ComplianceTable readCompliances(ParameterReader& reader, const NumberRule& diagonal)
{
  core::ComplianceTable table;
  readRequired(reader, "lateral_lateral", diagonal, table.lateral_lateral);
  readRequired(reader, "lateral_roll", rules::finite, table.lateral_roll);
  readRequired(reader, "roll_roll", diagonal, table.roll_roll);
  readRequired(reader, "vertical_vertical", diagonal, table.vertical_vertical);
  return table;
}

std::vector<core::RailInfluence> readNeighbours(ParameterReader& reader)
{
  reader.require("neighbours", "every key of the table is required; [] without neighbours");
  std::vector<core::RailInfluence> neighbours;
  for (ParameterReader& neighbour : reader.readGroups("neighbours"))
  {
    double distance = 0;
    readRequired(neighbour, "distance", rules::positive, distance);
    neighbour.refuseIf(!neighbours.empty() && distance <= neighbours.back().distance, "distance",
                       "greater than the previous distance");
    neighbours.push_back({distance, readCompliances(neighbour, rules::finite)});
    neighbour.refuseUnknown();
  }
  return neighbours;
}

/// Removes the group `provenance`, which documents the source of the numbers, from the tree.
/// @throw std::invalid_argument if it is missing.
void takeProvenance(ParameterTree& tree, const std::string& file)
{
  const std::string group = "provenance/";
  const auto first = tree.lower_bound(group);
  auto last = first;
  while (last != tree.end() && last->first.rfind(group, 0) == 0)
  {
    ++last;
  }
  core::refuseIf(first == last, file + ": provenance is missing: state the source of the numbers");
  tree.erase(first, last);
}
}  // namespace

ComplianceTableFile readComplianceTable(const std::string& file)
{
  ParameterTree tree = readParameterFile(file);
  takeProvenance(tree, file);
  ParameterReader reader(std::move(tree), file + ": ");
  ComplianceTableFile result;
  reader.require("name", "every key of the table is required");
  reader.read("name", result.name);
  double depth = 0;
  readRequired(reader, "reference_depth", fixed_depth, depth);
  result.table = readCompliances(reader, rules::positive);
  const core::ComplianceTable& table = result.table;
  reader.refuseIf(!(table.lateral_lateral * table.roll_roll > table.lateral_roll * table.lateral_roll), "lateral_roll",
                  "below sqrt(lateral_lateral * roll_roll) in absolute value (positive definite matrix)");
  readRequired(reader, "linear_range_lateral_to_vertical", positive_or_infinite, result.linear_range);
  result.neighbours = readNeighbours(reader);
  reader.refuseUnknown();
  return result;
}

std::string linearRangeWarning(const core::WheelsetResult& result, const core::Sides<double>& linear_range)
{
  std::string text;
  for (const core::Side side : core::sides)
  {
    const core::RailResult& rail = result.rail[side];
    if (std::abs(rail.lateral_force) > linear_range[side] * std::max(rail.vertical_force, 0.0))
    {
      text = sentences(
          text, formatted("%s rail: Y = %.1f kN at Q = %.1f kN, |Y|/Q = %.3f; its compliance table is valid up to %g",
                          nameOf(side), 1e-3 * rail.lateral_force, 1e-3 * rail.vertical_force,
                          std::abs(rail.lateral_force / rail.vertical_force), linear_range[side]));
    }
  }
  return text;
}
}  // namespace wheel_rail_contact
