// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/balance/missed_pressure.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
constexpr double missed_clearance = 0.1;  ///< width beside a grid in which edges alone tell, of the grid's width [-]
constexpr double missed_share = 0.02;     ///< overlap beside a grid that is let pass, of the descent [-]
constexpr int groups = 8;                 ///< in which the columns are taken together

/// Displacement of both bodies at place t beside the pressure, on its line of centres [m]: each group's load spread
/// evenly over the pressure's length.
double displacementBeside(const SolvedPatch& solved, double length, double t)
{
  const Grid& grid = solved.grid;
  const double half_length = std::max(length, grid.dx);
  double sum = 0;
  for (int group = 0; group < groups; ++group)
  {
    const int begin = group * grid.ny / groups;
    const int end = (group + 1) * grid.ny / groups;
    if (end > begin)
    {
      const double force = solved.pressure.middleCols(begin, end - begin).sum() * grid.cellArea();
      const double distance = std::abs(t - 0.5 * (grid.y(begin) + grid.y(end - 1)));
      sum += force * std::asinh(half_length / distance);
    }
  }
  return sum / (std::acos(-1.0) * solved.modulus * half_length);
}
}  // namespace

bool widenOverMissedPressure(const SolvedPatch& solved, const PlacedRail& rail, const std::vector<Station>& stations,
                             WheelPatch& patch)
{
  const Grid& grid = solved.grid;
  const double clearance = missed_clearance * grid.ny * grid.dy;
  const double closing = (1 - missed_share) * solved.descent;
  const double u_first = patch.columns.front().rail_u;
  const double u_last = patch.columns.back().rail_u;
  bool missed = false;
  for (const Station& station : stations)
  {
    if (station.rail_u >= u_first && station.rail_u <= u_last)
    {
      continue;  // within the grid
    }
    const PlanePoint point = rail.at(station.rail_u);
    const double t = placeOnPlane(patch.plane, point);
    const double local = std::atan2(point.dz, point.dy);
    const double overlap = (closing - station.separation) * std::cos(local) / std::cos(local - patch.plane.angle);
    const bool beyond = t < grid.y0 - clearance || t > grid.y(grid.ny - 1) + clearance;
    if (beyond && overlap > displacementBeside(solved, patch.extent.half_length, t))
    {
      missed = true;
      patch.extent.y_begin = std::min(patch.extent.y_begin, t);
      patch.extent.y_end = std::max(patch.extent.y_end, t);
    }
  }
  return missed;
}
}  // namespace wheel_rail_contact
