// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace wheel_rail_contact
{

/// Shares of red, green, blue and opacity [-], in [0, 1].
std_msgs::ColorRGBA makeColor(double r, double g, double b, double a = 1);
/// The same three numbers.
geometry_msgs::Point toPoint(const Eigen::Vector3d& p);

/// A marker to add, placed at the origin of its frame with unit scale.
visualization_msgs::Marker makeMarker(const std_msgs::Header& header, const std::string& ns, int id, int type,
                                      const std_msgs::ColorRGBA& color);

/// A text marker whose letters have the given height [m].
visualization_msgs::Marker makeText(const std_msgs::Header& header, const std::string& ns, int id,
                                    const Eigen::Vector3d& place, double height, const std::string& words);

/// Points of a surface, row by row; all rows are of equal length.
using SurfacePoints = std::vector<std::vector<Eigen::Vector3d>>;

/// Appends the triangles of a quadrilateral mesh to a TRIANGLE_LIST, its colour shaded as under light from above (rviz
/// draws triangles without colours at their points too dark, and with them without shades). They face to where the
/// rows' direction crossed with the direction within a row points, or to the other side if `flipped`.
void addSurface(const SurfacePoints& points, bool flipped, visualization_msgs::Marker& marker);
/// Appends two triangles with a colour at each of the four corners, which go round.
void addQuadrilateral(const std::vector<Eigen::Vector3d>& corners, const std::vector<std_msgs::ColorRGBA>& colors,
                      visualization_msgs::Marker& marker);

/// What makes a marker the same in rviz: namespace and number.
using MarkerKey = std::pair<std::string, int>;
/// Of several markers.
using MarkerKeys = std::set<MarkerKey>;

/// Keys of all of them.
MarkerKeys keysOf(const visualization_msgs::MarkerArray& markers);

/// Appends a DELETE for every marker that was shown before and is no more. @return the keys of what is shown now.
MarkerKeys appendDeletions(const MarkerKeys& before, const std_msgs::Header& header,
                           visualization_msgs::MarkerArray& markers);
}  // namespace wheel_rail_contact
