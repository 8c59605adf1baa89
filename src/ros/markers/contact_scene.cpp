// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_scene.h"

#include "ros/evaluation/result_text.h"
#include "ros/markers/marker_tools.h"
#include "ros/markers/pressure_scale.h"
#include "ros/markers/rail_motion.h"
#include "ros/markers/stress_section.h"

namespace wheel_rail_contact
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace
{
constexpr std::size_t status_width = 50;  ///< of the lines of the status [characters]
constexpr double status_height = 0.60;    ///< of the status above the track plane [m]
constexpr double stress_scale_y = 0.30;   ///< of the colour scale of the stress, beside that of the pressure [m]

bool isShown(core::Side side, const SceneOptions& options)
{
  const auto& sides = options.track.sides;
  return std::find(sides.begin(), sides.end(), side) != sides.end();
}

bool drawsStress(const SceneOptions& options)
{
  return options.stress && options.patch.zoom > 0;
}

/// Surfaces and outline of the pressure of a patch.
void addPressure(const PatchPicture& picture, const SceneOptions& options, MarkerArray& markers)
{
  const bool magnified = options.patches && options.patch.zoom > 0;
  if (magnified || options.outlines)
  {
    const PressureSurface fine = fineSurface(picture, options.patch);
    if (magnified)
    {
      markers.markers.push_back(zoomedPatch(picture, fine, options.patch));
    }
    if (options.outlines)
    {
      markers.markers.push_back(patchOutline(picture, fine, options.patch));
    }
  }
  if (options.patches && (options.patch.lift > 0 || !magnified))
  {
    markers.markers.push_back(truePatch(picture, options.patch));
  }
  if (magnified && options.patch.lift > 0)
  {
    markers.markers.push_back(zoomLine(picture, options.patch));
  }
}

void addPatch(const PatchPicture& picture, const SceneOptions& options, MarkerArray& markers)
{
  if (picture.patch->pressure.size() > 0 && (options.patches || options.outlines))
  {
    addPressure(picture, options, markers);
  }
  if (options.forces && options.patch.force_scale * picture.patch->normal_force > 0)
  {
    markers.markers.push_back(forceArrow(picture, options.patch));
  }
  const core::CreepForce& friction = picture.patch->creep.force;
  if (options.friction && options.patch.force_scale * std::hypot(friction.x, friction.y) > 0)
  {
    const bool covered = options.patches && options.patch.zoom > 0 && options.patch.lift == 0;
    markers.markers.push_back(frictionArrow(picture, options.patch, covered));
  }
  if (options.labels)
  {
    markers.markers.push_back(patchLabel(picture, options.patch));
  }
}

/// @param pictures patches of a side
/// @param x position of the axle centre in the picture [m]
void addStress(const std::vector<PatchPicture>& pictures, double x, const SceneOptions& options, MarkerArray& markers)
{
  StressStyle style;
  style.max_stress = options.max_stress;
  style.rear = x - 0.5 * options.track.rail_length;
  style.labels = options.labels;
  addStressSections(pictures, options.patch, style, markers);
}

/// @param x position of the axle centre in the picture [m]
void addScales(const ContactOutput& output, double x, const SceneOptions& options, MarkerArray& markers)
{
  const double stress = drawsStress(options) ? highestStress(output, options.track.sides) : 0;
  ColorScale scale;
  scale.max = options.patch.max_pressure;
  scale.highest = highestPressure(output, options.track.sides);
  scale.caption = stress > 0 ? "pressure" : "";
  addScale(scale, {x, 0}, markers);
  if (stress > 0)
  {
    addScale({"stress_scale", "von Mises stress", options.max_stress, stress}, {x, stress_scale_y}, markers);
  }
}

/// @param shift displacement of the drawn points along the track [m]
void addTrail(const ContactTrail& trail, const core::WheelsetResult& drawn,
              const std::optional<core::Sides<core::PlacedRail>>& at_rest, double shift, const SceneOptions& options,
              MarkerArray& markers)
{
  Marker marker =
      makeMarker("trail", static_cast<int>(options.track.sides.front()), Marker::SPHERE_LIST, makeColor(1, 1, 1));
  marker.scale.x = marker.scale.y = marker.scale.z = options.trail_width;
  Marker ways = marker;
  ways.ns = "trail ways";
  ways.type = Marker::LINE_LIST;
  ways.scale.x *= 2;
  for (const TrailPoint& point : trail.points())
  {
    if (isShown(point.side, options))
    {
      const core::RailDeflection& now = drawn.rail[point.side].deflection;
      const core::PatchPose pose =
          at_rest ? carriedByRail((*at_rest)[point.side], point.side, {}, now, point.pose) : point.pose;
      marker.points.push_back(toPoint({pose.x + shift, pose.y, pose.z}));
      marker.colors.push_back(pressureColor(point.max_pressure, options.patch.max_pressure));
      const double z = pose.z + options.trail_width;  // above the rail, which would hide the line
      ways.points.insert(ways.points.end(),
                         {toPoint({pose.x + shift, pose.y, z}), toPoint({pose.x + shift - point.way, pose.y, z})});
      ways.colors.insert(ways.colors.end(), 2, marker.colors.back());
    }
  }
  if (!marker.points.empty())
  {
    markers.markers.insert(markers.markers.end(), {marker, ways});
  }
}

/// @param pose null: without the wheelset
void addTrack(const core::ContactModelConfig& model, const core::WheelsetResult& drawn, const core::WheelsetPose* pose,
              const DrawnPlace& place, const SceneOptions& options, MarkerArray& markers)
{
  if (options.rails)
  {
    addRails(model, options.track, place, {drawn.rail.left.deflection, drawn.rail.right.deflection}, markers);
  }
  if (options.rails_at_rest)
  {
    const double behind = 0.5 * options.track.rail_length;
    addRailsAtRest(model, options.track, {place.x - behind, place.distance - behind}, markers);
  }
  if (options.wheels && pose)
  {
    addWheelset(model, options.track, place.x, *pose, markers);
  }
}

/// Status and reason of an output that is not OK, or of a warning, above the axle.
void addStatus(const ContactOutput& output, double x, const SceneOptions& options, MarkerArray& markers)
{
  const std::vector<TextLine> lines = statusLines(output, status_width);
  const Tone tone = lines.front().tone;
  if (tone != Tone::normal)
  {
    std::string text;
    for (const TextLine& line : lines)
    {
      text += (text.empty() ? "" : "\n") + line.text;
    }
    const std_msgs::ColorRGBA color = tone == Tone::error ? scene_colors::error : scene_colors::warning;
    markers.markers.push_back(makeText("status", 0, {x, 0, status_height}, options.patch.letter_height, text, color));
  }
}
}  // namespace

SceneOptions sceneOptions(const MarkerConfig& config, double max_pressure, double max_stress)
{
  SceneOptions options;
  options.patch.zoom = config.zoom;
  options.patch.lift = config.zoom_height;
  options.patch.pressure_height = config.pressure_height;
  options.patch.max_pressure = max_pressure;
  options.max_stress = max_stress;
  options.patch.force_scale = config.force_scale;
  options.track.rail_length = config.rail_length;
  options.outlines = false;
  options.rails_at_rest = false;
  options.status = true;
  options.scale = true;
  return options;
}

std::shared_ptr<const core::WheelsetResult> drawnResult(const ContactOutput& output,
                                                        const core::ContactModelConfig* model, double deflection_scale)
{
  if (!output.result)
  {
    return std::make_shared<core::WheelsetResult>();
  }
  const std::optional<core::Sides<core::PlacedRail>> at_rest = restingRails(model, output.state.distance);
  if (at_rest && deflection_scale != 1)
  {
    return std::make_shared<core::WheelsetResult>(withMagnifiedDeflection(*output.result, *at_rest, deflection_scale));
  }
  return output.result;
}

MarkerArray sceneMarkers(const ContactOutput& output, const core::ContactModelConfig* model, const ContactTrail& trail,
                         const SceneOptions& options)
{
  MarkerArray markers;
  const double x = options.drawn_x.value_or(output.x());
  const std::shared_ptr<const core::WheelsetResult> result = drawnResult(output, model, options.deflection_scale);
  const core::WheelsetResult& drawn = *result;
  if (model)
  {
    const core::WheelsetPose pose = output.pose();
    addTrack(*model, drawn, hasPose(output) ? &pose : nullptr, {x, output.state.distance}, options, markers);
  }
  for (const core::Side side : options.track.sides)
  {
    const std::vector<PatchPicture> pictures = arrangePatches(drawn, side, x, options.patch);
    for (const PatchPicture& picture : pictures)
    {
      addPatch(picture, options, markers);
    }
    if (drawsStress(options))
    {
      addStress(pictures, x, options, markers);
    }
  }
  addTrail(trail, drawn, restingRails(model, output.state.distance), x - output.x(), options, markers);
  if (options.scale)
  {
    addScales(output, x, options, markers);
  }
  if (options.status)
  {
    addStatus(output, x, options, markers);
  }
  move(options.view.inverse(), markers);
  setHeader(output.header, markers);
  return markers;
}
}  // namespace wheel_rail_contact
