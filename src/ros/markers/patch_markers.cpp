// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/patch_markers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ros/markers/marker_tools.h"

namespace wheel_rail_contact
{
using Eigen::Vector3d;
using visualization_msgs::Marker;

namespace
{
constexpr int ids_per_side = 16;
constexpr double true_size_lift = 2e-4;  ///< height of the patch above the rail, so that the rail does not hide it [m]
constexpr double zoom_spacing = 0.0017;  ///< between magnified patches, before magnification [m]
constexpr double head_ratio = 2.5;       ///< diameter and length of the head of an arrow / diameter of its shaft [-]

double zoomedWidth(const core::PatchResult& patch, double zoom)
{
  return zoom * patch.grid.ny * patch.grid.dy;
}

Vector3d gridMiddle(const core::PatchGrid& grid)
{
  return {0, grid.ny > 0 ? 0.5 * (grid.y(0) + grid.y(grid.ny - 1)) : 0.0, 0};
}

/// Patches of one side, in order of y, with each magnified picture at its patch.
std::vector<PatchPicture> patchesOf(const core::WheelsetResult& result, core::Side side, double x)
{
  std::vector<PatchPicture> pictures;
  for (const core::PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      const int id = static_cast<int>(side) * ids_per_side + static_cast<int>(pictures.size());
      const Eigen::Isometry3d to_track(Eigen::Translation3d(x + patch.pose.x, patch.pose.y, patch.pose.z) *
                                       patch.pose.rotation());
      pictures.push_back({&patch, id, to_track, to_track * gridMiddle(patch.grid), to_track.linear()});
    }
  }
  std::sort(pictures.begin(), pictures.end(),
            [](const PatchPicture& a, const PatchPicture& b)
            { return a.to_track.translation().y() < b.to_track.translation().y(); });
  return pictures;
}

/// Appends the triangles of a surface, magnified about the origin of the patch frame. The pressure gives height and
/// colour.
void addPressure(const PressureSurface& surface, double zoom, double height, double max_pressure,
                 const Eigen::Isometry3d& to_track, Marker& marker)
{
  for (const PressureSurface::Point& p : surface.triangles())
  {
    const double share = std::min(p.pressure / max_pressure, 1.0);
    marker.points.push_back(toPoint(to_track * Vector3d(zoom * p.x, zoom * p.y, height * share)));
    marker.colors.push_back(pressureColor(p.pressure, max_pressure));
  }
}

/// Transform from the patch frame with magnified lengths to the track frame.
Eigen::Isometry3d zoomedToTrack(const PatchPicture& picture, double zoom)
{
  return Eigen::Translation3d(picture.zoom_place) * Eigen::Isometry3d(picture.zoom_turn) *
         Eigen::Translation3d(-zoom * gridMiddle(picture.patch->grid));
}

Eigen::Isometry3d liftedToTrack(const PatchPicture& picture)
{
  return picture.to_track * Eigen::Translation3d(0, 0, true_size_lift);
}

/// Places the magnified pictures side by side, centred at the mean y of their patches.
void spread(std::vector<PatchPicture>& pictures, double zoom)
{
  const double spacing = zoom_spacing * zoom;
  double width = -spacing, middle = 0;
  for (const PatchPicture& picture : pictures)
  {
    width += zoomedWidth(*picture.patch, zoom) + spacing;
    middle += picture.zoom_place.y() / static_cast<double>(pictures.size());
  }
  double edge = middle - 0.5 * width;
  for (PatchPicture& picture : pictures)
  {
    const double own = zoomedWidth(*picture.patch, zoom);
    picture.zoom_place.y() = edge + 0.5 * own;
    edge += own + spacing;
  }
}

void addOutline(const PressureSurface& surface, double zoom, const Eigen::Isometry3d& to_track, Marker& marker)
{
  for (const PressureSurface::Point& p : surface.outline())
  {
    marker.points.push_back(toPoint(to_track * Vector3d(zoom * p.x, zoom * p.y, 0)));
  }
}
/// Height of the magnified surface of a patch [m].
double pressureHeight(const PatchPicture& picture, const PatchStyle& style)
{
  return style.pressure_height * std::min(picture.patch->max_pressure / style.max_pressure, 1.0);
}

/// The marker as an arrow of a force [N], from a point [m]; both in the patch frame.
Marker arrowOf(const Vector3d& force, const Vector3d& from, const PatchPicture& picture, const PatchStyle& style,
               Marker marker)
{
  const double head = head_ratio * style.arrow_width;
  const Vector3d arrow = style.force_scale * force;
  marker.points = {toPoint(picture.to_track * from), toPoint(picture.to_track * Vector3d(from + arrow))};
  marker.scale.x = style.arrow_width;
  marker.scale.y = head;
  marker.scale.z = std::min(head, 0.5 * arrow.norm());
  return marker;
}
}  // namespace

std::vector<PatchPicture> arrangePatches(const core::WheelsetResult& result, core::Side side, double x,
                                         const PatchStyle& style)
{
  std::vector<PatchPicture> pictures = patchesOf(result, side, x);
  for (PatchPicture& picture : pictures)
  {
    if (style.lift > 0)
    {
      picture.zoom_place.z() += style.lift;
      picture.zoom_turn.setIdentity();
    }
  }
  if (pictures.size() > 1 && style.zoom > 1)
  {
    spread(pictures, style.zoom);
  }
  return pictures;
}

PressureSurface fineSurface(const PatchPicture& picture, const PatchStyle& style)
{
  return {picture.patch->grid, picture.patch->pressure, style.points};
}

Marker truePatch(const PatchPicture& picture, const PatchStyle& style)
{
  Marker marker = makeMarker("patch", picture.id, Marker::TRIANGLE_LIST, makeColor(1, 1, 1));
  const PressureSurface cells(picture.patch->grid, picture.patch->pressure, 1);
  addPressure(cells, 1, 0, style.max_pressure, liftedToTrack(picture), marker);
  return marker;
}

Marker zoomedPatch(const PatchPicture& picture, const PressureSurface& fine, const PatchStyle& style)
{
  Marker marker = makeMarker("zoom", picture.id, Marker::TRIANGLE_LIST, makeColor(1, 1, 1));
  addPressure(fine, style.zoom, style.pressure_height, style.max_pressure, zoomedToTrack(picture, style.zoom), marker);
  return marker;
}

Marker patchOutline(const PatchPicture& picture, const PressureSurface& fine, const PatchStyle& style)
{
  Marker marker = makeMarker("outline", picture.id, Marker::LINE_LIST, makeColor(0.95, 0.95, 0.95));
  marker.scale.x = style.line_width;
  addOutline(fine, style.zoom, zoomedToTrack(picture, style.zoom), marker);
  return marker;
}

Marker zoomLine(const PatchPicture& picture, const PatchStyle& style)
{
  Marker marker = makeMarker("zoom_line", picture.id, Marker::LINE_LIST, makeColor(0.8, 0.8, 0.8, 0.6));
  marker.scale.x = style.line_width;
  marker.points = {toPoint(picture.to_track.translation()), toPoint(picture.zoom_place)};
  return marker;
}

Marker forceArrow(const PatchPicture& picture, const PatchStyle& style)
{
  return arrowOf({0, 0, -picture.patch->normal_force}, Vector3d::Zero(), picture, style,
                 makeMarker("force", picture.id, Marker::ARROW, scene_colors::force));
}

Marker frictionArrow(const PatchPicture& picture, const PatchStyle& style, bool above_surface)
{
  const core::CreepForce& on_wheel = picture.patch->creep.force;
  const Vector3d from(0, 0, above_surface ? pressureHeight(picture, style) + style.arrow_width : 0);
  return arrowOf({-on_wheel.x, -on_wheel.y, 0}, from, picture, style,
                 makeMarker("friction", picture.id, Marker::ARROW, scene_colors::friction));
}

Marker patchLabel(const PatchPicture& picture, const PatchStyle& style)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.0f MPa%s\n%.0f mm²", picture.patch->max_pressure / 1e6,
                picture.patch->max_pressure > style.max_pressure ? ", above scale" : "", picture.patch->area * 1e6);
  const double half_width = 0.5 * zoomedWidth(*picture.patch, style.zoom);
  const double edge_height = half_width * std::abs(picture.zoom_turn(2, 1));
  const Vector3d above(0, 0, pressureHeight(picture, style) + edge_height + 2.2 * style.letter_height);
  return makeText("label", picture.id, picture.zoom_place + above, style.letter_height, text, scene_colors::text);
}
}  // namespace wheel_rail_contact
