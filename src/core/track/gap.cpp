// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/gap.h"

#include <algorithm>

#include "core/constants.h"
#include "core/normal/measures/pressure_measures.h"
#include "core/track/column_heights.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Columns that a vertical displacement opens by less are left out: a wall [-].
constexpr double smallest_opening = 0.05;

/// Sections of a wheel in the axes of a column: along the tangent of the rail and along its normal.
WheelSections seenFrom(const SurfaceColumn& column, const WheelSections& wheel)
{
  const WheelCoordinate &y = wheel.y, &z = wheel.z;
  const auto turned = [&](double share_y, double share_z) -> WheelCoordinate
  {
    return {share_y * (y.origin - column.y) + share_z * (z.origin - column.z), share_y * y.along + share_z * z.along,
            share_y * y.down + share_z * z.down, share_y * y.forward + share_z * z.forward};
  };
  WheelSections seen = wheel;
  seen.y = turned(column.cosine, column.sine);
  seen.z = turned(-column.sine, column.cosine);
  return seen;
}

/// Computes the columns of the gap one after the other.
class SurfaceGapBuilder
{
 public:
  SurfaceGapBuilder(const PlacedWheel& wheel, const PlacedRail& rail, const SurfaceOrigin& origin, const Grid& grid)
      : grid_(grid),
        x_(origin.x),
        rail_(rail),
        wheel_(wheel.sections()),
        heights_(wheel.profile(), wheel_),
        wheel_profile_(wheel.profile()),
        rail_profile_(rail.profile()),
        wheel_end_(wheel.profile().length()),
        rail_part_(rail.profile().partAt(origin.rail_u))
  {
  }

  /// Builds the columns `first`, first + step, … up to the edge of the grid.
  /// @return false if none of these columns has points of both bodies.
  bool build(int first, int step, const SurfaceOrigin& origin, Eigen::ArrayXXd& gap, Eigen::ArrayXXd& slope,
             std::vector<SurfaceColumn>& columns)
  {
    // Trapezoidal rule for the arc length: exact on lines and arcs. On polynomials, whose parameter is y, a column is
    // off by the change of the slope within a column, which does not add up.
    double arc = 0, rail_u = origin.rail_u, speed = speedAt(rail_u);
    double wheel_u = origin.wheel_u, wheel_step = 1;  // step of wheel_u per step of the arc
    bool found_any = false;
    int count = 0;
    for (int j = first; j >= 0 && j < grid_.ny; j += step)
    {
      const double move = grid_.y(j) - arc, step_u = move / speed, speed_before = speed;
      rail_u += step_u;
      SurfaceColumn& column = columns[static_cast<std::size_t>(j)];
      column = railColumn(rail_u, speed);
      arc += 0.5 * (speed_before + speed) * step_u;
      wheel_u += wheel_step * move;
      column.wheel_u = wheel_u;
      if (rail_u < rail_part_.begin || rail_u > rail_part_.end || !findWheel(column, count))
      {
        column.wheel_u = wheel_u;
        gap.col(j).setConstant(no_body_gap);
        continue;
      }
      wheel_step = j != first ? wheel_step + (column.wheel_u - wheel_u) / move : 1;
      wheel_u = column.wheel_u;
      place_[static_cast<std::size_t>(count++)] = j;
      if (count == ColumnGroup::together)
      {
        found_any = fillGroup(count, gap, slope, columns) || found_any;
        count = 0;
      }
    }
    return fillGroup(count, gap, slope, columns) || found_any;
  }

 private:
  using Numbers = ColumnGroup::Numbers;

  double speedAt(double u)
  {
    const CurvePoint point = rail_profile_.at(u);
    return std::sqrt(point.dy * point.dy + point.dz * point.dz);
  }

  /// @param speed  set to the arc length per unit of the parameter
  SurfaceColumn railColumn(double u, double& speed)
  {
    const CurvePoint on_profile = rail_profile_.at(u);
    const PlanePoint point = rail_.place(on_profile);
    SurfaceColumn column;
    column.y = point.y;
    column.z = point.z;
    speed = std::sqrt(point.dy * point.dy + point.dz * point.dz);
    const double per_length = 1 / speed;
    column.cosine = point.dy * per_length;
    column.sine = point.dz * per_length;
    column.rail_u = u;
    if (rail_.changes())
    {
      column.along = rail_.along(on_profile);
    }
    return column;
  }

  /// Finds the point of the wheel on the normal at the middle of the column, from the starting parameter in `column`,
  /// and writes it to `column` and to place `k` of the group. @return false if there is none.
  bool findWheel(SurfaceColumn& column, int k)
  {
    const WheelSections seen = seenFrom(column, wheel_);
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
    group_.set(k, seen, u, profile, wheel_profile_.reach());
    return true;
  }

  /// Fills gap and slope in the columns of the first `count` places of the group. @return false if the wheel has no
  /// point somewhere along each of them.
  bool fillGroup(int count, Eigen::ArrayXXd& gap, Eigen::ArrayXXd& slope, std::vector<SurfaceColumn>& columns)
  {
    const Numbers sum = fillRows(count, gap, slope);
    bool found_any = false;
    for (int k = 0; k < count; ++k)
    {
      const AlongShape& along = columns[static_cast<std::size_t>(column(k))].along;
      for (int row = 0; rail_.changes() && row < grid_.rows(); ++row)
      {
        gap(row, column(k)) -= along.at(x_ + grid_.x(row));
      }
      const bool found = std::isfinite(sum[k]);
      found_any = found_any || found;
      if (!found)
      {
        gap.col(column(k)).setConstant(no_body_gap);
        slope.col(column(k)).setZero();
      }
      columns[static_cast<std::size_t>(column(k))].has_bodies = found;
    }
    return found_any;
  }

  /// Evaluates each cell, from the middle of the columns to both of their ends. Returns the sum of the heights.
  Numbers fillRows(int count, Eigen::ArrayXXd& gap, Eigen::ArrayXXd& slopes)
  {
    Numbers sum = Numbers::Zero(), slope = Numbers::Zero();
    const auto fill = [&](int first, int end, int step)
    {
      Numbers u = group_.u;
      for (int row = first; row != end; row += step)
      {
        const Numbers n = heights_.heights(group_, count, x_ + grid_.x(row), u, slope);
        sum += n;
        for (int k = 0; k < count; ++k)
        {
          gap(row, column(k)) = n[k];
          slopes(row, column(k)) = slope[k];
        }
      }
    };
    const int middle = grid_.symmetric ? 0 : grid_.nx / 2;
    fill(middle, grid_.rows(), 1);
    fill(middle - 1, -1, -1);
    return sum;
  }

  Eigen::Index column(int place) const { return place_[static_cast<std::size_t>(place)]; }

  Grid grid_;
  double x_;
  const PlacedRail& rail_;
  WheelSections wheel_;
  ColumnHeights heights_;
  ProfileCursor wheel_profile_, rail_profile_;
  double wheel_end_;          ///< largest parameter of its profile [m]
  ParameterRange rail_part_;  ///< part of the rail on which the grid lies
  ColumnGroup group_;
  std::array<int, ColumnGroup::together> place_{};  ///< column of the grid at each place of the group
};

/// Share along the track of the contact in an overlap: that of a paraboloid with the same parts of the middle line and
/// of the tops of the columns above the contact. Each length follows from an integral of the overlap, in which the
/// cells join smoothly.
double shareAlong(const Grid& grid, const Eigen::ArrayXXd& gap, const std::vector<SurfaceColumn>& columns,
                  Eigen::Index deepest)
{
  constexpr int rounds = 3;  // one on a paraboloid whose grid contains half of its depth
  const double depth = columns[static_cast<std::size_t>(deepest)].overlap;
  double share = 0.5;
  for (int i = 0; i < rounds; ++i)
  {
    const double along = (-gap.col(deepest) - (1 - share) * depth).max(0.0).sum() * grid.dx * (grid.symmetric ? 2 : 1);
    double across = 0;
    for (const SurfaceColumn& column : columns)
    {
      across += std::max(column.overlap - share * depth, 0.0) * grid.dy;
    }
    share = contactShare(along / (share * std::sqrt(share)), across / ((1 - share) * std::sqrt(1 - share)));
  }
  return share;
}

/// Sets overlap and mean slope of the columns. The pressure is that of a Hertz contact in each column: its squared
/// half-length grows in proportion to the overlap beyond that at the end of the contact, which is `share` of the
/// largest one.
void setMeanSlopes(const Grid& grid, const Eigen::ArrayXXd& gap, const Eigen::ArrayXXd& slope,
                   std::vector<SurfaceColumn>& columns)
{
  const auto at = [&](Eigen::Index j) -> SurfaceColumn& { return columns[static_cast<std::size_t>(j)]; };
  Eigen::Index row = 0, deepest = 0;
  for (Eigen::Index j = 0; j < gap.cols(); ++j)
  {
    at(j).overlap = std::max(-gap.col(j).minCoeff(), 0.0);
    deepest = at(j).overlap > at(deepest).overlap ? j : deepest;
  }
  const double depth = at(deepest).overlap;
  const double share = depth > 0 ? shareAlong(grid, gap, columns, deepest) : 0.5, per_overlap = share / (1 - share);
  for (Eigen::Index j = 0; j < gap.cols(); ++j)
  {
    const double end = at(j).overlap - per_overlap * std::max(at(j).overlap - share * depth, 0.0);
    double sum = 0, moment = 0;
    for (Eigen::Index i = 0; at(j).overlap > 0 && i < gap.rows(); ++i)
    {
      const double pressure = std::sqrt(std::max(-gap(i, j) - end, 0.0));
      sum += pressure;
      moment += pressure * slope(i, j);
    }
    if (!(sum > 0))
    {
      gap.col(j).minCoeff(&row);
    }
    at(j).mean_slope = sum > 0 ? moment / sum : slope(row, j);
  }
}

/// Second differences of the gap, weighted with the overlap, and their weights.
struct Bend
{
  double sum = 0, weights = 0;

  template <typename Cells>
  void add(const Cells& before, const Cells& here, const Cells& after)
  {
    weights += (-here).max(0.0).sum();
    sum += ((-here).max(0.0) * (before + after - 2 * here)).sum();
  }
  double mean() const { return weights > 0 ? sum / weights : 0; }
};
}  // namespace

double arcLength(const Profile& profile, double from, double to)
{
  constexpr double longest_panel = 2e-3;  // [m]
  const int panels = 1 + static_cast<int>(std::abs(to - from) / longest_panel);
  const double step = (to - from) / panels;
  double length = 0;
  for (int i = 0; i < panels; ++i)
  {
    length += step * profile.speedAt(from + (i + 0.5) * step);
  }
  return length;
}

double contactShare(double overlap_length, double overlap_width)
{
  const double ratio = std::min(overlap_length, overlap_width) / std::max(overlap_length, overlap_width);
  const Elliptic integrals = elliptic(std::pow(ratio, 4 / pi));
  const double longer = integrals.d / integrals.k;
  return overlap_length > overlap_width ? longer : 1 - longer;
}

bool buildSurfaceGap(const PlacedWheel& wheel, const PlacedRail& rail, const SurfaceOrigin& origin, const Grid& grid,
                     Eigen::ArrayXXd& gap, Eigen::ArrayXXd& slope, std::vector<SurfaceColumn>& columns)
{
  gap.resize(grid.rows(), grid.ny);
  slope.setZero(grid.rows(), grid.ny);
  columns.resize(static_cast<std::size_t>(grid.ny));
  SurfaceGapBuilder builder(wheel, rail, origin, grid);
  const int middle = std::clamp(static_cast<int>(std::lround(-grid.y0 / grid.dy)), 0, grid.ny - 1);
  const bool up = builder.build(middle, 1, origin, gap, slope, columns);
  const bool down = builder.build(middle - 1, -1, origin, gap, slope, columns);
  setMeanSlopes(grid, gap, slope, columns);
  return up || down;
}

double halfSpaceRatio(const std::vector<SurfaceColumn>& columns, Eigen::Index first, Eigen::Index last)
{
  const SurfaceColumn& start = columns[static_cast<std::size_t>(first)];
  double rail_least = 0, rail_most = 0, wheel_least = start.wheel_slope,
         wheel_most = wheel_least;  // tangents of angles
  for (Eigen::Index j = first; j <= last; ++j)
  {
    const SurfaceColumn& column = columns[static_cast<std::size_t>(j)];
    const double turn = column.turnFrom(start);
    const double rail = turn / std::sqrt(1 - turn * turn);
    const double wheel = (rail + column.wheel_slope) / (1 - rail * column.wheel_slope);
    rail_least = std::min(rail_least, rail);
    rail_most = std::max(rail_most, rail);
    wheel_least = std::min(wheel_least, wheel);
    wheel_most = std::max(wheel_most, wheel);
  }
  return 0.5 * std::max(std::atan(rail_most) - std::atan(rail_least), std::atan(wheel_most) - std::atan(wheel_least));
}

void leaveOutWalls(std::vector<SurfaceColumn>& columns, PatchGap& patch)
{
  for (Eigen::Index j = 0; j < patch.grid.ny; ++j)
  {
    if (SurfaceColumn& column = columns[static_cast<std::size_t>(j)]; column.perUp() < smallest_opening)
    {
      patch.gap.col(j).setConstant(no_body_gap);
      column.overlap = 0;
    }
  }
}

void setNormals(const std::vector<SurfaceColumn>& columns, PatchGap& patch, ColumnNormals& normals)
{
  const auto at = [&](Eigen::Index j) -> const SurfaceColumn& { return columns[static_cast<std::size_t>(j)]; };
  Eigen::Index deepest = 0;
  for (Eigen::Index j = 1; j < patch.grid.ny; ++j)
  {
    deepest = at(j).overlap > at(deepest).overlap ? j : deepest;
  }
  patch.weight = std::max(at(deepest).perUp(), smallest_opening);
  normals.weight.resize(patch.grid.ny);
  double turn_least = 0, turn_most = 0;
  for (Eigen::Index j = 0; j < patch.grid.ny; ++j)
  {
    normals.weight[j] = std::max(at(j).perUp(), smallest_opening) / patch.weight;
    const double turn = at(j).overlap > 0 ? at(j).turnFrom(at(deepest)) : 0;
    turn_least = std::min(turn_least, turn);
    turn_most = std::max(turn_most, turn);
  }
  const bool turns = turn_most - turn_least > plane_turn;
  const double reference = turns ? at(deepest).angle() : 0;
  normals.turn.setZero(patch.grid.ny);
  for (Eigen::Index j = 0; turns && j < patch.grid.ny; ++j)
  {
    normals.turn[j] = at(j).angle() - reference;
  }
}

void raiseByCells(PatchGap& patch)
{
  Eigen::ArrayXXd& gap = patch.gap;
  const Eigen::Index rows = gap.rows() - 2;
  Bend along, across;
  if (rows > 0)
  {
    along.add(gap.topRows(rows), gap.middleRows(1, rows), gap.bottomRows(rows));
  }
  for (Eigen::Index j = 1; j + 1 < gap.cols(); ++j)
  {
    if (std::max(gap(0, j - 1), gap(0, j + 1)) < no_body_gap)
    {
      across.add(gap.col(j - 1), gap.col(j), gap.col(j + 1));
    }
  }
  gap += (along.mean() + across.mean()) / 48;
}

double gapSlope(const std::vector<SurfaceColumn>& columns, const PatchGap& patch, Eigen::Index j)
{
  const auto at = [&](Eigen::Index i) -> const SurfaceColumn& { return columns[static_cast<std::size_t>(i)]; };
  const double turn = at(j + 1).turnFrom(at(j - 1)) / (2 * patch.grid.dy);
  const Eigen::Index middle = patch.grid.symmetric ? 0 : patch.gap.rows() / 2;
  return at(j).wheel_slope * (1 - turn * patch.gap(middle, j));
}
}  // namespace wheel_rail_contact::core
