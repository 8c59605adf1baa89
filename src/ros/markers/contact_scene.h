// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "ros/evaluation/contact_evaluator.h"
#include "ros/markers/contact_trail.h"
#include "ros/markers/patch_markers.h"
#include "ros/markers/track_markers.h"
#include "ros/parameters/marker_config.h"

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
  bool labels = true;         ///< highest pressure and area
  bool wheels = true;         ///< wheels and axle
  bool rails = true;          ///< deflected rails
  bool rails_at_rest = true;  ///< section of the undeflected rails
  bool reason = false;        ///< reason of an unusable result, as text ("status")
  /// Magnification of the deflection of the rails [-], >= 0. A given displacement is drawn in its true size. Patches
  /// and trail move with the rail, the wheels do not.
  double deflection_scale = 1;
  double trail_width = 0.001;  ///< diameter of the points of the trail [m], > 0
  bool at_origin = false;      ///< draw the wheelset at x = 0
};

/// Contents of the picture that the node publishes on ~markers.
SceneOptions sceneOptions(const MarkerConfig& config);

/// Markers of an output in the track frame: those of patch_markers.h and track_markers.h, and the points of the trail,
/// coloured by pressure ("trail"). An output that is neither usable nor held has no markers except its reason; a held
/// one also has this marker.
/// @param model null: wheels and rails are not drawn, and deflections are not magnified
visualization_msgs::MarkerArray sceneMarkers(const ContactOutput& output, const core::ContactModelConfig* model,
                                             const ContactTrail& trail, const SceneOptions& options);
}  // namespace wheel_rail_contact
