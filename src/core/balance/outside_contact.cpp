// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/outside_contact.h"

#include <algorithm>
#include <cmath>

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
}  // namespace

double pressureVariance(double half_length)
{
  return 0.25 * half_length * half_length;
}

double displacementPerForce(double modulus, double variance, double y, double z)
{
  return 1 / (pi * modulus * std::sqrt(variance + y * y + z * z));
}

bool OutsideContact::isPossible(const std::vector<OverlapInterval>& intervals,
                                const std::vector<std::pair<double, double>>& spans, const NormalProblem& problem,
                                const NormalSolution& solution)
{
  column_forces_.resize(solution.patches.size());
  for (std::size_t k = 0; k < solution.patches.size(); ++k)
  {
    column_forces_[k] = problem.patches[k].grid.cellArea() * solution.patches[k].pressure.colwise().sum();
  }
  for (const OverlapInterval& interval : intervals)
  {
    search_.stationsOf(interval, stations_);
    if (mayTouchFarther(spans, problem, solution, stations_.begin(), stations_.end()) ||
        mayTouchFarther(spans, problem, solution, stations_.rbegin(), stations_.rend()))
    {
      return true;
    }
  }
  return false;
}

/// True if the surfaces may touch on the way from one end of an interval to the other, where it leads away from the
/// nearest grid.
template <typename Station>
bool OutsideContact::mayTouchFarther(const std::vector<std::pair<double, double>>& spans, const NormalProblem& problem,
                                     const NormalSolution& solution, Station station, Station end) const
{
  double least = infinity, before = infinity;
  for (; station != end; ++station)
  {
    const double beyond = distanceTo(spans, station->rail_u);
    if (beyond > before)
    {
      const double overlap = station->depth + solution.approach - displacementAt(*station, problem, solution);
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
