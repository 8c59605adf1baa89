// SPDX-License-Identifier: BSD-3-Clause
#include "paper/stress_rows.h"

#include <stdexcept>
#include <utility>

#include "core/stress/stress_search.h"
#include "paper/placement.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::paper
{
namespace
{
/// Row of a patch of the left wheel.
StressRow rowOf(const std::string& rail, const PatchResult& patch, const Material& material)
{
  StressRow row{rail, 0, true, patch, stressMaxima(patch, material.poisson, assumed_yield), {}, 0, 0};
  // An isotropic material has the same principal axes of stress and strain.
  const std::array<double, 3>& principal = row.highest.principal;
  const Strain strain = strainOf({principal[0], principal[1], principal[2], 0, 0, 0}, material);
  row.strain = {strain.xx, strain.yy, strain.zz};
  row.load_factor = loadFactor(row.patch.max_pressure, assumed_yield);
  row.shakedown_limit = shakedownLimit(row.patch.max_pressure, row.highest.alternating, row.highest.von_mises.value);
  return row;
}
}  // namespace

const PatchResult& onlyPatch(const std::vector<PatchResult>& left, const std::string& what)
{
  if (left.size() != 1)
  {
    throw std::runtime_error(what + ": the left wheel has " + std::to_string(left.size()) +
                             " patches, but the stress is computed for one");
  }
  return left.front();
}

std::vector<StressRow> stressOfCases(const ContactModelConfig& config)
{
  std::vector<StressRow> rows;
  for (const Case& of : paperCases())
  {
    if (of.is_given)
    {
      const std::vector<PatchResult> left = solveCase(config, of).patches;
      rows.push_back(rowOf(of.name, onlyPatch(left, "case " + of.name), config.rail_material.left));
    }
  }
  return rows;
}

std::vector<StressRow> stressUnderForces(const ContactModelConfig& config, const NamedTable& table,
                                         const std::vector<double>& forces)
{
  WheelsetContact contact(onTable(config, table));
  std::vector<StressRow> rows;
  for (const double force : forces)
  {
    contact.reset();
    const WheelsetResult& result = contact.evaluate(stateUnder(case_position, force));
    const std::string what = table.name + " under " + std::to_string(force) + " N";
    if (!isUsable(result.status))
    {
      throw std::runtime_error(what + ": " + result.reason);
    }
    StressRow row = rowOf(table.name, onlyPatch(leftPatches(result), what), config.rail_material.left);
    row.lateral_force = force;
    row.in_range = isInRange(table, force);
    rows.push_back(std::move(row));
  }
  return rows;
}
}  // namespace wheel_rail_contact::core::paper
