// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/point_sources.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheel_rail_contact::core
{
namespace
{
const double pi = std::acos(-1.0);
constexpr double far_spacing = 0.4;  ///< distance of the forces of a column, over its distance from the nearest point

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
  unit_ = unit;
  lines_.clear();
  x_.clear();
  y_.clear();
  force_.clear();
  const auto joined = std::max(Eigen::Index{1}, static_cast<Eigen::Index>(spacing * unit / grid.dy));
  for (Eigen::Index j = 0; j < grid.ny; j += joined)
  {
    lines_.push_back(lineOf(grid, pressure, j, std::min<Eigen::Index>(j + joined, grid.ny)));
  }
  for (std::size_t k = 0; k < lines_.size(); ++k)
  {
    double distance = places.empty() ? 0 : std::numeric_limits<double>::infinity();
    for (const double place : places)
    {
      distance = std::min(distance, std::abs(lines_[k].y - place));
    }
    addParts(k, grid.dy / unit, std::max(spacing, far_spacing * distance));
  }
}

PointSources::Line PointSources::lineOf(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, Eigen::Index begin,
                                        Eigen::Index end) const
{
  double sum = 0, y = 0, first = 0, second = 0;
  for (Eigen::Index j = begin; j < end; ++j)
  {
    for (int i = 0; i < grid.nx; ++i)
    {
      const double p = pressure(i, j), x = grid.x(i) / unit_;
      sum += p;
      y += p * grid.y(static_cast<int>(j)) / unit_;
      first += p * x;
      second += p * x * x;
    }
  }
  Line line;
  if (sum > 0)
  {
    const double centre = first / sum, cell = grid.dx / unit_;
    const double variance = std::max(second / sum - centre * centre, cell * cell / 16);
    line = {y / sum, sum * grid.cellArea() / (unit_ * unit_), centre, 2 * std::sqrt(variance)};
  }
  return line;
}

/// Adds the equal parts of a line. Their forces, centres and half lengths change linearly to those of the loaded lines
/// beside it; their whole force is that of the line.
void PointSources::addParts(std::size_t number, double width, double spacing)
{
  const int parts = std::max(1, static_cast<int>(std::ceil(width / spacing)));
  const Line& line = lines_[number];
  if (!(line.force > 0))
  {
    return;
  }
  const auto beside = [&](double place) -> const Line&
  {
    const std::size_t other = place < 0 ? number - 1 : number + 1;
    return other < lines_.size() && lines_[other].force > 0 ? lines_[other] : line;
  };
  const auto placeOf = [parts](int part) { return (part + 0.5) / parts - 0.5; };
  const auto forceOf = [&](double place) { return line.force + std::abs(place) * (beside(place).force - line.force); };
  double sum = 0;
  for (int part = 0; part < parts; ++part)
  {
    sum += forceOf(placeOf(part));
  }
  for (int part = 0; part < parts; ++part)
  {
    const double place = placeOf(part), share = std::abs(place);
    const Line& other = beside(place);
    addLine({line.y + place * width, line.force / sum * forceOf(place),
             line.centre + share * (other.centre - line.centre), line.half + share * (other.half - line.half)},
            spacing);
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

std::array<Stress, kPoints> PointSources::at(const Places& places, double poisson) const
{
  PointForceSums sums;
  laneKernels().point_forces({x_.data(), y_.data(), force_.data(), x_.size()}, places, sums);
  std::array<Stress, kPoints> stresses;
  for (std::size_t k = 0; k < stresses.size(); ++k)
  {
    stresses[k] = stressOf(sums, k, places.depth[k], poisson);
  }
  return stresses;
}
}  // namespace wheel_rail_contact::core
