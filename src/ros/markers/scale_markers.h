// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

namespace wheel_rail_contact
{
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

/// Colour scale between the rails, with labels in MPa. If a value is above the scale, a field in aboveScaleColor() and
/// the highest value are above its upper end.
void addScale(const ColorScale& scale, const ScalePlace& place, const std_msgs::Header& header,
              visualization_msgs::MarkerArray& markers);
}  // namespace wheel_rail_contact
