// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/marker_tools.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
using Eigen::Vector3d;
using visualization_msgs::Marker;

namespace
{
using Polynomial = std::array<double, 7>;  ///< coefficients of t^0 ... t^6

constexpr Polynomial red{0.2745, 0.1077, -0.3272, -4.5999, 6.2037, 4.7518, -5.4321};
constexpr Polynomial green{0.0058, 1.3965, 0.2148, -5.7582, 14.154, -13.7494, 4.6416};
constexpr Polynomial blue{0.3327, 1.3868, 0.092, -19.2918, 56.6563, -65.321, 26.2721};

double evaluate(const Polynomial& polynomial, double t)
{
  double value = 0;
  for (auto coefficient = polynomial.rbegin(); coefficient != polynomial.rend(); ++coefficient)
  {
    value = value * t + *coefficient;
  }
  return std::clamp(value, 0.0, 1.0);
}

/// Colour of a surface under light from above.
std_msgs::ColorRGBA shaded(std_msgs::ColorRGBA color, const Vector3d& normal)
{
  constexpr double ambient = 0.4;
  const auto light = static_cast<float>(ambient + (1 - ambient) * std::abs(normal.z()));
  color.r *= light;
  color.g *= light;
  color.b *= light;
  return color;
}
}  // namespace

std_msgs::ColorRGBA makeColor(double r, double g, double b, double a)
{
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(r);
  color.g = static_cast<float>(g);
  color.b = static_cast<float>(b);
  color.a = static_cast<float>(a);
  return color;
}

std_msgs::ColorRGBA colorOf(double value)
{
  const double t = value > 0 ? std::min(value, 1.0) : 0.0;  // 0 for NaN
  return makeColor(evaluate(red, t), evaluate(green, t), evaluate(blue, t));
}

geometry_msgs::Point toPoint(const Eigen::Vector3d& p)
{
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

Marker makeMarker(const std::string& ns, int id, int type, const std_msgs::ColorRGBA& color)
{
  Marker marker;
  marker.ns = ns;
  marker.id = id;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  marker.color = color;
  return marker;
}

Marker makeText(const std::string& ns, int id, const Vector3d& place, double height, const std::string& text,
                const std_msgs::ColorRGBA& color)
{
  Marker marker = makeMarker(ns, id, Marker::TEXT_VIEW_FACING, color);
  marker.pose.position = toPoint(place);
  marker.scale.z = height;
  marker.text = text;
  return marker;
}

void addSurface(const SurfacePoints& points, bool flipped, Marker& marker)
{
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    for (std::size_t j = 0; j + 1 < points[i].size(); ++j)
    {
      const Vector3d &along = flipped ? points[i][j + 1] : points[i + 1][j],
                     &across = flipped ? points[i + 1][j] : points[i][j + 1];
      const Vector3d normal = (along - points[i][j]).cross(across - points[i][j]).normalized();
      const std::vector<std_msgs::ColorRGBA> colors(4, shaded(marker.color, normal));
      addQuadrilateral({points[i][j], along, points[i + 1][j + 1], across}, colors, marker);
    }
  }
}

void addQuadrilateral(const std::vector<Eigen::Vector3d>& corners, const std::vector<std_msgs::ColorRGBA>& colors,
                      Marker& marker)
{
  for (const std::size_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
  {
    marker.points.push_back(toPoint(corners.at(corner)));
    marker.colors.push_back(colors.at(corner));
  }
}

void move(const Eigen::Isometry3d& motion, visualization_msgs::MarkerArray& markers)
{
  const Eigen::Quaterniond turn(motion.linear());
  for (Marker& marker : markers.markers)
  {
    geometry_msgs::Pose& pose = marker.pose;
    const geometry_msgs::Point& p = pose.position;
    const geometry_msgs::Quaternion& q = pose.orientation;
    pose.position = toPoint(motion * Vector3d(p.x, p.y, p.z));
    pose.orientation = toMessage(turn * Eigen::Quaterniond(q.w, q.x, q.y, q.z));
  }
}

void setHeader(const std_msgs::Header& header, visualization_msgs::MarkerArray& markers)
{
  for (Marker& marker : markers.markers)
  {
    marker.header = header;
  }
}

MarkerKeys keysOf(const visualization_msgs::MarkerArray& markers)
{
  MarkerKeys keys;
  for (const Marker& marker : markers.markers)
  {
    keys.emplace(marker.ns, marker.id);
  }
  return keys;
}

MarkerKeys appendDeletions(const MarkerKeys& before, const std_msgs::Header& header,
                           visualization_msgs::MarkerArray& markers)
{
  MarkerKeys now = keysOf(markers);
  for (const MarkerKey& key : before)
  {
    if (now.count(key) == 0)
    {
      Marker marker;
      marker.header = header;
      marker.ns = key.first;
      marker.id = key.second;
      marker.action = Marker::DELETE;
      marker.pose.orientation.w = 1;
      markers.markers.push_back(marker);
    }
  }
  return now;
}
}  // namespace wheel_rail_contact
