// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/gap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/track/column_heights.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Frame of a rail in the axes t and n of a plane.
RailFrame seenFrom(const PlaneAxes& axes, const RailFrame& rail)
{
  const PlanePoint origin = rail.at({0, 0, 1, 0, 0, 0});
  return {axes.t(origin), axes.n(origin), axes.dt(origin), axes.dn(origin)};
}

/// Starting parameters for the points of successive columns. They are extrapolated linearly over two columns from the
/// second-last and third-last column. The last column is not used, so that the processor can overlap the work on two
/// columns.
class ColumnStarts
{
 public:
  /// @param origin  column at the origin of the plane, where the plane is tangent to both bodies
  /// @param t       position of the first column in the plane [m]
  /// @param step    distance from column to column [m], negative towards smaller t
  ColumnStarts(const GapColumn& origin, double t, double step)
  {
    for (GapColumn& column : last_)
    {
      t -= step;
      column.wheel_u = origin.wheel_u + t;
      column.rail_u = origin.rail_u + t;
    }
  }

  GapColumn next() const
  {
    GapColumn start;
    start.wheel_u = 3 * last_[1].wheel_u - 2 * last_[2].wheel_u;
    start.rail_u = 3 * last_[1].rail_u - 2 * last_[2].rail_u;
    return start;
  }

  void add(const GapColumn& column) { last_ = {column, last_[0], last_[1]}; }
  void stayAt(const GapColumn& column) { last_.fill(column); }

 private:
  std::array<GapColumn, 3> last_;
};

/// Builds the columns of a gap one after the other, each starting from its neighbours.
class GapBuilder
{
 public:
  GapBuilder(const PlacedWheel& wheel, const PlacedRail& rail, const ContactPlane& plane, const Grid& grid)
      : grid_(grid),
        plane_x_(plane.x),
        rail_(seenFrom(PlaneAxes(plane), rail.frame())),
        wheel_(seenFrom(PlaneAxes(plane), wheel.sections())),
        heights_(wheel.profile(), wheel_, plane.x, 0.5 * grid.nx * grid.dx, grid.symmetric),
        wheel_profile_(wheel.profile()),
        rail_profile_(rail.profile())
  {
  }

  /// Builds the columns `first`, first + step, … up to the edge of the grid. The plane is tangent to both bodies at
  /// `origin`.
  /// @return false if none of these columns has points of both bodies.
  bool build(int first, int step, const GapColumn& origin, Eigen::ArrayXXd& gap, std::vector<GapColumn>& columns)
  {
    ColumnStarts starts(origin, grid_.y(first), step * grid_.dy);
    GapColumn column = origin;
    bool found_any = false;
    int count = 0;
    for (int j = first; j >= 0 && j < grid_.ny; j += step)
    {
      GapColumn next = starts.next();
      bool found = findMiddle(grid_.y(j), next, count);
      if (!found)
      {
        next = column;
        found = findMiddle(grid_.y(j), next, count);
      }
      if (found)
      {
        column = next;
        starts.add(column);
        place_[static_cast<std::size_t>(count++)] = j;
      }
      else
      {
        gap.col(j).setConstant(no_body_gap);
        starts.stayAt(column);
      }
      columns[static_cast<std::size_t>(j)] = column;
      if (count == ColumnGroup::together)
      {
        found_any = fillGroup(count, columns, gap) || found_any;
        count = 0;
      }
    }
    return fillGroup(count, columns, gap) || found_any;
  }

 private:
  /// Finds the points of both bodies above the position t of the plane. On entry, `column` contains the starting
  /// parameters. The result is written to `column`, that of the wheel also to place `k` of the group.
  /// @return false if a body has no point there.
  bool findMiddle(double t, GapColumn& column, int k)
  {
    const auto rail_curve = [this](double u, PlanePoint& point)
    {
      point = rail_.at(rail_profile_.at(u));
      return true;
    };
    CurveExpansion profile;
    double u = 0;
    const auto wheel_curve = [&](double at, PlanePoint& point)
    {
      u = at;
      profile = wheel_profile_.expansionAt(at);
      return wheel_.at(profile.point, plane_x_, point);
    };
    LocalPoint rail;
    LocalPoint wheel;
    if (!pointOver(t, rail_curve, column.rail_u, rail) || !pointOver(t, wheel_curve, column.wheel_u, wheel))
    {
      return false;
    }
    column.slope = 0.5 * (rail.slope + wheel.slope);
    column.gap_slope = wheel.slope - rail.slope;
    column.rail_height = rail.n;
    columns_.set(k, wheel_, t, u, profile, wheel.n, wheel_profile_.reach());
    return true;
  }

  /// Fills the gap in the columns of the first `count` places of the group. @return false if the wheel has no
  /// point somewhere along each of them.
  bool fillGroup(int count, const std::vector<GapColumn>& columns, Eigen::ArrayXXd& gap) const
  {
    bool found_any = false;
    if (count == 0)
    {
      return found_any;
    }
    const HeightPolynomials heights = heights_.polynomials(columns_, count);
    for (int k = 0; k < count; ++k)
    {
      const int j = place_[static_cast<std::size_t>(k)];
      if (std::isfinite(heights.row(k).sum()))
      {
        HeightPolynomial polynomial = heights.row(k).transpose();
        polynomial[0] -= columns[static_cast<std::size_t>(j)].rail_height;
        found_any = true;
        fillColumn(grid_, polynomial, gap.col(j).data());
      }
      else
      {
        gap.col(j).setConstant(no_body_gap);
      }
    }
    return found_any;
  }

  Grid grid_;
  double plane_x_;
  RailFrame rail_;
  WheelSections wheel_;
  ColumnHeights heights_;
  ProfileCursor wheel_profile_, rail_profile_;
  ColumnGroup columns_;
  std::array<int, ColumnGroup::together> place_{};  ///< column of the grid at each place of the group
};
}  // namespace

ContactPlane tangentPlane(const PlacedWheel& wheel, const PlacedRail& rail, const InitialContact& contact)
{
  const PlanePoint point = rail.at(contact.rail_u);
  ContactPlane plane{0, point.y, point.z, std::atan(contact.slope), contact.wheel_u, contact.rail_u};
  SpacePoint locus;
  if (wheel.locus(wheel.profile().at(contact.wheel_u), locus))
  {
    plane.x = locus.x;
  }
  return plane;
}

WheelSections seenFrom(const PlaneAxes& axes, const WheelSections& wheel)
{
  const WheelCoordinate& y = wheel.y;
  const WheelCoordinate& z = wheel.z;
  const auto turned = [&](double share_y, double share_z, double origin) -> WheelCoordinate
  {
    return {origin, share_y * y.along + share_z * z.along, share_y * y.down + share_z * z.down,
            share_y * y.forward + share_z * z.forward};
  };
  WheelSections seen = wheel;
  const PlanePoint centre{y.origin, z.origin, 0, 0};
  seen.y = turned(axes.cosine(), axes.sine(), axes.t(centre));
  seen.z = turned(-axes.sine(), axes.cosine(), axes.n(centre));
  return seen;
}

PlaneAxes::PlaneAxes(const ContactPlane& plane)
    : y_(plane.y), z_(plane.z), cosine_(std::cos(plane.angle)), sine_(std::sin(plane.angle))
{
}

bool buildGap(const PlacedWheel& wheel, const PlacedRail& rail, const ContactPlane& plane, const Grid& grid,
              Eigen::ArrayXXd& gap, std::vector<GapColumn>& columns)
{
  gap.resize(grid.rows(), grid.ny);
  columns.resize(static_cast<std::size_t>(grid.ny));
  GapBuilder builder(wheel, rail, plane, grid);
  const GapColumn origin{0, plane.wheel_u, plane.rail_u};
  const int middle = std::clamp(static_cast<int>(std::lround(-grid.y0 / grid.dy)), 0, grid.ny - 1);
  const bool up = builder.build(middle, 1, origin, gap, columns);
  const bool down = builder.build(middle - 1, -1, origin, gap, columns);
  return up || down;
}
}  // namespace wheel_rail_contact::core
