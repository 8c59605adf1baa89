// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_scene.h"

#include <algorithm>
#include <optional>

#include "ros/markers/color_map.h"
#include "ros/markers/marker_tools.h"
#include "ros/markers/rail_motion.h"

namespace wheel_rail_contact
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace
{
bool isShown(core::Side side, const SceneOptions& options)
{
  const auto& sides = options.track.sides;
  return std::find(sides.begin(), sides.end(), side) != sides.end();
}

/// The result with magnified rail deflections, and with patches that have moved with these rails.
core::WheelsetResult withMagnifiedDeflection(const core::WheelsetResult& result,
                                             const core::Sides<core::PlacedRail>& at_rest, double scale)
{
  core::WheelsetResult drawn = result;
  for (core::RailResult& rail : drawn.rail)
  {
    rail.deflection = magnified(rail, scale);
  }
  for (core::PatchResult& patch : drawn.patches)
  {
    const std::size_t k = index(patch.side);
    patch.pose = carriedByRail(at_rest[patch.side], patch.side, result.rail.at(k).deflection,
                               drawn.rail.at(k).deflection, patch.pose);
  }
  return drawn;
}

/// Surfaces and outline of the pressure of a patch.
void addPressure(const PatchPicture& picture, const SceneOptions& options, const std_msgs::Header& header,
                 MarkerArray& markers)
{
  const bool magnified = options.patches && options.patch.zoom > 0;
  if (magnified || options.outlines)
  {
    const PressureSurface fine = fineSurface(picture, options.patch);
    if (magnified)
    {
      markers.markers.push_back(zoomedPatch(picture, fine, options.patch, header));
    }
    if (options.outlines)
    {
      markers.markers.push_back(patchOutline(picture, fine, options.patch, header));
    }
  }
  if (options.patches && (options.patch.lift > 0 || !magnified))
  {
    markers.markers.push_back(truePatch(picture, options.patch, header));
  }
  if (magnified && options.patch.lift > 0)
  {
    markers.markers.push_back(zoomLine(picture, options.patch, header));
  }
}

void addPatch(const PatchPicture& picture, const SceneOptions& options, const std_msgs::Header& header,
              MarkerArray& markers)
{
  if (picture.patch->pressure.size() > 0 && (options.patches || options.outlines))
  {
    addPressure(picture, options, header, markers);
  }
  if (options.forces && options.patch.force_scale * picture.patch->normal_force > 0)
  {
    markers.markers.push_back(forceArrow(picture, options.patch, header));
  }
  if (options.labels)
  {
    markers.markers.push_back(patchLabel(picture, options.patch, header));
  }
}

/// @param shift displacement of the drawn points along the track [m]
void addTrail(const ContactTrail& trail, const core::WheelsetResult& drawn,
              const std::optional<core::Sides<core::PlacedRail>>& at_rest, double shift, const SceneOptions& options,
              const std_msgs::Header& header, MarkerArray& markers)
{
  Marker marker = makeMarker(header, "trail", 0, Marker::SPHERE_LIST, makeColor(1, 1, 1));
  marker.scale.x = marker.scale.y = marker.scale.z = options.trail_width;
  for (const TrailPoint& point : trail.points())
  {
    if (isShown(point.side, options))
    {
      const core::RailDeflection& now = drawn.rail.at(static_cast<std::size_t>(point.side)).deflection;
      const core::PatchPose pose =
          at_rest ? carriedByRail((*at_rest)[point.side], point.side, {}, now, point.pose) : point.pose;
      marker.points.push_back(toPoint({pose.x + shift, pose.y, pose.z}));
      marker.colors.push_back(colorOf(point.max_pressure / options.patch.max_pressure));
    }
  }
  if (!marker.points.empty())
  {
    markers.markers.push_back(marker);
  }
}

void addTrack(const core::ContactModelConfig& model, const core::WheelsetResult& drawn, const core::WheelsetPose& pose,
              const DrawnPlace& place, const SceneOptions& options, const std_msgs::Header& header,
              MarkerArray& markers)
{
  if (options.rails)
  {
    addRails(model, options.track, header, place, {drawn.rail[0].deflection, drawn.rail[1].deflection}, markers);
  }
  if (options.rails_at_rest)
  {
    const double behind = 0.5 * options.track.rail_length;
    addRailsAtRest(model, options.track, header, {place.x - behind, place.distance - behind}, markers);
  }
  if (options.wheels)
  {
    addWheelset(model, options.track, header, place.x, pose, markers);
  }
}
}  // namespace

SceneOptions sceneOptions(const MarkerConfig& config)
{
  SceneOptions options;
  options.patch.zoom = config.zoom;
  options.patch.lift = config.zoom_height;
  options.patch.pressure_height = config.pressure_height;
  options.patch.max_pressure = config.max_pressure;
  options.patch.force_scale = config.force_scale;
  options.track.rail_length = config.rail_length;
  options.outlines = false;
  options.rails_at_rest = false;
  options.reason = true;
  return options;
}

MarkerArray sceneMarkers(const ContactOutput& output, const core::ContactModelConfig* model, const ContactTrail& trail,
                         const SceneOptions& options)
{
  MarkerArray markers;
  if (options.reason && (!output.result || output.held))
  {
    markers.markers.push_back(makeText(output.header, "status", 0, {output.x(), 0, options.patch.lift},
                                       options.patch.letter_height, output.reason));
  }
  if (!output.result)
  {
    return markers;
  }
  const double x = options.at_origin ? 0 : output.x();
  const std::optional<core::Sides<core::PlacedRail>> at_rest = restingRails(model, output.state.distance);
  std::optional<core::WheelsetResult> magnified_result;
  if (at_rest && options.deflection_scale != 1)
  {
    magnified_result = withMagnifiedDeflection(*output.result, *at_rest, options.deflection_scale);
  }
  const core::WheelsetResult& drawn = magnified_result ? *magnified_result : *output.result;
  if (model)
  {
    addTrack(*model, drawn, output.pose(), {x, output.state.distance}, options, output.header, markers);
  }
  for (const core::Side side : options.track.sides)
  {
    for (const PatchPicture& picture : arrangePatches(drawn, side, x, options.patch))
    {
      addPatch(picture, options, output.header, markers);
    }
  }
  addTrail(trail, drawn, at_rest, x - output.x(), options, output.header, markers);
  return markers;
}
}  // namespace wheel_rail_contact
