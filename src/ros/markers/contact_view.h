// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <optional>

#include "ros/markers/contact_scene.h"

namespace wheel_rail_contact
{
/// Pictures in which the contact of each drawn wheel stays at its place, with its normal upward: contactFrame() becomes
/// a fixed frame of the picture. While a wheel has no contact, its last frame remains; before the first contact it is
/// railFrame().
class ContactView
{
 public:
  /// Markers as those of sceneMarkers(), for each of the drawn sides by itself. The contact of a single side is at the
  /// origin; those of both sides are side by side, without the track between them.
  /// @param spacing lateral distance between the contacts of both sides in the picture [m]
  visualization_msgs::MarkerArray markers(const ContactOutput& output, const core::ContactModelConfig* model,
                                          const ContactTrail& trail, const SceneOptions& options, double spacing);
  /// Forgets the last frames.
  void clear() { last_ = {}; }

 private:
  Eigen::Isometry3d frame(const ContactOutput& output, const core::ContactModelConfig* model,
                          const SceneOptions& options, core::Side side);

  core::Sides<std::optional<Eigen::Isometry3d>> last_;  ///< by Side, relative to x of the axle
};
}  // namespace wheel_rail_contact
