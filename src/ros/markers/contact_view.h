// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <optional>

#include "ros/markers/contact_scene.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// Frame of the contact of one wheel in the track frame, relative to x of the axle centre: the origin is the mean of
/// the patch origins, weighted by their normal forces. x is forward along the track, z along the sum of the normal
/// forces, out of the rail. With one patch it is the patch frame; with several it moves continuously as the load moves
/// from one to the other. None without contact.
std::optional<Eigen::Isometry3d> contactFrame(const core::WheelsetResult& result, core::Side side);

/// Pictures in which the contact of each drawn wheel stays at its place, with its normal upward: contactFrame() becomes
/// a fixed frame of the picture. While a wheel has no contact, its last frame remains; before the first contact it is
/// at the reference point of its rail.
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
