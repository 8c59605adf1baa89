// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/missed_pressure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double missed_clearance = 0.1;  ///< strip about a grid in which edges alone tell, of the grid's size [-]
constexpr double missed_share = 0.02;     ///< overlap beside a grid that is let pass, of the descent [-]
constexpr double nearest_line = 1e-3;     ///< least distance from a group's line that counts, of its half-length [-]
constexpr int most_groups = 8;            ///< in which the columns are taken together

/// How far a solved pressure pushes the bodies apart beside it: each group's load spread evenly over a line along the
/// track, as long as the pressure.
class PushBeside
{
 public:
  PushBeside(const SolvedPatch& solved, const WheelPatch& patch)
      : half_length_(std::max(patch.extent.half_length, solved.grid.dx)), center_x_(patch.center_x)
  {
    const Grid& grid = solved.grid;
    double moment = 0;
    double second_moment = 0;
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
        moment += share_[groups_] * place_[groups_];
        second_moment += share_[groups_] * place_[groups_] * place_[groups_];
        ++groups_;
      }
    }
    center_y_ = moment / total_;
    spread_ = std::max(second_moment / total_ - center_y_ * center_y_, 0.0) + half_length_ * half_length_ / 3;
  }

  /// Displacement of both bodies at place (x, y) of the patch frame [m].
  double at(double x, double y) const
  {
    const double ahead = half_length_ + (x - center_x_);
    const double behind = half_length_ - (x - center_x_);
    double sum = 0;
    for (std::size_t k = 0; k < groups_; ++k)
    {
      const double beside = std::max(std::abs(y - place_[k]), nearest_line * half_length_);
      sum += 0.5 * share_[k] * (std::asinh(ahead / beside) + std::asinh(behind / beside));
    }
    return sum;
  }

  /// What it is at least: as if all of the load stood at the mean of its squared distances (1/sqrt is convex) [m].
  double atLeast(double x, double y) const
  {
    const double dx = x - center_x_;
    const double dy = y - center_y_;
    return total_ * half_length_ / std::sqrt(dx * dx + dy * dy + spread_);
  }

 private:
  double half_length_;   ///< [m]
  double center_x_;      ///< of the load, patch frame [m]
  double center_y_ = 0;  ///< likewise [m]
  double spread_ = 0;    ///< mean squared distance of the load from there [m²]
  double total_ = 0;     ///< of the shares [m]
  std::size_t groups_ = 0;
  std::array<double, most_groups> place_{};  ///< [m]
  std::array<double, most_groups> share_{};  ///< [m]
};

/// A grid and the strip about it in which the pressure's edges tell.
struct Surroundings
{
  explicit Surroundings(const Grid& grid)
      : half_length((0.5 + missed_clearance) * grid.nx * grid.dx),
        y_begin(grid.y0 - missed_clearance * grid.ny * grid.dy),
        y_end(grid.y(grid.ny - 1) + missed_clearance * grid.ny * grid.dy)
  {
  }

  double half_length;     ///< [m]
  double y_begin, y_end;  ///< patch frame [m]
};

/// Where along the track a yawed wheel comes nearest to the rail at a station, patch frame [m]; the plane's own place
/// where nowhere.
double nearestPlace(const PlacedWheel& wheel, const Station& station, const ContactPlane& plane)
{
  SpacePoint locus;
  const bool found = wheel.locus(wheel.profile().at(station.wheel_u), locus);
  return found ? locus.x - plane.x : 0;
}
}  // namespace

bool growOverMissedPressure(const SolvedPatch& solved, const PlacedWheel& wheel, const std::vector<Station>& stations,
                            WheelPatch& patch)
{
  const double let_pass = missed_share * solved.penetration;
  const double u_first = patch.columns.front().rail_u;
  const double u_last = patch.columns.back().rail_u;
  const bool yawed = !solved.grid.symmetric;
  const Surroundings near(solved.grid);
  const PlaneAxes axes(patch.plane);
  std::optional<PushBeside> push;
  bool missed = false;
  for (const Station& station : stations)
  {
    if (station.depth < let_pass)
    {
      continue;
    }
    const bool in_columns = station.rail_u >= u_first && station.rail_u <= u_last;
    const double y = axes.t(station.y, station.z);
    const double x = yawed ? nearestPlace(wheel, station, patch.plane) : 0;
    const bool beside = !in_columns && (y < near.y_begin || y > near.y_end);
    if (!beside && !(std::abs(x) > near.half_length))
    {
      continue;
    }
    // Along the plane's normal.
    const double overlap = (station.depth - let_pass) / (axes.cosine() + axes.sine() * station.slope);
    if (!push)
    {
      push.emplace(solved, patch);
    }
    if (overlap > push->atLeast(x, y) && overlap > push->at(x, y))
    {
      missed = true;
      patch.extent.y_begin = std::min(patch.extent.y_begin, y);
      patch.extent.y_end = std::max(patch.extent.y_end, y);
      patch.extent.half_length = std::max(patch.extent.half_length, std::abs(x));
    }
  }
  return missed;
}
}  // namespace wheel_rail_contact::core
