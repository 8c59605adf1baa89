// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_view.h"

#include "ros/markers/contact_frame.h"
#include "ros/markers/rail_motion.h"

namespace wheel_rail_contact
{
using visualization_msgs::MarkerArray;

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
  return Eigen::Translation3d(options.at_origin ? 0 : output.x(), 0, 0) * last.value_or(Eigen::Isometry3d::Identity());
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
