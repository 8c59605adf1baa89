// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <vector>

#include "ros/markers/pressure_surface.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// Style of the patches.
struct PatchStyle
{
  double zoom = 15;               ///< magnification in the tangent plane [-], >= 0; 0: no magnified surface
  double lift = 0.12;             ///< height of the magnified surface above the true patch [m], >= 0; 0: replaces it
  double pressure_height = 0.10;  ///< height of the magnified surface at `max_pressure` [m], >= 0
  double max_pressure = 1e9;      ///< pressure at the upper end of the colour scale [Pa], > 0
  int points = 36;                ///< minimum number of points of a magnified surface in each direction, > 0
  double force_scale = 2.5e-6;    ///< length of a force arrow [m/N], >= 0
  double arrow_width = 0.014;     ///< diameter of the shaft of an arrow [m], > 0
  double letter_height = 0.034;   ///< height of the letters of labels [m], > 0
  double line_width = 0.002;      ///< width of lines [m], > 0
};

/// A patch and the position of its magnified picture.
struct PatchPicture
{
  const core::PatchResult* patch = nullptr;  ///< patch of the drawn result
  int id = 0;                                ///< 16 * side + index among the patches of the side
  Eigen::Isometry3d to_track;                ///< transform from the patch frame to the track frame
  Eigen::Vector3d zoom_place;                ///< centre of the magnified grid, track frame [m]
  Eigen::Matrix3d zoom_turn;                 ///< rotation of the magnified picture to the track frame
};

/// Patches of one side, in order of y. A magnified picture is above its patch by the lift. A lifted one lies flat in
/// the track plane, so that the picture of a steep patch does not cover the rail. The pictures of several patches are
/// placed side by side if the zoom is above 1.
/// @param x position of the axle centre along the track [m]
std::vector<PatchPicture> arrangePatches(const core::WheelsetResult& result, core::Side side, double x,
                                         const PatchStyle& style);

/// Pressure at the points of a magnified picture. The patch must have a grid.
PressureSurface fineSurface(const PatchPicture& picture, const PatchStyle& style);

/// Patch in true size on the rail, coloured by pressure (pressureColor()): "patch".
visualization_msgs::Marker truePatch(const PatchPicture& picture, const PatchStyle& style);
/// Magnified patch, with the pressure as height and colour: "zoom". Above the scale the height remains that of the
/// upper end, and the colour is scene_colors::above_scale.
visualization_msgs::Marker zoomedPatch(const PatchPicture& picture, const PressureSurface& fine,
                                       const PatchStyle& style);
/// Edge of the contact, magnified: "outline".
visualization_msgs::Marker patchOutline(const PatchPicture& picture, const PressureSurface& fine,
                                        const PatchStyle& style);
/// Line from the true patch to the magnified one: "zoom_line".
visualization_msgs::Marker zoomLine(const PatchPicture& picture, const PatchStyle& style);
/// Normal force of the wheel on the rail, as an arrow from the patch into the rail: "force".
visualization_msgs::Marker forceArrow(const PatchPicture& picture, const PatchStyle& style);
/// Friction of the wheel on the rail, as an arrow from the patch in its tangent plane: "friction".
/// @param above_surface true: above the surface of the pressure, which would hide it
visualization_msgs::Marker frictionArrow(const PatchPicture& picture, const PatchStyle& style, bool above_surface);
/// Highest pressure, a note if it is above the scale, and area above the magnified patch: "label".
visualization_msgs::Marker patchLabel(const PatchPicture& picture, const PatchStyle& style);
}  // namespace wheel_rail_contact
