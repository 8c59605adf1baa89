// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/surface_gap.h"

#include <algorithm>
#include <array>

#include "core/track/column_heights.h"
#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Parameter of a rail profile at the arc length `step` [m] from the parameter `u`, by the midpoint rule. It is exact
/// on lines and arcs. On polynomials, whose parameter is y, the error is of the order of step³.
double alongArc(ProfileCursor& profile, double u, double step)
{
  const auto speed = [&profile](double at)
  {
    const CurvePoint point = profile.at(at);
    return std::hypot(point.dy, point.dz);
  };
  return u + step / speed(u + 0.5 * step / speed(u));
}

/// Computes the columns of the gap one after the other.
class SurfaceGapBuilder
{
 public:
  SurfaceGapBuilder(const PlacedWheel& wheel, const PlacedRail& rail, double x, const Grid& grid)
      : grid_(grid),
        x_(x),
        rail_(rail.frame()),
        wheel_(wheel.sections()),
        heights_(wheel.profile(), wheel_, x, 0.5 * grid.nx * grid.dx, grid.symmetric),
        wheel_profile_(wheel.profile()),
        rail_profile_(rail.profile()),
        wheel_end_(wheel.profile().length()),
        rail_end_(rail.profile().length())
  {
  }

  /// Builds the columns `first`, first + step, … up to the edge of the grid.
  /// @return false if none of these columns has points of both bodies.
  bool build(int first, int step, const SurfaceOrigin& origin, Eigen::ArrayXXd& gap,
             std::vector<SurfaceColumn>& columns)
  {
    double arc = 0;
    double rail_u = origin.rail_u;
    double wheel_u = origin.wheel_u;
    bool found_any = false;
    int count = 0;
    for (int j = first; j >= 0 && j < grid_.ny; j += step)
    {
      const double move = grid_.y(j) - arc;
      arc = grid_.y(j);
      rail_u = alongArc(rail_profile_, rail_u, move);
      SurfaceColumn& column = columns[static_cast<std::size_t>(j)];
      column = railColumn(rail_u);
      wheel_u += move;
      column.wheel_u = wheel_u;
      if (rail_u < 0 || rail_u > rail_end_ || !findWheel(column, count))
      {
        column.wheel_u = wheel_u;
        gap.col(j).setConstant(no_body_gap);
        continue;
      }
      wheel_u = column.wheel_u;
      place_[static_cast<std::size_t>(count++)] = j;
      if (count == ColumnGroup::together)
      {
        found_any = fillGroup(count, gap) || found_any;
        count = 0;
      }
    }
    return fillGroup(count, gap) || found_any;
  }

 private:
  SurfaceColumn railColumn(double u)
  {
    const PlanePoint point = rail_.at(rail_profile_.at(u));
    SurfaceColumn column;
    column.y = point.y;
    column.z = point.z;
    column.angle = std::atan2(point.dz, point.dy);
    column.rail_u = u;
    return column;
  }

  /// Finds the point of the wheel on the normal at the middle of the column, from the starting parameter in `column`,
  /// and writes it to `column` and to place `k` of the group. @return false if there is none.
  bool findWheel(SurfaceColumn& column, int k)
  {
    ContactPlane plane;
    plane.x = x_;
    plane.y = column.y;
    plane.z = column.z;
    plane.angle = column.angle;
    const WheelSections seen = seenFrom(PlaneAxes(plane), wheel_);
    CurveExpansion profile;
    double u = 0;
    const auto curve = [&](double at, PlanePoint& point)
    {
      u = at;
      profile = wheel_profile_.expansionAt(at);
      return seen.at(profile.point, x_, point);
    };
    LocalPoint wheel;
    if (!pointOver(0, curve, column.wheel_u, wheel) || u < 0 || u > wheel_end_)
    {
      return false;
    }
    column.wheel_slope = wheel.slope;
    group_.set(k, seen, 0, u, profile, wheel.n, wheel_profile_.reach());
    return true;
  }

  /// Fills the gap in the columns of the first `count` places of the group. @return false if the wheel has no point
  /// somewhere along each of them.
  bool fillGroup(int count, Eigen::ArrayXXd& gap) const
  {
    bool found_any = false;
    if (count == 0)
    {
      return found_any;
    }
    const HeightPolynomials heights = heights_.polynomials(group_, count);
    for (int k = 0; k < count; ++k)
    {
      double* const column = gap.col(place_[static_cast<std::size_t>(k)]).data();
      if (std::isfinite(heights.row(k).sum()))
      {
        found_any = true;
        fillColumn(grid_, heights.row(k).transpose(), column);
      }
      else
      {
        std::fill_n(column, grid_.rows(), no_body_gap);
      }
    }
    return found_any;
  }

  Grid grid_;
  double x_;
  RailFrame rail_;
  WheelSections wheel_;
  ColumnHeights heights_;
  ProfileCursor wheel_profile_, rail_profile_;
  double wheel_end_, rail_end_;  ///< largest parameters of the profiles [m]
  ColumnGroup group_;
  std::array<int, ColumnGroup::together> place_{};  ///< column of the grid at each place of the group
};
}  // namespace

double arcLength(const Profile& profile, double from, double to)
{
  constexpr double longest_panel = 5e-4;  // [m]
  const int panels = 1 + static_cast<int>(std::abs(to - from) / longest_panel);
  const double step = (to - from) / panels;
  double length = 0;
  for (int i = 0; i < panels; ++i)
  {
    const CurvePoint middle = profile.at(from + (i + 0.5) * step);
    length += step * std::hypot(middle.dy, middle.dz);
  }
  return length;
}

bool buildSurfaceGap(const PlacedWheel& wheel, const PlacedRail& rail, const SurfaceOrigin& origin, const Grid& grid,
                     Eigen::ArrayXXd& gap, std::vector<SurfaceColumn>& columns)
{
  gap.resize(grid.rows(), grid.ny);
  columns.resize(static_cast<std::size_t>(grid.ny));
  SurfaceGapBuilder builder(wheel, rail, origin.x, grid);
  const int middle = std::clamp(static_cast<int>(std::lround(-grid.y0 / grid.dy)), 0, grid.ny - 1);
  const bool up = builder.build(middle, 1, origin, gap, columns);
  const bool down = builder.build(middle - 1, -1, origin, gap, columns);
  return up || down;
}
}  // namespace wheel_rail_contact::core
