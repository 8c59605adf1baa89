// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace wheel_rail_contact
{
/// Colour from the shares of red, green, blue and opacity [-], each in [0, 1].
std_msgs::ColorRGBA makeColor(double r, double g, double b, double a = 1);
/// Colour of a value from 0 (dark violet) to 1 (yellow); values outside are clamped, and NaN gives the colour of 0.
///
/// The colours are polynomials of degree 6, fitted by least squares to the colour map viridis (van der Walt and Smith
/// 2015, public domain), with deviations of at most 0.017. Viridis is perceptually uniform, and readable in grey and
/// with the common types of colour blindness.
std_msgs::ColorRGBA colorOf(double value);

/// Colours that the markers and the legend of the screen panel share.
namespace scene_colors
{
/// Text without a fault.
inline const std_msgs::ColorRGBA text = makeColor(0.95, 0.95, 0.95);
/// A usable result with a warning, or with a wheel that carries no load.
inline const std_msgs::ColorRGBA warning = makeColor(1.0, 0.75, 0.25);
/// Values above the scale: magenta, which is not a colour of colorOf().
inline const std_msgs::ColorRGBA above_scale = makeColor(1, 0.1, 0.8);
/// A result that is not usable.
inline const std_msgs::ColorRGBA error = makeColor(1.0, 0.35, 0.30);
/// Normal force of a wheel on its rail.
inline const std_msgs::ColorRGBA force = makeColor(0.90, 0.30, 0.20);
/// Friction of a wheel on its rail.
inline const std_msgs::ColorRGBA friction = makeColor(0.35, 0.55, 1.0);
/// Section of a rail at rest.
inline const std_msgs::ColorRGBA rail_at_rest = makeColor(0.95, 0.65, 0.2, 0.9);
/// Section of a wheel.
inline const std_msgs::ColorRGBA wheel_section = makeColor(0.45, 0.80, 1.0);
}  // namespace scene_colors

/// Colour of a pressure or a von Mises stress: colorOf() within the scale, and scene_colors::above_scale above its
/// upper end.
/// @param pressure or stress [Pa]
/// @param max_pressure upper end of the scale [Pa], > 0
inline std_msgs::ColorRGBA pressureColor(double pressure, double max_pressure)
{
  return pressure > max_pressure ? scene_colors::above_scale : colorOf(pressure / max_pressure);
}

/// Point as a message.
geometry_msgs::Point toPoint(const Eigen::Vector3d& p);

/// A marker with action ADD, at the origin of its frame, with unit scale. Its header is set by setHeader().
visualization_msgs::Marker makeMarker(const std::string& ns, int id, int type, const std_msgs::ColorRGBA& color);

/// A text marker.
/// @param height height of the letters [m]
visualization_msgs::Marker makeText(const std::string& ns, int id, const Eigen::Vector3d& place, double height,
                                    const std::string& text, const std_msgs::ColorRGBA& color);

/// Points of a surface, row by row. All rows have the same length.
using SurfacePoints = std::vector<std::vector<Eigen::Vector3d>>;

/// Appends the triangles of a quadrilateral mesh to a TRIANGLE_LIST, in its colour, shaded as under light from above.
/// The shades are necessary because rviz draws triangles with colours at their points without shading, and triangles
/// without such colours too dark.
///
/// The front of the triangles is on the side of a × b, where a points from row to row and b points along a row; on the
/// other side if `flipped`.
void addSurface(const SurfacePoints& points, bool flipped, visualization_msgs::Marker& marker);
/// Appends two triangles with a colour at each corner. The four corners are given in order around the quadrilateral.
void addQuadrilateral(const std::vector<Eigen::Vector3d>& corners, const std::vector<std_msgs::ColorRGBA>& colors,
                      visualization_msgs::Marker& marker);

/// Namespace and number of a marker, which identify it in rviz.
using MarkerKey = std::pair<std::string, int>;
/// Keys of several markers.
using MarkerKeys = std::set<MarkerKey>;

/// Moves markers as a rigid body.
/// @param motion from the old to the new place, in the frame of the markers
void move(const Eigen::Isometry3d& motion, visualization_msgs::MarkerArray& markers);

/// Sets the header of all markers.
void setHeader(const std_msgs::Header& header, visualization_msgs::MarkerArray& markers);

/// Keys of all markers of an array.
MarkerKeys keysOf(const visualization_msgs::MarkerArray& markers);

/// Appends a DELETE for each marker that was shown before and is not in the array.
/// @param before keys of the markers shown before
/// @return keys of the markers shown now
MarkerKeys appendDeletions(const MarkerKeys& before, const std_msgs::Header& header,
                           visualization_msgs::MarkerArray& markers);
}  // namespace wheel_rail_contact
