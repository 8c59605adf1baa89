// SPDX-License-Identifier: BSD-3-Clause
#include "paper/placement.h"

#include <algorithm>
#include <stdexcept>

#include "core/balance/rail_support.h"
#include "core/track/contact_search.h"
#include "paper/one_wheel.h"

namespace wheel_rail_contact::core::paper
{
namespace
{
constexpr double drawing_step = 2e-4;  ///< distance of the points along a profile [m]

ContactModelConfig configOf(const ContactModelConfig& config, const Case& of)
{
  ContactModelConfig changed = config;
  if (of.is_given)
  {
    changed.rail_bending.model = RailBendingConfig::Model::prescribed;
    changed.rail_bending.prescribed = withCrownDisplaced(of.crown, config.track.rail_inclination.left);
  }
  return changed;
}

void addOutlines(const ContactModelConfig& config, const PlacedRail& rail, Placement& placement)
{
  const WheelsetPose level{case_position, config.wheelset.rolling_radius.left, 0, placement.roll};
  const Profile& wheel_profile = *config.wheel_profile.left;
  ContactSearch search(wheel_profile, rail.profile());
  search.setRail(rail);
  search.setWheel(PlacedWheel(wheel_profile, config.wheelset, Side::left, level));
  InitialContact touch;
  search.nearest(touch);
  placement.initial_contact = rail.at(touch.rail_u);
  WheelsetPose touching = level;
  touching.z -= touch.separation;
  const PlacedWheel wheel(wheel_profile, config.wheelset, Side::left, touching);
  for (double u = 0; u <= rail.profile().length(); u += drawing_step)
  {
    placement.rail.push_back(rail.at(u));
  }
  for (double u = 0; u <= wheel_profile.length(); u += drawing_step)
  {
    PlanePoint point{};
    if (wheel.section(wheel_profile.at(u), 0, point))
    {
      placement.wheel.push_back(point);
    }
  }
}
}  // namespace

std::vector<PatchResult> leftPatches(const WheelsetResult& result)
{
  std::vector<PatchResult> left;
  std::copy_if(result.patches.begin(), result.patches.end(), std::back_inserter(left),
               [](const PatchResult& patch) { return patch.side == Side::left; });
  return left;
}

Figures leftFigures(const WheelsetResult& result)
{
  Figures sum{0, 0};
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == Side::left)
    {
      sum.max_pressure = std::max(sum.max_pressure, patch.max_pressure);
      sum.area += patch.area;
    }
  }
  return sum;
}

std::vector<Case> paperCases()
{
  return {{"without", true, {}, printed_without_bending, Figures{1175.0e6, 187.2e-6}},
          {"shifted", true, {printed_displacement, 0, 0}, printed_with_bending, Figures{1097e6, 190e-6}},
          {"turned", true, {printed_displacement, 0, case_turn}, printed_with_bending, Figures{1347e6, 129.6e-6}},
          {"own_rail", false, {}, printed_with_bending, std::nullopt}};
}

Placement solveCase(const ContactModelConfig& config, const Case& of)
{
  WheelsetContact contact(configOf(config, of));
  WheelsetState state;
  state.y = case_position;
  state.force_z = -2 * printed_wheel_load;
  const WheelsetResult& result = contact.evaluate(state);
  if (result.status != ContactStatus::ok)
  {
    throw std::runtime_error("case " + of.name + ": " + result.reason);
  }
  Placement placement{of, result.rail.left.deflection, result.roll, leftFigures(result), {}, {},
                      {}, leftPatches(result)};
  const PlacedRail rail = restingRail(config, Side::left).deflected(placement.deflection);
  addOutlines(config, rail, placement);
  return placement;
}
}  // namespace wheel_rail_contact::core::paper
