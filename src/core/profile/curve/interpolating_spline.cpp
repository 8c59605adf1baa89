// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "core/option_check.h"
#include "core/profile/curve/spline.h"

namespace wheel_rail_contact::core
{
namespace
{
using Column = std::vector<double>;

constexpr std::size_t least_points = 4;
constexpr double longest_polygon = 10.0;  ///< [m]; limits the memory of a spline

/// Second derivatives of the natural cubic spline with values f at knots u (Thomas algorithm).
Column secondDerivatives(const Column& u, const Column& f)
{
  const std::size_t n = u.size();
  Column second(n, 0.0);
  Column upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i)
  {
    const double left = u[i] - u[i - 1];
    const double right = u[i + 1] - u[i];
    const double pivot = 2.0 * (left + right) - left * upper[i - 1];
    const double bend = 6.0 * ((f[i + 1] - f[i]) / right - (f[i] - f[i - 1]) / left);
    upper[i] = right / pivot;
    second[i] = (bend - left * second[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;)
  {
    second[i] -= upper[i] * second[i + 1];
  }
  return second;
}

/// Coefficients of the cubic between knots i and i + 1.
void fillCubic(const Column& u, const Column& f, const Column& second, std::size_t i, double* c)
{
  const double h = u[i + 1] - u[i];
  c[0] = f[i];
  c[1] = (f[i + 1] - f[i]) / h - h * (2.0 * second[i] + second[i + 1]) / 6.0;
  c[2] = 0.5 * second[i];
  c[3] = (second[i + 1] - second[i]) / (6.0 * h);
}
}  // namespace

std::vector<double> polygonLength(const std::vector<SampledPoint>& points)
{
  refuseIf(points.size() < least_points, "profile spline: number of points is ", points.size(), ", must be at least ",
           least_points);
  std::vector<double> length(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const SampledPoint& point = points[i];
    refuseIf(!std::isfinite(point.y) || !std::isfinite(point.z), "profile spline: point ", i, " is not finite");
    refuseIf(!(point.weight > 0.0) || !std::isfinite(point.weight), "profile spline: weight of point ", i, " is ",
             point.weight, ", must be positive");
    if (i > 0)
    {
      length[i] = length[i - 1] + distance(points[i - 1], points[i]);
      refuseIf(!(length[i] > length[i - 1]), "profile spline: points ", i - 1, " and ", i, " are equal");
    }
  }
  refuseIf(!(length.back() <= longest_polygon), "profile spline: polygon through the points is ", length.back(),
           " m long, must be at most ", longest_polygon, " m");
  return length;
}

std::vector<ProfileSection> interpolatingSpline(const std::vector<SampledPoint>& points)
{
  const Column u = polygonLength(points);
  Column y, z;
  for (const SampledPoint& point : points)
  {
    y.push_back(point.y);
    z.push_back(point.z);
  }
  const Column bend_y = secondDerivatives(u, y);
  const Column bend_z = secondDerivatives(u, z);
  std::vector<ProfileSection> sections;
  for (std::size_t i = 0; i + 1 < u.size(); ++i)
  {
    CubicSection cubic{};
    fillCubic(u, y, bend_y, i, cubic.y);
    fillCubic(u, z, bend_z, i, cubic.z);
    sections.push_back({cubic, u[i + 1] - u[i]});
  }
  return sections;
}
}  // namespace wheel_rail_contact::core
