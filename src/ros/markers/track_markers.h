// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <array>
#include <vector>

#include "core/track/placement.h"
#include "ros/parameters/parameters.h"

namespace wheel_rail_contact
{
/// How rails and wheelset are drawn.
struct TrackStyle
{
  std::vector<core::Side> sides{core::Side::left, core::Side::right};  ///< those drawn
  double rail_length = 0.4;                                            ///< [m], >= 0
  double wheel_sweep = 0.30;          ///< half the drawn part of a tread, about the axle [rad], in (0, pi]
  double wheel_alpha = 0.5;           ///< of the tread [-], in [0, 1]
  double profile_line_width = 0.004;  ///< [m]
  double rail_alpha = 1;              ///< of the rails' surface [-], in [0, 1]
  double line_width = 0.002;          ///< of the wheels' circles and of a rail at rest [m]
};

/// The rails, deflected as given by Side, as short surfaces about `header`'s x = `x` [m]: markers "rail".
void addRails(const core::ContactModelConfig& model, const TrackStyle& style, const std_msgs::Header& header, double x,
              const std::array<core::RailDeflection, 2>& deflection, visualization_msgs::MarkerArray& markers);

/// The rails at rest, their section at `x` [m] as a line: markers "rail_at_rest".
void addRailsAtRest(const core::ContactModelConfig& model, const TrackStyle& style, const std_msgs::Header& header,
                    double x, visualization_msgs::MarkerArray& markers);

/// The wheelset: the part of each tread that is near the rail as surface, with the profile along its rear end; circles
/// of each wheel and the axle as lines: markers "wheel", "wheel_profile", "wheel_lines".
void addWheelset(const core::ContactModelConfig& model, const TrackStyle& style, const std_msgs::Header& header,
                 double x, const core::WheelsetPose& pose, visualization_msgs::MarkerArray& markers);

/// What does not change: both rails at rest as lines ("rail_at_rest") and the scale of pressure colours ("scale").
visualization_msgs::MarkerArray profileMarkers(const NodeConfig& config);
}  // namespace wheel_rail_contact
