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
constexpr double missed_clearance = 0.1;  ///< width of the strip around a grid in which only the extrapolated edges
                                          ///< count, relative to the size of the grid [-]
constexpr double missed_share = 0.02;     ///< allowed overlap beside a grid, relative to the penetration [-]
constexpr double nearest_line = 1e-3;  ///< smallest distance from the line of a group, relative to its half-length [-]
constexpr int most_groups = 8;         ///< number of groups of columns

/// Displacement of both bodies beside a solved pressure. The columns are combined in groups. The load of each group is
/// spread evenly over a line along the track with the length of the pressure.
class DisplacementBeside
{
 public:
  DisplacementBeside(const SolvedPatch& solved, const WheelPatch& patch)
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

  /// Displacement of both bodies at position (x, y) of the patch frame [m].
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

  /// Lower bound of at(): all of the load at the root mean square of its distances (1/sqrt is convex) [m].
  double atLeast(double x, double y) const
  {
    const double dx = x - center_x_;
    const double dy = y - center_y_;
    return total_ * half_length_ / std::sqrt(dx * dx + dy * dy + spread_);
  }

 private:
  double half_length_;   ///< [m]
  double center_x_;      ///< x of the load's centre, patch frame [m]
  double center_y_ = 0;  ///< y of the load's centre, patch frame [m]
  double spread_ = 0;    ///< mean squared distance of the load from this centre [m²]
  double total_ = 0;     ///< sum of the shares [m]
  std::size_t groups_ = 0;
  std::array<double, most_groups> place_{};  ///< y of the lines, patch frame [m]
  std::array<double, most_groups> share_{};  ///< load of the lines, as a displacement [m]
};

/// A grid and the strip around it in which only the extrapolated edges of the pressure count.
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

/// Position x along the track at which a yawed wheel comes nearest to the rail at a station, patch frame [m]; 0 if
/// there is none.
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
  const double allowed_overlap = missed_share * solved.penetration;
  const double u_first = patch.columns.front().rail_u;
  const double u_last = patch.columns.back().rail_u;
  const bool yawed = !solved.grid.symmetric;
  const Surroundings near(solved.grid);
  const PlaneAxes axes(patch.plane);
  std::optional<DisplacementBeside> displacement;
  bool missed = false;
  for (const Station& station : stations)
  {
    if (station.depth < allowed_overlap)
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
    // Overlap along the normal of the plane.
    const double overlap = (station.depth - allowed_overlap) / (axes.cosine() + axes.sine() * station.slope);
    if (!displacement)
    {
      displacement.emplace(solved, patch);
    }
    if (overlap > displacement->atLeast(x, y) && overlap > displacement->at(x, y))
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
