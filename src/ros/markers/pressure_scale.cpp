// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/pressure_scale.h"

#include "config/text.h"
#include "ros/markers/marker_tools.h"

namespace wheel_rail_contact
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace
{
constexpr double unit = 1e9;                         ///< upper end of the scale, times a power of two [Pa]
constexpr double least_upper = 1e6;                  ///< smaller pressures do not make the scale smaller [Pa]
constexpr std::uint64_t fall_delay = 2'000'000'000;  ///< a lower end must be sufficient for this time [ns]

double smallestUpper(double highest)
{
  return unit * std::exp2(std::ceil(std::log2(std::max(highest, least_upper) / unit)));
}
}  // namespace

double PressureScale::update(const ros::Time& stamp, double highest)
{
  if (fixed_ > 0)
  {
    return fixed_;
  }
  if (stamp < last_)
  {
    upper_ = 0;
  }
  last_ = stamp;
  if (highest > 0)
  {
    const double wanted = smallestUpper(highest);
    if (wanted >= upper_ || stamp.toNSec() > needed_.toNSec() + fall_delay)
    {
      upper_ = wanted;
      needed_ = stamp;
    }
  }
  return upper_ > 0 ? upper_ : unit;
}

double highestPressure(const ContactOutput& output, const std::vector<core::Side>& sides)
{
  return highestOf(output, sides,
                   [](const core::PatchResult& patch) {
                     return std::max(patch.max_pressure, patch.pressure.size() > 0 ? patch.pressure.maxCoeff() : 0.0);
                   });
}

void addScale(const ColorScale& scale, const ScalePlace& place, MarkerArray& markers)
{
  constexpr int steps = 32, labels = 5;
  constexpr double bottom = 0.06, height = 0.30, width = 0.03, letters = 0.035;  // [m]
  Marker bar = makeMarker(scale.ns, 0, Marker::TRIANGLE_LIST, makeColor(1, 1, 1));
  const auto add_field =
      [&](double low, double high, const std_msgs::ColorRGBA& below, const std_msgs::ColorRGBA& above)
  {
    const double x = place.x, left = place.y, right = place.y - width;
    addQuadrilateral({{x, left, low}, {x, right, low}, {x, right, high}, {x, left, high}}, {below, below, above, above},
                     bar);
  };
  // y: relative to the left edge of the scale
  const auto add_text = [&](int number, double y, double z, const std::string& text, const std_msgs::ColorRGBA& color) {
    markers.markers.push_back(makeText(scale.ns, number, {place.x, place.y + y, z}, letters, text, color));
  };
  for (int i = 0; i < steps; ++i)
  {
    const double low = static_cast<double>(i) / steps, high = static_cast<double>(i + 1) / steps;
    add_field(bottom + height * low, bottom + height * high, colorOf(low), colorOf(high));
  }
  for (int i = 0; i < labels; ++i)
  {
    const double share = static_cast<double>(i) / (labels - 1);
    add_text(i + 1, -width - 2.7 * letters, bottom + height * share,
             formatted(i + 1 == labels ? "%.0f MPa" : "%.0f", share * scale.max / 1e6), scene_colors::text);
  }
  const double top = bottom + height;
  const bool above = scale.highest > scale.max;
  if (above)
  {
    add_field(top, top + 2 * letters, scene_colors::above_scale, scene_colors::above_scale);
    add_text(labels + 1, -0.5 * width, top + 3 * letters, formatted("above scale: %.0f MPa", scale.highest / 1e6),
             scene_colors::above_scale);
  }
  if (!scale.caption.empty())
  {
    add_text(labels + 2, -0.5 * width, top + (above ? 4.5 : 2) * letters, scale.caption, scene_colors::text);
  }
  markers.markers.push_back(bar);
}
}  // namespace wheel_rail_contact
