// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "ros/markers/contact_trail.h"
#include "ros/markers/marker_config.h"
#include "ros/markers/patch_markers.h"
#include "ros/markers/track_markers.h"
#include "ros/node/contact_evaluator.h"

namespace wheel_rail_contact
{
/// Contents of a picture. `track` holds the sides that are drawn.
struct SceneOptions
{
  PatchStyle patch;             ///< how patches are drawn
  TrackStyle track;             ///< how wheels and rails are drawn
  bool patches = true;          ///< pressure as surfaces: magnified, and in true size where that is elsewhere
  bool outlines = true;         ///< edges of the contacts
  bool forces = true;           ///< normal forces as arrows
  bool labels = true;           ///< highest pressure and area
  bool wheels = true;           ///< and the axle
  bool rails = true;            ///< as they are deflected
  bool ghost = true;            ///< the rails at rest
  bool reason = false;          ///< of an unusable result, as text ("status")
  double deflection_scale = 1;  ///< of the rails [-], >= 0; patches and trail move with the rail, the wheels do not
  double trail_width = 0.001;   ///< diameter of the points of the trail [m], > 0
  bool at_origin = false;       ///< the wheelset is drawn at x = 0
};

/// Contents of the picture that the node publishes on ~markers.
SceneOptions sceneOptions(const MarkerConfig& config);

/// The picture of an output in the track frame, as markers (see patch_markers.h and track_markers.h) and the points of
/// the trail, coloured by pressure ("trail"). An unusable output gives no markers except its reason.
/// @param model null: neither wheels nor rails are drawn, and deflections are not exaggerated
visualization_msgs::MarkerArray sceneMarkers(const ContactOutput& output, const core::ContactModelConfig* model,
                                             const ContactTrail& trail, const SceneOptions& options);
}  // namespace wheel_rail_contact
