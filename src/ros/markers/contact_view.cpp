// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_view.h"

#include "ros/markers/rail_motion.h"

namespace wheel_rail_contact
{
using Eigen::Vector3d;
using visualization_msgs::MarkerArray;

namespace
{
/// Frame at the reference point of a rail at rest, parallel to the track frame, at x = 0: a place for the view before
/// the first contact.
Eigen::Isometry3d railFrame(const core::PlacedRail& at_rest, core::Side side)
{
  const core::PlanePoint p = at_rest.referencePoint();
  return Eigen::Isometry3d(Eigen::Translation3d(0, core::sideSign(side) * p.y, p.z));
}
}  // namespace

std::optional<Eigen::Isometry3d> contactFrame(const core::WheelsetResult& result, core::Side side)
{
  double total = 0;
  Vector3d place = Vector3d::Zero(), force = Vector3d::Zero();
  for (const core::PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      const double n = patch.normal_force;
      total += n;
      place += n * Vector3d(patch.pose.x, patch.pose.y, patch.pose.z);
      force += n * Vector3d(0, -std::sin(patch.pose.angle), std::cos(patch.pose.angle));
    }
  }
  if (!(total > 0))
  {
    return std::nullopt;
  }
  return Eigen::Translation3d(place / total) * Eigen::AngleAxisd(std::atan2(-force.y(), force.z()), Vector3d::UnitX());
}

Eigen::Isometry3d ContactView::frame(const ContactOutput& output, const core::ContactModelConfig* model,
                                     const SceneOptions& options, core::Side side)
{
  std::optional<Eigen::Isometry3d>& last = last_[side];
  if (const auto now = contactFrame(*drawnResult(output, model, options.deflection_scale), side))
  {
    last = now;
  }
  if (const auto at_rest = restingRails(model, output.state.distance); at_rest && !last)
  {
    last = railFrame((*at_rest)[side], side);
  }
  return Eigen::Translation3d(options.drawn_x.value_or(output.x()), 0, 0) *
         last.value_or(Eigen::Isometry3d::Identity());
}

MarkerArray ContactView::markers(const ContactOutput& output, const core::ContactModelConfig* model,
                                 const ContactTrail& trail, const SceneOptions& options, double spacing)
{
  const double shift = options.track.sides.size() > 1 ? 0.5 * spacing : 0.0;
  MarkerArray all;
  for (const core::Side side : options.track.sides)
  {
    SceneOptions one = options;
    one.track.sides = {side};
    one.view = frame(output, model, options, side) * Eigen::Translation3d(0, -core::sideSign(side) * shift, 0);
    const MarkerArray markers = sceneMarkers(output, model, trail, one);
    all.markers.insert(all.markers.end(), markers.markers.begin(), markers.markers.end());
  }
  return all;
}
}  // namespace wheel_rail_contact
