// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/rail_motion.h"

#include <Eigen/Geometry>

#include "core/balance/rail_support.h"

namespace wheel_rail_contact
{
std::optional<core::Sides<core::PlacedRail>> restingRails(const core::ContactModelConfig* model, double distance)
{
  if (!model)
  {
    return std::nullopt;
  }
  return core::Sides<core::PlacedRail>(core::restingRail(*model, core::Side::left, distance),
                                       core::restingRail(*model, core::Side::right, distance));
}

core::RailDeflection magnified(const core::RailResult& rail, double scale)
{
  const core::RailDeflection &all = rail.deflection, &given = rail.given;
  return {given.lateral + scale * (all.lateral - given.lateral),
          given.vertical + scale * (all.vertical - given.vertical), given.roll + scale * (all.roll - given.roll)};
}

core::PatchPose carriedByRail(const core::PlacedRail& at_rest, core::Side side, const core::RailDeflection& from,
                              const core::RailDeflection& to, const core::PatchPose& pose)
{
  const core::PlacedRail before = at_rest.deflected(from), after = at_rest.deflected(to);
  const core::PlanePoint a = before.referencePoint(), b = after.referencePoint();
  const double turn = after.angle() - before.angle(), sign = core::sideSign(side);
  const Eigen::Vector2d moved =
      Eigen::Vector2d(b.y, b.z) + Eigen::Rotation2Dd(turn) * Eigen::Vector2d(sign * pose.y - a.y, pose.z - a.z);
  return {pose.x, sign * moved.x(), moved.y(), pose.angle + sign * turn, pose.pitch};
}

core::WheelsetResult withMagnifiedDeflection(const core::WheelsetResult& result,
                                             const core::Sides<core::PlacedRail>& at_rest, double scale)
{
  core::WheelsetResult drawn = result;
  for (const core::Side side : core::sides)
  {
    drawn.rail[side].deflection = magnified(drawn.rail[side], scale);
  }
  for (core::PatchResult& patch : drawn.patches)
  {
    patch.pose = carriedByRail(at_rest[patch.side], patch.side, result.rail[patch.side].deflection,
                               drawn.rail[patch.side].deflection, patch.pose);
  }
  return drawn;
}
}  // namespace wheel_rail_contact
