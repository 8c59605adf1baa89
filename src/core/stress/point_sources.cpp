// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/point_sources.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double part_width = 0.5;   ///< width of joined or divided columns, over the distance of the forces along them
constexpr double near_columns = 2;   ///< reach of the columns without thinning, in distances of the forces
constexpr double one_force = 0.08;   ///< longest side of a cell with one force, over its distance from the point
constexpr double two_forces = 0.2;   ///< the same with two forces, by Gauss's rule; longer sides are divided
constexpr double far_spacing = 0.4;  ///< distance of the forces of a column, over its distance from the nearest point

/// Number of forces along a side of a cell.
int countOf(double side, double distance)
{
  return side <= one_force * distance ? 1 : 2 * static_cast<int>(std::ceil(side / (two_forces * distance)));
}

/// Place of a force along a side, from its middle and over its length: Gauss's rule of two points on each part.
double placeOf(int k, int count)
{
  constexpr double gauss = 0.28867513459481287;  // 1 / (2 sqrt 3)
  const int part = k / 2;
  return count == 1 ? 0 : (2 * part + 1 + (k % 2 == 0 ? -2 : 2) * gauss) / count - 0.5;
}

Stress stressOf(const PointForceSums& sums, std::size_t k, double z, double poisson)
{
  const double bulk = 1 - 2 * poisson;
  Stress stress;
  stress.xx = bulk * sums.chi_yy[k] - 3 * z * sums.xx[k];  // chi_xx + chi_yy = z / r³
  stress.yy = bulk * sums.chi_xx[k] - 3 * z * sums.yy[k];
  stress.zz = -3 * z * z * z * sums.one[k];
  stress.yz = -3 * z * z * sums.y[k];
  stress.xz = -3 * z * z * sums.x[k];
  stress.xy = -bulk * sums.chi_xy[k] - 3 * z * sums.xy[k];
  return stress;
}
}  // namespace

void PointSources::set(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double unit, double spacing,
                       const std::vector<double>& places)
{
  x_.clear();
  y_.clear();
  force_.clear();
  const auto joined = std::max(Eigen::Index{1}, static_cast<Eigen::Index>(part_width * spacing * unit / grid.dy));
  for (Eigen::Index j = 0; j < grid.ny; j += joined)
  {
    const Line line = lineOf(grid, pressure, j, std::min<Eigen::Index>(j + joined, grid.ny), unit);
    double distance = places.empty() ? 0 : infinity;
    for (const double place : places)
    {
      distance = std::min(distance, std::abs(line.y - place));
    }
    if (line.force > 0)
    {
      addParts(line, static_cast<double>(joined) * grid.dy / unit,
               std::max(spacing, far_spacing * (distance - near_columns * spacing)));
    }
  }
}

PointSources::Line PointSources::lineOf(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, Eigen::Index begin,
                                        Eigen::Index end, double unit)
{
  double sum = 0, y = 0, first = 0, second = 0;
  for (Eigen::Index j = begin; j < end; ++j)
  {
    for (int i = 0; i < grid.nx; ++i)
    {
      const double p = pressure(i, j), x = grid.x(i) / unit;
      sum += p;
      y += p * grid.y(static_cast<int>(j)) / unit;
      first += p * x;
      second += p * x * x;
    }
  }
  Line line;
  if (sum > 0)
  {
    const double centre = first / sum, cell = grid.dx / unit;
    const double variance = std::max(second / sum - centre * centre, cell * cell / 16);
    line = {y / sum, sum * grid.cellArea() / (unit * unit), centre, 2 * std::sqrt(variance)};
  }
  return line;
}

/// Adds a column of a given width, divided into parts of equal force.
void PointSources::addParts(const Line& line, double width, double spacing)
{
  const int parts = std::max(1, static_cast<int>(std::ceil(width / (part_width * spacing))));
  for (int part = 0; part < parts; ++part)
  {
    addLine({line.y + ((part + 0.5) / parts - 0.5) * width, line.force / parts, line.centre, line.half}, spacing);
  }
}

void PointSources::addLine(const Line& line, double spacing)
{
  const int count = std::max(3, static_cast<int>(std::ceil(pi * line.half / spacing)));
  for (int k = 1; k <= count; ++k)
  {
    const double angle = pi * k / (count + 1), sine = std::sin(angle);
    x_.push_back(static_cast<float>(line.centre + line.half * std::cos(angle)));
    y_.push_back(static_cast<float>(line.y));
    force_.push_back(static_cast<float>(line.force / pi * sine * sine / (count + 1)));  // 1/(2 pi) times the weight
  }
}

void PointSources::setCells(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double unit,
                            const Eigen::Vector3d& place)
{
  x_.clear();
  y_.clear();
  force_.clear();
  const double dx = grid.dx / unit, dy = grid.dy / unit;
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.nx; ++i)
    {
      const double x = grid.x(i) / unit, y = grid.y(j) / unit;
      const double distance = (Eigen::Vector3d(x, y, 0) - place).norm();
      const int along = countOf(dx, distance), across = countOf(dy, distance);
      for (int k = 0; pressure(i, j) > 0 && k < along * across; ++k)
      {
        x_.push_back(static_cast<float>(x + dx * placeOf(k % along, along)));
        y_.push_back(static_cast<float>(y + dy * placeOf(k / along, across)));
        force_.push_back(static_cast<float>(pressure(i, j) * dx * dy / (2 * pi * along * across)));
      }
    }
  }
}

std::array<Stress, point_batch> PointSources::at(const Places& places, double poisson) const
{
  PointForceSums sums;
  pointForceKernels().sums({x_.data(), y_.data(), force_.data(), x_.size()}, places, sums);
  std::array<Stress, point_batch> stresses;
  for (std::size_t k = 0; k < stresses.size(); ++k)
  {
    stresses[k] = stressOf(sums, k, places.depth[k], poisson);
  }
  return stresses;
}
}  // namespace wheel_rail_contact::core
