// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/contact_edge.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
/// Position of the edge of a line with a single loaded cell [cells]: the middle of the range in which exactly one cell
/// is loaded.
constexpr double lone_cell = 0.325;
/// Smallest area, as a share of the polygon. Limits the bias correction where the edge consists of corners only
/// (islands of single cells).
constexpr double least_share = 0.5;

double straightEdge(double p1, double p2)
{
  const double outer = std::min(p1, p2);
  return (1.07425 * outer - 0.17475 * p2) / (p2 - 0.42487 * outer);
}

/// Edge on the four sides of a square between neighbouring cell centres: its distances from the loaded end of each side
/// [cells].
struct EdgeSides
{
  double lower = 0, upper = 0;  ///< along x, at the first and second column
  double left = 0, right = 0;   ///< along y, at the first and second row
};

/// Quarter turns of the edge in a square with these loaded corners. An island has four in total, a hole in an island -4
/// (Gray 1971, for cells that are neighbours by their sides).
constexpr std::array<int, 16> quarter_turns{0, 1, 1, 0, 1, 0, 2, -1, 1, 2, 0, -1, 0, -1, -1, 0};

/// Loaded share of a square. Bits of `corners`: 1 first row and column, 2 second row, 4 second column, 8 both second.
double loadedShare(unsigned corners, const EdgeSides& s)
{
  const int turns = quarter_turns[corners];
  if (turns == 0)
  {
    const double ends = corners == 1 + 2 || corners == 4 + 8 ? s.left + s.right : s.lower + s.upper;
    return corners == 0 ? 0 : corners == 15 ? 1 : 0.5 * ends;
  }
  double share = 0;
  for (unsigned corner = 0; corner < 4; ++corner)
  {
    const double along = corner < 2 ? s.lower : s.upper, across = corner % 2 == 0 ? s.left : s.right;
    const bool loaded = (corners >> corner & 1U) != 0;
    if (loaded == (turns > 0))
    {
      // The triangle at a loaded corner; or all but that at an empty one, with distances from the corners beside it.
      share += loaded ? 0.5 * std::max(along, 0.0) * std::max(across, 0.0) : 1 - 0.5 * (1 - along) * (1 - across);
    }
  }
  return share;
}

/// Distance of the edge from the loaded cell of a crossing [cells], at most 1.
double reach(const EdgeCrossing& crossing)
{
  const double* loaded = crossing.loaded;
  const std::ptrdiff_t inward = -crossing.outward;
  return edgeDistance(loaded[0], loaded[inward], loaded[2 * inward]);
}
}  // namespace

/// Near its edge the true pressure increases with the root of the distance. For cells of constant pressure that satisfy
/// the contact condition at their centres, the discrete pressures next to such an edge are linear functions of its
/// position, for any cell size. With the edge d cells outside the first centre:
///   d = (1.07425 p1 - 0.17475 p2) / (p2 - 0.42487 p1),   p3 = 1.42487 p2 - 0.26582 p1.
/// The numbers were fitted (to 1e-5) to a line contact 667 cells wide, moved through one cell in 200 steps. A cell is
/// loaded if d lies between -0.175 and 0.825. A deviation of p3 from this relation is attributed to the next term of
/// the pressure, (distance)^(3/2). This term is first removed from p1 and p2.
double edgeDistance(double p1, double p2, double p3)
{
  if (!(p2 > 0))
  {
    return lone_cell;
  }
  const double straight = straightEdge(p1, p2);
  // Factor of the term distance^(3/2). The divisor is the value of the bracket for this term.
  const double bend = (p3 - 1.42487 * p2 + 0.26582 * p1) / 1.42;
  const double x1 = std::max(straight, 0.0), x2 = 1 + straight;
  return std::min(straightEdge(p1 - bend * x1 * std::sqrt(x1), p2 - bend * x2 * std::sqrt(x2)), 1.0);
}

void EdgePolygon::frame(const Eigen::ArrayXXd& pressure, bool mirrored)
{
  rows_ = pressure.rows();
  columns_ = pressure.cols();
  stride_ = rows_ + 2 * frame_width;
  mirrored_ = mirrored;
  framed_.assign(static_cast<std::size_t>(stride_ * (columns_ + 2 * frame_width)), 0.0);
  crossings_.reserve(2 * framed_.size());
  inputs_.reserve(2 * framed_.size());
  for (Eigen::Index j = 0; j < columns_; ++j)
  {
    double* column = framed_.data() + frame_width + (j + frame_width) * stride_;
    std::copy_n(pressure.data() + j * rows_, rows_, column);
    for (Eigen::Index i = 0; mirrored && i < std::min<Eigen::Index>(frame_width, rows_); ++i)
    {
      column[-1 - i] = column[i];
    }
  }
}

double EdgePolygon::cells(double aspect)
{
  const EdgeBias& known = edgeBias();
  const double polygon = chords(), images = mirrored_ ? 2 : 1;
  inputs_.clear();
  if (crossings_.empty())
  {
    return 0;
  }
  const double longer = std::log(aspect);
  double bias = known.of(images * polygon, islands_) / images;
  for (const EdgeCrossing& crossing : crossings_)
  {
    inputs_.push_back(edgeInputs(crossing, longer));
    bias += static_cast<double>(known.crossing(inputs_.back()));
  }
  return std::max(polygon - bias, least_share * polygon);
}

EdgePolygon::Cell EdgePolygon::loadedCell(const EdgeCrossing& crossing) const
{
  const std::ptrdiff_t from_corner = crossing.loaded - framed_.data();
  return {from_corner % stride_ - frame_width, from_corner / stride_ - frame_width};
}

EdgeCrossing EdgePolygon::crossingAfter(const double* p, std::ptrdiff_t step) const
{
  const bool rises = !(p[0] > 0);
  return {rises ? p + step : p, rises ? -step : step, step == 1 ? stride_ : 1, step == 1};
}

double EdgePolygon::cross(const double* p, std::ptrdiff_t step, double place)
{
  crossings_.push_back(crossingAfter(p, step));
  const double distance = reach(crossings_.back()), sign = p[0] > 0 ? 1 : -1;
  const double end = p[0] > 0 ? place + distance : place + 1 - distance;
  (step == 1 ? moments_along_ : moments_across_).add(end, sign);
  if (step == 1 && mirrored_)
  {
    moments_along_.add(-end, -sign);
  }
  return distance;
}

/// Adds the integrals up to the end of a part, or subtracts those up to its beginning.
void EdgePolygon::Moments::add(double end, double sign)
{
  zeroth += sign * end;
  first += sign * end * end / 2;
  second += sign * end * end * end / 3;
}

/// Mean square distance from the centre.
double EdgePolygon::Moments::variance() const
{
  const double centre = first / zeroth;
  return second / zeroth - centre * centre;
}

double EdgePolygon::gyrationRatio() const
{
  const double along = moments_along_.variance(), across = moments_across_.variance();
  return along > 0 && across > 0 ? std::sqrt(along / across) : 0;  // not a number without a contact
}

double EdgePolygon::chords()
{
  crossings_.clear();
  moments_along_ = moments_across_ = {};
  along_.resize(static_cast<std::size_t>(stride_));
  double whole = 0, middle = 0;
  int turns = 0;
  for (Eigen::Index j = -1; j < columns_; ++j)
  {
    const double *p = at(-1, j), *q = p + stride_;
    unsigned corners = (p[0] > 0 ? 2U : 0U) | (q[0] > 0 ? 8U : 0U);
    EdgeSides edges;
    // For a mirrored pressure: a crossing with the image of the first row, which is not counted as another crossing.
    edges.right = corners == 2 || corners == 8 ? reach(crossingAfter(p, stride_)) : 0;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(rows_); ++i, ++p, ++q)
    {
      // Half of the corners and two of the sides are those of the previous row and column.
      corners = (corners >> 1 & 5U) | (p[1] > 0 ? 2U : 0U) | (q[1] > 0 ? 8U : 0U);
      if (corners != 0 && corners != 15)
      {
        const unsigned second_row = corners & 10U, second_column = corners & 12U;
        edges.left = edges.right;
        edges.right = second_row == 2 || second_row == 8 ? cross(p + 1, stride_, static_cast<double>(j)) : 0;
        edges.lower = along_[i];
        edges.upper = second_column == 4 || second_column == 8 ? cross(q, 1, static_cast<double>(i) - 0.5) : 0;
        along_[i] = edges.upper;
      }
      const double share = loadedShare(corners, edges);
      whole += share;
      middle += i == 0 ? share : 0;
      turns += quarter_turns[corners];
    }
  }
  islands_ = (mirrored_ ? 2 : 1) * turns / 4;  // squares across the mirror have no turn
  return mirrored_ ? whole - 0.5 * middle : whole;
}
}  // namespace wheel_rail_contact::core
