// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/balance/missed_pressure.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
constexpr double missed_clearance = 0.1;  ///< width beside a grid in which edges alone tell, of the grid's width [-]
constexpr double missed_share = 0.02;     ///< overlap beside a grid that is let pass, of the descent [-]
constexpr int most_groups = 8;            ///< in which the columns are taken together

/// How far a solved pressure pushes the bodies apart beside it, on its line of centres: each group's load spread evenly
/// over the pressure's length.
class PushBeside
{
 public:
  PushBeside(const SolvedPatch& solved, double length) : half_length_(std::max(length, solved.grid.dx))
  {
    const Grid& grid = solved.grid;
    for (int group = 0; group < most_groups; ++group)
    {
      const int begin = group * grid.ny / most_groups;
      const int end = (group + 1) * grid.ny / most_groups;
      if (end > begin)
      {
        place_[groups_] = 0.5 * (grid.y(begin) + grid.y(end - 1));
        share_[groups_] = solved.pressure.middleCols(begin, end - begin).sum() * grid.cellArea() /
                          (std::acos(-1.0) * solved.modulus * half_length_);
        total_ += share_[groups_];
        moment_ += share_[groups_] * place_[groups_];
        ++groups_;
      }
    }
  }

  /// Displacement of both bodies at place t [m].
  double at(double t) const
  {
    double sum = 0;
    for (std::size_t k = 0; k < groups_; ++k)
    {
      sum += share_[k] * std::asinh(half_length_ / std::abs(t - place_[k]));
    }
    return sum;
  }

  /// What it is at least beside all groups: as if all of the load stood in its centre (asinh(1/t) is convex), where
  /// asinh(x) >= x / sqrt(1 + x²) [m].
  double atLeast(double t) const
  {
    const double distance = t - moment_ / total_;
    return total_ * half_length_ / std::sqrt(distance * distance + half_length_ * half_length_);
  }

 private:
  double half_length_;  ///< [m]
  double total_ = 0;    ///< of the shares [m]
  double moment_ = 0;   ///< of the shares [m²]
  std::size_t groups_ = 0;
  std::array<double, most_groups> place_{};  ///< [m]
  std::array<double, most_groups> share_{};  ///< [m]
};
}  // namespace

bool widenOverMissedPressure(const SolvedPatch& solved, const PlacedRail& rail, const std::vector<Station>& stations,
                             WheelPatch& patch)
{
  const Grid& grid = solved.grid;
  const double clearance = missed_clearance * grid.ny * grid.dy;
  const double closing = (1 - missed_share) * solved.descent;
  const double u_first = patch.columns.front().rail_u;
  const double u_last = patch.columns.back().rail_u;
  const PlaneAxes axes(patch.plane);
  const PushBeside push(solved, patch.extent.half_length);
  bool missed = false;
  for (const Station& station : stations)
  {
    if (station.rail_u >= u_first && station.rail_u <= u_last)
    {
      continue;  // within the grid
    }
    const double t = axes.t(station.y, station.z);
    if (t >= grid.y0 - clearance && t <= grid.y(grid.ny - 1) + clearance)
    {
      continue;
    }
    const PlanePoint point = rail.at(station.rail_u);
    const double overlap = (closing - station.separation) * point.dy / axes.dt(point);  // along the plane's normal
    if (overlap > push.atLeast(t) && overlap > push.at(t))
    {
      missed = true;
      patch.extent.y_begin = std::min(patch.extent.y_begin, t);
      patch.extent.y_end = std::max(patch.extent.y_end, t);
    }
  }
  return missed;
}
}  // namespace wheel_rail_contact
