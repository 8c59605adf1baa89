// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ros/evaluation/contact_evaluator.h"

namespace wheel_rail_contact
{
/// Upper end of the colour scale of a pressure or a stress: fixed, or following the values of the results. A stress is
/// treated as a pressure.
///
/// An upper end that follows is 1 GPa times a power of two. It rises with the first pressure above it. It falls after
/// two seconds in which half of it was sufficient, so that a reader can follow it. Time that goes back restarts it.
class PressureScale
{
 public:
  /// @param fixed upper end [Pa], >= 0; 0: it follows
  explicit PressureScale(double fixed) : fixed_(fixed) {}

  /// Fixed upper end [Pa]; 0: it follows.
  double fixed() const { return fixed_; }
  /// Upper end for a result [Pa], > 0.
  /// @param stamp time of the result
  /// @param highest highest pressure of the result [Pa]; 0 (no patch) does not change the scale
  double update(const ros::Time& stamp, double highest);

 private:
  double fixed_;             ///< [Pa]
  double upper_ = 0;         ///< current upper end [Pa]; 0: no pressure so far
  ros::Time needed_, last_;  ///< last results that needed the current upper end, and last result
};

/// Highest value of the patches of these sides; 0 without patches.
template <typename Value>
double highestOf(const ContactOutput& output, const std::vector<core::Side>& sides, const Value& value)
{
  double highest = 0;
  for (std::size_t i = 0; output.result && i < output.result->patches.size(); ++i)
  {
    const core::PatchResult& patch = output.result->patches[i];
    const bool is_drawn = std::find(sides.begin(), sides.end(), patch.side) != sides.end();
    highest = is_drawn ? std::max(highest, value(patch)) : highest;
  }
  return highest;
}

/// Highest pressure of the patches of these sides [Pa]: that of the result or of its cells, whichever is higher; 0
/// without patches.
double highestPressure(const ContactOutput& output, const std::vector<core::Side>& sides);

/// Colour scale of a pressure or a stress.
struct ColorScale
{
  std::string ns = "scale";  ///< namespace of its markers
  std::string caption;       ///< above the scale; empty: none
  double max = 1e9;          ///< upper end [Pa], > 0
  double highest = 0;        ///< highest drawn value [Pa]
};

/// Place of a colour scale, track frame.
struct ScalePlace
{
  double x = 0;  ///< [m]
  double y = 0;  ///< of the left edge [m]
};

/// Colour scale between the rails, with labels in MPa. If a value is above the scale, a field in
/// scene_colors::above_scale and the highest value are above its upper end.
void addScale(const ColorScale& scale, const ScalePlace& place, visualization_msgs::MarkerArray& markers);
}  // namespace wheel_rail_contact
