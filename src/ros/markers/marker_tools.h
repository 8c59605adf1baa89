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
