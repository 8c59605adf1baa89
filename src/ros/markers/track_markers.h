// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "config/node_config.h"
#include "core/track/placement.h"

namespace wheel_rail_contact
{
/// Style of rails and wheelset.
struct TrackStyle
{
  std::vector<core::Side> sides{core::Side::left, core::Side::right};  ///< sides that are drawn
  double rail_length = 0.4;                                            ///< drawn length of the rails [m], >= 0
  double wheel_sweep = 0.30;  ///< half the angle of the drawn part of a wheel about the axle [rad], in (0, pi]
  /// Only the part of the wheels ahead of their lowest line, without circles and axle: its rear end is the section of
  /// the wheel at the contact.
  bool wheel_cut = false;
  double wheel_alpha = 0.5;           ///< opacity of the wheel surface [-], in [0, 1]
  double profile_line_width = 0.004;  ///< width of the line along the wheel profile [m]
  double rail_alpha = 1;              ///< opacity of the rail surface [-], in [0, 1]
  double line_width = 0.002;          ///< width of the circles of the wheels and of a rail at rest [m]
};

/// Place along the track.
struct DrawnPlace
{
  double x = 0;         ///< in the picture, track frame [m]
  double distance = 0;  ///< on the line [m], see core::WheelsetState::distance
};

/// Rails as surfaces, centred at `place`: markers "rail". Sections that change along the line are drawn every 0.05 m.
/// @param deflection of each rail by Side; side axes
void addRails(const core::ContactModelConfig& model, const TrackStyle& style, const DrawnPlace& place,
              const core::Sides<core::RailDeflection>& deflection, visualization_msgs::MarkerArray& markers);

/// Section of the undeflected rails at `place`, as lines: markers "rail_at_rest".
void addRailsAtRest(const core::ContactModelConfig& model, const TrackStyle& style, const DrawnPlace& place,
                    visualization_msgs::MarkerArray& markers);

/// Wheelset: the lower part of each wheel as a surface ("wheel"); its profile at the rear end of the surface, as a line
/// ("wheel_profile"); two circles of each wheel as lines, and the axle as a thin cylinder ("wheel_lines"; none if cut).
/// @param x position of the axle centre along the track [m]
void addWheelset(const core::ContactModelConfig& model, const TrackStyle& style, double x,
                 const core::WheelsetPose& pose, visualization_msgs::MarkerArray& markers);

/// Markers that never change: both rails at rest as lines ("rail_at_rest"), at the beginning of the line.
visualization_msgs::MarkerArray profileMarkers(const NodeConfig& config);
}  // namespace wheel_rail_contact
