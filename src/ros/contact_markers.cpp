// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/ros/contact_markers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "wheel_rail_contact/ros/color_map.h"
#include "wheel_rail_contact/ros/marker_tools.h"
#include "wheel_rail_contact/ros/pressure_surface.h"
#include "wheel_rail_contact/ros/track_markers.h"

namespace wheel_rail_contact
{
using Eigen::Vector3d;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace
{
constexpr int ids_per_side = 16;
constexpr double true_size_lift = 2e-4;  ///< of the patch over the rail, so that both can be seen [m]
constexpr double arrow_shaft = 0.014;    ///< diameter [m]
constexpr double arrow_head = 0.035;     ///< diameter and length [m]
constexpr double label_height = 0.052;   ///< of letters [m]
constexpr int zoomed_points = 36;        ///< least number of points of a magnified surface in either direction
constexpr double zoom_spacing = 0.05;    ///< between magnified patches [m]

/// A patch and where its magnified picture stands.
struct PatchPicture
{
  const PatchResult* patch = nullptr;
  int id = 0;
  Eigen::Isometry3d to_track;  ///< patch frame to track frame
  Vector3d zoom_place;         ///< of the patch frame's origin, magnified [m]
};

double zoomedWidth(const PatchResult& patch, double zoom)
{
  return zoom * patch.grid.ny * patch.grid.dy;
}

Eigen::Isometry3d toTrack(const PatchPose& pose, double x)
{
  return Eigen::Translation3d(x + pose.x, pose.y, pose.z) * Eigen::AngleAxisd(pose.angle, Vector3d::UnitX());
}

/// Patches of one side, ordered across the track, their magnified pictures side by side above the rail.
std::vector<PatchPicture> arrange(const ContactAnswer& answer, const NodeConfig& config, Side side)
{
  std::vector<PatchPicture> pictures;
  for (const PatchResult& patch : answer.result->patches)
  {
    if (patch.side == side)
    {
      const int id = static_cast<int>(side) * ids_per_side + static_cast<int>(pictures.size());
      const Eigen::Isometry3d to_track = toTrack(patch.pose, answer.x);
      pictures.push_back({&patch, id, to_track, to_track.translation()});
    }
  }
  std::sort(pictures.begin(), pictures.end(),
            [](const PatchPicture& a, const PatchPicture& b)
            { return a.to_track.translation().y() < b.to_track.translation().y(); });

  double width = -zoom_spacing, middle = 0;
  for (const PatchPicture& picture : pictures)
  {
    width += zoomedWidth(*picture.patch, config.markers.zoom) + zoom_spacing;
    middle += picture.to_track.translation().y() / static_cast<double>(pictures.size());
  }
  double edge = middle - 0.5 * width;
  for (PatchPicture& picture : pictures)
  {
    const double own = zoomedWidth(*picture.patch, config.markers.zoom);
    picture.zoom_place.y() = edge + 0.5 * own;
    picture.zoom_place.z() += config.markers.zoom_height;
    edge += own + zoom_spacing;
  }
  return pictures;
}

/// Surface magnified about the patch frame's origin: height and colour by pressure. Only quadrilaterals with a corner
/// under pressure are drawn.
void addPressure(const PressureSurface& surface, double zoom, double height, double max_pressure,
                 const Eigen::Isometry3d& to_track, Marker& marker)
{
  const auto share = [&](int i, int j) { return std::min(surface.pressure(i, j) / max_pressure, 1.0); };
  const auto corner = [&](int i, int j)
  { return Vector3d(to_track * Vector3d(zoom * surface.x(i), zoom * surface.y(j), height * share(i, j))); };
  for (int i = 0; i + 1 < surface.rows(); ++i)
  {
    for (int j = 0; j + 1 < surface.columns(); ++j)
    {
      const std::array<double, 4> shares{share(i, j), share(i + 1, j), share(i + 1, j + 1), share(i, j + 1)};
      if (*std::max_element(shares.begin(), shares.end()) > 0)
      {
        addQuadrilateral({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)},
                         {colorOf(shares[0]), colorOf(shares[1]), colorOf(shares[2]), colorOf(shares[3])}, marker);
      }
    }
  }
}

Marker surface(const PatchPicture& picture, const NodeConfig& config, const std_msgs::Header& header)
{
  Marker marker = makeMarker(header, "patch", picture.id, Marker::TRIANGLE_LIST, makeColor(1, 1, 1));
  const Eigen::Isometry3d lifted = picture.to_track * Eigen::Translation3d(0, 0, true_size_lift);
  addPressure({picture.patch->grid, picture.patch->pressure, 1}, 1, 0, config.markers.max_pressure, lifted, marker);
  return marker;
}

Marker zoomedSurface(const PatchPicture& picture, const NodeConfig& config, const std_msgs::Header& header)
{
  Marker marker = makeMarker(header, "zoom", picture.id, Marker::TRIANGLE_LIST, makeColor(1, 1, 1));
  const Grid& grid = picture.patch->grid;
  const Vector3d middle(0, config.markers.zoom * 0.5 * (grid.y(0) + grid.y(grid.ny - 1)), 0);
  Eigen::Isometry3d placed = picture.to_track * Eigen::Translation3d(-middle);
  placed.translation() += picture.zoom_place - picture.to_track.translation();
  const PressureSurface pressure(grid, picture.patch->pressure, zoomed_points);
  addPressure(pressure, config.markers.zoom, config.markers.pressure_height, config.markers.max_pressure, placed,
              marker);
  return marker;
}

Marker zoomLine(const PatchPicture& picture, const std_msgs::Header& header)
{
  Marker marker = makeMarker(header, "zoom_line", picture.id, Marker::LINE_LIST, makeColor(0.8, 0.8, 0.8, 0.6));
  marker.scale.x = line_width;
  marker.points = {toPoint(picture.to_track.translation()), toPoint(picture.zoom_place)};
  return marker;
}

Marker arrow(const PatchPicture& picture, const NodeConfig& config, const std_msgs::Header& header)
{
  Marker marker = makeMarker(header, "force", picture.id, Marker::ARROW, makeColor(0.90, 0.30, 0.20));
  const double length = config.markers.force_scale * picture.patch->normal_force;
  marker.points = {toPoint(picture.to_track.translation()), toPoint(picture.to_track * Vector3d(0, 0, -length))};
  marker.scale.x = arrow_shaft;
  marker.scale.y = arrow_head;
  marker.scale.z = std::min(arrow_head, 0.5 * length);
  return marker;
}

Marker makeText(const std_msgs::Header& header, const std::string& ns, int id, const Vector3d& place,
                const std::string& words)
{
  Marker marker = makeMarker(header, ns, id, Marker::TEXT_VIEW_FACING, makeColor(0.95, 0.95, 0.95));
  marker.pose.position = toPoint(place);
  marker.scale.z = label_height;
  marker.text = words;
  return marker;
}

Marker label(const PatchPicture& picture, const NodeConfig& config, const std_msgs::Header& header)
{
  char words[64];
  std::snprintf(words, sizeof words, "%.0f MPa\n%.0f mm²", picture.patch->max_pressure / 1e6,
                picture.patch->area * 1e6);
  const double half_width = 0.5 * zoomedWidth(*picture.patch, config.markers.zoom);
  const double rise = half_width * std::abs(std::sin(picture.patch->pose.angle));
  const double share = std::min(picture.patch->max_pressure / config.markers.max_pressure, 1.0);
  const Vector3d above(0, 0, config.markers.pressure_height * share + rise + 1.8 * label_height);
  return makeText(header, "label", picture.id, picture.zoom_place + above, words);
}

void addPatch(const PatchPicture& picture, const NodeConfig& config, const std_msgs::Header& header,
              MarkerArray& markers)
{
  markers.markers.push_back(surface(picture, config, header));
  if (config.markers.zoom > 0)
  {
    markers.markers.push_back(zoomedSurface(picture, config, header));
    markers.markers.push_back(zoomLine(picture, header));
  }
  if (config.markers.force_scale > 0 && picture.patch->normal_force > 0)
  {
    markers.markers.push_back(arrow(picture, config, header));
  }
  markers.markers.push_back(label(picture, config, header));
}
}  // namespace

MarkerArray contactMarkers(const ContactAnswer& answer, const NodeConfig& config)
{
  MarkerArray markers;
  const std_msgs::Header& header = answer.header;
  if (!answer.result)
  {
    markers.markers.push_back(makeText(header, "status", 0, {answer.x, 0, config.markers.zoom_height}, answer.reason));
    return markers;
  }
  const WheelsetResult& result = *answer.result;
  addRails(config, header, answer.x, {result.rail[0].deflection, result.rail[1].deflection}, markers);
  addWheelset(config, header, answer.x, answer.pose, markers);
  for (const Side side : {Side::left, Side::right})
  {
    for (const PatchPicture& picture : arrange(answer, config, side))
    {
      addPatch(picture, config, header, markers);
    }
  }
  return markers;
}
}  // namespace wheel_rail_contact
