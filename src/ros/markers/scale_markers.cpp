// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/scale_markers.h"

#include <cstdio>
#include <string>

#include "ros/markers/marker_tools.h"
#include "ros/markers/scene_colors.h"

namespace wheel_rail_contact
{
using Eigen::Vector3d;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace
{
constexpr int steps = 32, labels = 5;
constexpr double bottom = 0.06, height = 0.30, width = 0.03, letters = 0.035;  // [m]

/// Field of the bar between two heights [m].
void addField(double x, double low, double high, const std_msgs::ColorRGBA& below, const std_msgs::ColorRGBA& above,
              Marker& bar)
{
  addQuadrilateral({{x, 0, low}, {x, -width, low}, {x, -width, high}, {x, 0, high}}, {below, below, above, above}, bar);
}

Marker label(int number, const Vector3d& place, const std::string& text, const std_msgs::ColorRGBA& color,
             const std_msgs::Header& header)
{
  return makeText(header, "scale", number, place, letters, text, color);
}
}  // namespace

void addScale(double x, double max_pressure, double highest, const std_msgs::Header& header, MarkerArray& markers)
{
  Marker bar = makeMarker(header, "scale", 0, Marker::TRIANGLE_LIST, makeColor(1, 1, 1));
  for (int i = 0; i < steps; ++i)
  {
    const double low = static_cast<double>(i) / steps, high = static_cast<double>(i + 1) / steps;
    addField(x, bottom + height * low, bottom + height * high, colorOf(low), colorOf(high), bar);
  }
  char text[48];
  for (int i = 0; i < labels; ++i)
  {
    const double share = static_cast<double>(i) / (labels - 1);
    std::snprintf(text, sizeof text, i + 1 == labels ? "%.0f MPa" : "%.0f", share * max_pressure / 1e6);
    markers.markers.push_back(
        label(i + 1, {x, -width - 2.7 * letters, bottom + height * share}, text, scene_colors::text(), header));
  }
  if (highest > max_pressure)
  {
    const double top = bottom + height;
    addField(x, top, top + 2 * letters, aboveScaleColor(), aboveScaleColor(), bar);
    std::snprintf(text, sizeof text, "above scale: %.0f MPa", highest / 1e6);
    markers.markers.push_back(label(labels + 1, {x, -0.5 * width, top + 3 * letters}, text, aboveScaleColor(), header));
  }
  markers.markers.push_back(bar);
}
}  // namespace wheel_rail_contact
