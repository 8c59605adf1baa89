// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/track_markers.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/constants.h"
#include "ros/evaluation/conversions.h"
#include "ros/markers/marker_tools.h"

namespace wheel_rail_contact
{
using Eigen::Vector3d;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace
{
constexpr int profile_points = 60;     ///< number of drawn points of a profile
constexpr double row_spacing = 0.075;  ///< angle between rows of points on a wheel, about the axle [rad]
constexpr int circle_points = 96;
constexpr double axle_radius = 0.008;  ///< much smaller than the true radius, so that the axle hides nothing [m]

std_msgs::ColorRGBA wheelColor(double alpha)
{
  return makeColor(0.60, 0.75, 0.95, alpha);
}

std_msgs::ColorRGBA lineColor()
{
  return makeColor(0.62, 0.70, 0.80, 0.35);
}

/// Angle of the rear end of the drawn part of a wheel [rad].
double rearEnd(const TrackStyle& style)
{
  return style.wheel_cut ? 0.0 : -style.wheel_sweep;
}

double parameterAt(const core::Profile& profile, int i)
{
  return profile.length() * i / (profile_points - 1);
}

Eigen::Isometry3d toTrack(const core::WheelsetPose& pose, double x)
{
  return Eigen::Translation3d(x, pose.y, pose.z) * Eigen::AngleAxisd(pose.yaw, Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pose.roll, Vector3d::UnitX());
}

/// Point of a wheel in the frame of the wheelset [m].
/// @param turn angle about the axle, from the lowest point forward [rad]
Vector3d wheelPoint(const core::WheelsetConfig& wheelset, core::Side side, const core::CurvePoint& p, double turn)
{
  const double radius = wheelset.rolling_radius[side] - p.z;
  return {radius * std::sin(turn), core::sideSign(side) * (wheelset.halfBase() + p.y), -radius * std::cos(turn)};
}

Marker tread(const core::ContactModelConfig& model, const TrackStyle& style, core::Side side,
             const Eigen::Isometry3d& to_track)
{
  const double begin = rearEnd(style), angle = style.wheel_sweep - begin;
  const int intervals = std::max(1, static_cast<int>(std::lround(angle / row_spacing)));
  Marker marker = makeMarker("wheel", static_cast<int>(side), Marker::TRIANGLE_LIST, wheelColor(style.wheel_alpha));
  const core::Profile& profile = *model.wheel_profile[side];
  SurfacePoints points;
  for (int row = 0; row <= intervals; ++row)
  {
    const double turn = begin + angle * row / intervals;
    points.emplace_back();
    for (int i = 0; i < profile_points; ++i)
    {
      const core::CurvePoint p = profile.at(parameterAt(profile, i));
      points.back().push_back(to_track * wheelPoint(model.wheelset, side, p, turn));
    }
  }
  addSurface(points, side == core::Side::left, marker);
  return marker;
}

/// Wheel profile at the rear end of the drawn surface, behind the contact.
Marker wheelProfile(const core::ContactModelConfig& model, const TrackStyle& style, core::Side side,
                    const Eigen::Isometry3d& to_track)
{
  Marker marker = makeMarker("wheel_profile", static_cast<int>(side), Marker::LINE_STRIP, scene_colors::wheel_section);
  marker.scale.x = style.profile_line_width;
  const core::Profile& profile = *model.wheel_profile[side];
  for (int i = 0; i < profile_points; ++i)
  {
    const core::CurvePoint p = profile.at(parameterAt(profile, i));
    marker.points.push_back(toPoint(to_track * wheelPoint(model.wheelset, side, p, rearEnd(style))));
  }
  return marker;
}

void addSegment(const Vector3d& begin, const Vector3d& end, Marker& marker)
{
  marker.points.push_back(toPoint(begin));
  marker.points.push_back(toPoint(end));
}

/// Circles of a wheel through the flange tip and through the end of the profile, as a LINE_LIST.
Marker circles(const core::ContactModelConfig& model, const TrackStyle& style, core::Side side,
               const Eigen::Isometry3d& to_track)
{
  Marker marker = makeMarker("wheel_lines", static_cast<int>(side), Marker::LINE_LIST, lineColor());
  marker.scale.x = style.line_width;
  const core::Profile& profile = *model.wheel_profile[side];
  core::CurvePoint tip = profile.at(0);
  for (int i = 0; i < profile_points; ++i)
  {
    const core::CurvePoint p = profile.at(parameterAt(profile, i));
    tip = p.z < tip.z ? p : tip;
  }
  for (const core::CurvePoint& p : {tip, profile.at(profile.length())})
  {
    for (int i = 0; i < circle_points; ++i)
    {
      const double step = 2 * core::pi / circle_points;
      addSegment(to_track * wheelPoint(model.wheelset, side, p, i * step),
                 to_track * wheelPoint(model.wheelset, side, p, (i + 1) * step), marker);
    }
  }
  return marker;
}

Marker axle(const core::ContactModelConfig& model, const Eigen::Isometry3d& to_track)
{
  Marker marker = makeMarker("wheel_lines", 2, Marker::CYLINDER, lineColor());
  const Eigen::Quaterniond turned(to_track.linear() *
                                  Eigen::AngleAxisd(0.5 * core::pi, Vector3d::UnitX()).toRotationMatrix());
  marker.pose.position = toPoint(to_track.translation());
  marker.pose.orientation = toMessage(turned);
  marker.scale.x = marker.scale.y = 2 * axle_radius;
  marker.scale.z = 2 * model.wheelset.halfBase();
  return marker;
}
}  // namespace

void addWheelset(const core::ContactModelConfig& model, const TrackStyle& style, double x,
                 const core::WheelsetPose& pose, MarkerArray& markers)
{
  const Eigen::Isometry3d to_track = toTrack(pose, x);
  for (const core::Side side : style.sides)
  {
    markers.markers.push_back(tread(model, style, side, to_track));
    markers.markers.push_back(wheelProfile(model, style, side, to_track));
    if (!style.wheel_cut)
    {
      markers.markers.push_back(circles(model, style, side, to_track));
    }
  }
  if (!style.wheel_cut)
  {
    markers.markers.push_back(axle(model, to_track));
  }
}

MarkerArray profileMarkers(const NodeConfig& config)
{
  MarkerArray markers;
  addRailsAtRest(config.model, TrackStyle(), {-0.5 * config.markers.rail_length, 0}, markers);
  std_msgs::Header header;
  header.frame_id = config.track_frame;
  setHeader(header, markers);
  return markers;
}
}  // namespace wheel_rail_contact
