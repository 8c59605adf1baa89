// SPDX-License-Identifier: BSD-3-Clause
// Rails of track_markers.h.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "core/balance/rail_support.h"
#include "ros/markers/marker_tools.h"
#include "ros/markers/track_markers.h"

namespace wheel_rail_contact
{
using Eigen::Vector3d;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace
{
constexpr int part_points = 60;           ///< number of drawn points of each part of a rail
constexpr double section_spacing = 0.05;  ///< of the drawn sections of a rail that changes along the line [m]
constexpr double same_part = 0.02;        ///< largest lateral distance of a part from one section to the next [m]

/// Points of a curve across the track, track frame [m].
using Outline = std::vector<Vector3d>;

/// Section of a rail at x: a curve for each of its parts.
std::vector<Outline> railOutlines(const core::PlacedRail& rail, core::Side side, double x)
{
  std::vector<Outline> outlines;
  for (const core::ParameterRange& part : rail.profile().parts())
  {
    outlines.emplace_back();
    for (int i = 0; i < part_points; ++i)
    {
      const core::PlanePoint p = rail.at(part.begin + (part.end - part.begin) * i / (part_points - 1));
      outlines.back().emplace_back(x, core::sideSign(side) * p.y, p.z);
    }
  }
  return outlines;
}

double middle(const Outline& outline)
{
  return 0.5 * (outline.front().y() + outline.back().y());
}

/// The same part of the rail in another section: the nearest one. Null if there is none.
const Outline* partNear(const Outline& part, const std::vector<Outline>& section)
{
  const auto distance = [&](const Outline& other) { return std::abs(middle(other) - middle(part)); };
  const auto nearest = std::min_element(section.begin(), section.end(),
                                        [&](const Outline& a, const Outline& b) { return distance(a) < distance(b); });
  return nearest != section.end() && distance(*nearest) < same_part ? &*nearest : nullptr;
}
}  // namespace

void addRails(const core::ContactModelConfig& model, const TrackStyle& style, const DrawnPlace& place,
              const core::Sides<core::RailDeflection>& deflection, MarkerArray& markers)
{
  for (const core::Side side : style.sides)
  {
    Marker marker = makeMarker("rail", static_cast<int>(side), Marker::TRIANGLE_LIST,
                               makeColor(0.62, 0.64, 0.67, style.rail_alpha));
    const double intervals = model.rail_sections[side] ? std::ceil(style.rail_length / section_spacing) : 1;
    std::vector<Outline> before;
    for (int i = 0; i <= static_cast<int>(intervals); ++i)
    {
      const double ahead = style.rail_length * (i / intervals - 0.5);
      const core::PlacedRail rail = core::restingRail(model, side, place.distance + ahead).deflected(deflection[side]);
      std::vector<Outline> section = railOutlines(rail, side, place.x + ahead);
      for (const Outline& part : before)
      {
        if (const Outline* next = partNear(part, section))
        {
          addSurface({part, *next}, side == core::Side::right, marker);
        }
      }
      before = std::move(section);
    }
    markers.markers.push_back(marker);
  }
}

void addRailsAtRest(const core::ContactModelConfig& model, const TrackStyle& style, const DrawnPlace& place,
                    MarkerArray& markers)
{
  for (const core::Side side : style.sides)
  {
    int id = static_cast<int>(side);
    for (const Outline& part : railOutlines(core::restingRail(model, side, place.distance), side, place.x))
    {
      Marker marker = makeMarker("rail_at_rest", id, Marker::LINE_STRIP, scene_colors::rail_at_rest);
      marker.scale.x = style.line_width;
      std::transform(part.begin(), part.end(), std::back_inserter(marker.points), toPoint);
      markers.markers.push_back(marker);
      id += 2;  // further parts: even on the left, odd on the right
    }
  }
}
}  // namespace wheel_rail_contact
