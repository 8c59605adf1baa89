// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "ros/evaluation/contact_evaluator.h"
#include "ros/markers/patch_markers.h"

namespace wheel_rail_contact
{
/// Style of the sections of von Mises stress. Magnification, lift, lines and letters are those of PatchStyle.
struct StressStyle
{
  double max_stress = 1e9;  ///< von Mises stress at the upper end of the colour scale [Pa], > 0
  double rear = 0;          ///< x of the rear end of the drawn rails, track frame [m]
  bool labels = true;       ///< with text
};

/// Adds the von Mises stress of both bodies beneath the patches of a side that have a stress field
/// (StressConfig::field), on planes across the track: as colour (pressureColor(), "stress"); with the surface between
/// the bodies and a cross at the highest stress of each body ("stress_lines"); and as text with the highest stress of
/// each body and its depth ("stress_label").
///
/// The plane is that of the row of cells nearest to the highest von Mises stress. The rail is below the surface, the
/// wheel above it, both with the magnification of the patch. The surface is drawn flat, as the patch is.
///
/// A section is not drawn in its place, in which the rail and the surface of the pressure would hide it. Sections of
/// lifted patches are beside the magnified patches, towards the track centre. Other sections are displaced along the
/// track to the rear end of the rail.
/// @param pictures patches of a side, as arranged by arrangePatches()
void addStressSections(const std::vector<PatchPicture>& pictures, const PatchStyle& patch, const StressStyle& style,
                       visualization_msgs::MarkerArray& markers);

/// Highest von Mises stress of the sections of these sides [Pa]: that of the patches or of the points of their
/// sections, whichever is higher; 0 without a field.
double highestStress(const ContactOutput& output, const std::vector<core::Side>& sides);
}  // namespace wheel_rail_contact
