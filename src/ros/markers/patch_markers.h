// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <vector>

#include "ros/markers/pressure_surface.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// How patches are drawn.
struct PatchStyle
{
  double zoom = 30;               ///< magnification in the tangent plane [-], >= 0; at 0 there is nothing to magnify
  double lift = 0.18;             ///< of the magnified surface above the true patch [m], >= 0
  double pressure_height = 0.15;  ///< of the magnified surface at `max_pressure` [m], >= 0
  double max_pressure = 2e9;      ///< upper end of the colour scale [Pa], > 0
  int points = 36;                ///< least number of points of a magnified surface in either direction, > 0
  double force_scale = 2.5e-6;    ///< length of a force arrow [m/N], >= 0
  double arrow_width = 0.014;     ///< diameter of its shaft [m], > 0
  double letter_height = 0.052;   ///< of labels [m], > 0
  double line_width = 0.002;      ///< of lines [m], > 0
};

/// A patch and where its magnified picture stands.
struct PatchPicture
{
  const core::PatchResult* patch = nullptr;  ///< of the answer drawn
  int id = 0;                                ///< side * 16 + place of the patch in the answer's side
  Eigen::Isometry3d to_track;                ///< patch frame to track frame
  Eigen::Vector3d zoom_place;                ///< of the middle of the grid, magnified [m]
};

/// Patches of one side, ordered across the track. A magnified picture stands above its patch by the lift; those of
/// several patches stand side by side, unless the zoom is 1.
/// @param x of the axle's centre [m]
std::vector<PatchPicture> arrangePatches(const core::WheelsetResult& result, core::Side side, double x,
                                         const PatchStyle& style);

/// The pressure at as many points as a magnified picture has. The patch must have a grid.
PressureSurface fineSurface(const PatchPicture& picture, const PatchStyle& style);

/// Coloured by pressure, in true size on the rail: "patch".
visualization_msgs::Marker truePatch(const PatchPicture& picture, const PatchStyle& style,
                                     const std_msgs::Header& header);
/// Coloured by pressure, with the pressure as height, magnified: "zoom".
visualization_msgs::Marker zoomedPatch(const PatchPicture& picture, const PressureSurface& fine,
                                       const PatchStyle& style, const std_msgs::Header& header);
/// The edge of the contact, magnified: "outline".
visualization_msgs::Marker patchOutline(const PatchPicture& picture, const PressureSurface& fine,
                                        const PatchStyle& style, const std_msgs::Header& header);
/// From the true patch to the magnified one: "zoom_line".
visualization_msgs::Marker zoomLine(const PatchPicture& picture, const PatchStyle& style,
                                    const std_msgs::Header& header);
/// The wheel's force on the rail, from the patch into the rail: "force".
visualization_msgs::Marker forceArrow(const PatchPicture& picture, const PatchStyle& style,
                                      const std_msgs::Header& header);
/// Highest pressure and area above the magnified patch: "label".
visualization_msgs::Marker patchLabel(const PatchPicture& picture, const PatchStyle& style,
                                      const std_msgs::Header& header);
}  // namespace wheel_rail_contact
