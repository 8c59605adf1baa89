// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/outside_contact.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/balance/rail_region.h"
#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Distance to the nearest grid along the profile [m]; zero in a grid.
double distanceTo(const std::vector<std::pair<double, double>>& spans, double u)
{
  double nearest = infinity;
  for (const auto& [begin, end] : spans)
  {
    nearest = std::min(nearest, std::max({begin - u, u - end, 0.0}));
  }
  return nearest;
}

/// Variance of the position along the track in a half-elliptic pressure [m²].
double pressureVariance(double half_length)
{
  return 0.25 * half_length * half_length;
}

/// Displacement of a half-space by a point force (Johnson 1985, eq. 3.22b) [m/N].
/// @param variance  mean square distance along the track [m²]
/// @param y, z      distance in the section [m]
double displacementPerForce(double modulus, double variance, double y, double z)
{
  return 1 / (pi * modulus * std::sqrt(variance + y * y + z * z));
}

/// True if a part of the rail reaches the outer cells of a grid, or lies beyond them.
bool isCut(const GridLayout& layout, const RailRegion& part)
{
  const auto& [grid, origin] = layout;
  const double most = origin.x + grid.x(grid.rows() - 1) - 0.5 * grid.dx;
  const double least = grid.symmetric ? -most : origin.x + grid.x(0) + 0.5 * grid.dx;
  return part.x_least < least || part.x_most > most || part.u_begin < origin.rail_u + grid.y(0) + 0.5 * grid.dy ||
         part.u_end > origin.rail_u + grid.y(grid.ny - 1) - 0.5 * grid.dy;
}
}  // namespace

void couple(const std::vector<PlacedGrid>& grids, const std::vector<std::vector<SurfaceColumn>>& columns,
            CurvedProblem& problem)
{
  if (problem.patches.size() < 2)
  {
    return;
  }
  Eigen::Index count = 0;
  for (const PatchGap& patch : problem.patches)
  {
    count += patch.grid.ny;
  }
  problem.coupling.setZero(count, count);
  Eigen::Index row = 0;
  for (std::size_t k = 0; k < problem.patches.size(); row += problem.patches[k++].grid.ny)
  {
    Eigen::Index column = row + problem.patches[k].grid.ny;
    for (std::size_t l = k + 1; l < problem.patches.size(); column += problem.patches[l++].grid.ny)
    {
      const Grid &one = problem.patches[k].grid, &other = problem.patches[l].grid;
      const double along = std::pow(grids[k].layout.origin.x - grids[l].layout.origin.x, 2) +
                           pressureVariance(grids[k].half_length) + pressureVariance(grids[l].half_length);
      for (Eigen::Index i = 0; i < one.ny; ++i)
      {
        const SurfaceColumn& here = columns[k][static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < other.ny; ++j)
        {
          const SurfaceColumn& there = columns[l][static_cast<std::size_t>(j)];
          problem.coupling(row + i, column + j) = problem.coupling(column + j, row + i) =
              (here.cosine * there.cosine + here.sine * there.sine) *
              displacementPerForce(problem.modulus, along, here.y - there.y, here.z - there.z);
        }
      }
    }
  }
}

bool OutsideContact::isContained(const std::vector<PlacedGrid>& others, const std::vector<OverlapInterval>& intervals,
                                 const NormalProblem& problem, const NormalSolution& solution)
{
  bool whole = true;
  spans_.clear();
  for (std::size_t k = 0; k < others.size(); ++k)
  {
    const auto& [grid, origin] = others[k].layout;
    if (!others[k].whole &&
        isCut(others[k].layout, loadedPart(solution.patches[k], grids_[k].layout.origin, columns_[k], 0)))
    {
      return false;
    }
    whole = whole && others[k].whole;
    spans_.emplace_back(origin.rail_u + grid.y(0), origin.rail_u + grid.y(grid.ny - 1));
  }
  return whole || !isPossible(intervals, problem, solution);
}

/// True if the surfaces may touch outside of the spans, displaced by the forces in the grids.
bool OutsideContact::isPossible(const std::vector<OverlapInterval>& intervals, const NormalProblem& problem,
                                const NormalSolution& solution)
{
  column_forces_.resize(solution.patches.size());
  for (std::size_t k = 0; k < solution.patches.size(); ++k)
  {
    column_forces_[k] = problem.patches[k].grid.cellArea() * solution.patches[k].pressure.colwise().sum();
  }
  for (const OverlapInterval& interval : intervals)
  {
    search_.stationsOf(interval, spans_, stations_);
    if (mayTouchFarther(problem, solution, stations_.begin(), stations_.end()) ||
        mayTouchFarther(problem, solution, stations_.rbegin(), stations_.rend()))
    {
      return true;
    }
  }
  return false;
}

/// True if the surfaces may touch on the way from one end of an interval to the other, where it leads away from the
/// nearest grid.
template <typename Station>
bool OutsideContact::mayTouchFarther(const NormalProblem& problem, const NormalSolution& solution, Station station,
                                     Station end) const
{
  double least = infinity, before = infinity;
  // On the way out of a single grid the displacement falls: it is nowhere less than at the end.
  const bool is_single = solution.patches.size() == 1 && station != end;
  const double farthest = is_single ? displacementAt(*std::prev(end), problem, solution) : 0;
  for (; station != end; ++station)
  {
    const double beyond = distanceTo(spans_, station->rail_u);
    if (beyond > before)
    {
      const double most = station->depth + solution.approach;
      const double overlap = most - (most > farthest ? displacementAt(*station, problem, solution) : farthest);
      if (overlap > std::max(least, 0.0) + 2 * ContactSearch::station_error)
      {
        return true;
      }
      least = std::min(least, overlap);
    }
    else
    {
      least = infinity;
    }
    before = beyond;
  }
  return false;
}

/// Displacement by the forces in the columns (Johnson 1985, eq. 3.22b), each as a point force at the root mean square
/// distance along the track [m]. That by the pressure is not smaller, because 1 / distance is convex.
double OutsideContact::displacementAt(const OverlapStation& station, const NormalProblem& problem,
                                      const NormalSolution& solution) const
{
  double sum = 0;
  for (std::size_t k = 0; k < solution.patches.size(); ++k)
  {
    const double variance = pressureVariance(grids_[k].half_length);
    for (Eigen::Index j = 0; j < column_forces_[k].size(); ++j)
    {
      const SurfaceColumn& column = columns_[k][static_cast<std::size_t>(j)];
      sum += column_forces_[k][j] *
             displacementPerForce(problem.modulus, variance, station.y - column.y, station.z - column.z);
    }
  }
  return sum;
}
}  // namespace wheel_rail_contact::core
