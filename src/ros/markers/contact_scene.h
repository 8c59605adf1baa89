// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "config/node_config.h"
#include "ros/evaluation/contact_evaluator.h"
#include "ros/markers/contact_trail.h"
#include "ros/markers/patch_markers.h"
#include "ros/markers/track_markers.h"

namespace wheel_rail_contact
{
/// Contents of a picture. `track.sides` selects the sides that are drawn.
struct SceneOptions
{
  PatchStyle patch;           ///< style of the patches
  TrackStyle track;           ///< style of wheels and rails
  bool patches = true;        ///< pressure surfaces, magnified and in true size
  bool outlines = true;       ///< edges of the contacts
  bool forces = true;         ///< normal forces as arrows
  bool friction = true;       ///< friction as arrows, if there is any
  bool labels = true;         ///< highest pressure and area; highest stress and depth
  bool stress = true;         ///< sections of von Mises stress of patches with a stress field (stress_section.h)
  double max_stress = 1e9;    ///< von Mises stress at the upper end of its colour scale [Pa], > 0
  bool wheels = true;         ///< wheels and axle
  bool rails = true;          ///< deflected rails
  bool rails_at_rest = true;  ///< section of the undeflected rails
  bool status = false;        ///< status and its reason unless OK without a warning, as text ("status")
  bool scale = false;         ///< colour scales of the pressure ("scale") and of the drawn stress ("stress_scale")
  /// Magnification of the deflection of the rails [-], >= 0. A given displacement is drawn in its true size. Patches
  /// and trail move with the rail, the wheels do not.
  double deflection_scale = 1;
  double trail_width = 0.001;     ///< diameter of the points of the trail [m], > 0
  std::optional<double> drawn_x;  ///< place along the track at which the wheelset is drawn [m]; none: its own
  /// Frame in the track frame that becomes the origin of the picture, for example contactFrame().
  Eigen::Isometry3d view = Eigen::Isometry3d::Identity();
};

/// Contents of the picture that the node publishes on ~markers.
/// @param max_pressure upper end of the colour scale of the pressure (PressureScale) [Pa], > 0
/// @param max_stress upper end of that of the von Mises stress (PressureScale) [Pa], > 0
SceneOptions sceneOptions(const MarkerConfig& config, double max_pressure, double max_stress);

/// The result as it is drawn: with magnified deflections of the rails, and patches on these rails. Without patches and
/// with rails at rest if the output is not usable. It is only copied where it differs from the result of the output, to
/// which it may refer.
/// @param model null: deflections are not magnified
std::shared_ptr<const core::WheelsetResult> drawnResult(const ContactOutput& output,
                                                        const core::ContactModelConfig* model, double deflection_scale);

/// Markers of an output in the track frame: those of patch_markers.h and track_markers.h, and the points of the trail,
/// coloured by pressure ("trail"). An unusable output has no
/// patches; rails, trail and, if it has a pose, the wheelset remain.
/// @param model null: wheels and rails are not drawn, and deflections are not magnified
visualization_msgs::MarkerArray sceneMarkers(const ContactOutput& output, const core::ContactModelConfig* model,
                                             const ContactTrail& trail, const SceneOptions& options);
}  // namespace wheel_rail_contact
