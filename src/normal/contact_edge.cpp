// SPDX-License-Identifier: BSD-3-Clause
#include "contact_edge.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
/// Place of the edge of a line with a single loaded cell: the middle of the range where just one is loaded.
constexpr double kLoneCell = 0.325;

double straightEdge(double p1, double p2)
{
  const double outer = std::min(p1, p2);
  return (1.07425 * outer - 0.17475 * p2) / (p2 - 0.42487 * outer);
}

/// The square between four neighbouring cell centres; `p` points to the one at its lowest row and column.
class Square
{
 public:
  Square(const double* p, std::ptrdiff_t column) : p_(p), column_(column) {}

  int loadedCorners() const { return loaded(0, 0) + loaded(1, 0) + loaded(0, 1) + loaded(1, 1); }

  /// Loaded share of the square if one, two or three corners are loaded.
  double cutShare() const
  {
    const int corners = loadedCorners();
    if (corners == 1 || (corners == 2 && loaded(0, 0) == loaded(1, 1)))
    {
      return corner(0, 0) + corner(1, 0) + corner(0, 1) + corner(1, 1);
    }
    if (corners == 3)
    {
      return withoutCorner(loaded(0, 0) && loaded(0, 1) ? 1 : 0, loaded(0, 0) && loaded(1, 0) ? 1 : 0);
    }
    return loaded(0, 0) == loaded(1, 0) ? strip(0, 1, loaded(0, 0) ? 0 : 1) : strip(1, 0, loaded(0, 0) ? 0 : 1);
  }

 private:
  const double* at(int i, int j) const { return p_ + i + j * column_; }
  bool loaded(int i, int j) const { return *at(i, j) > 0; }

  /// Edge's distance from corner (i, j) along x (towards the other row) or along y.
  double reach(int i, int j, bool along_x) const
  {
    const std::ptrdiff_t inward = along_x ? (i == 0 ? -1 : 1) : (j == 0 ? -column_ : column_);
    const double* p = at(i, j);
    return std::min(edgeDistance(p[0], p[inward], p[2 * inward]), 1.0);
  }

  /// Triangle at a corner, zero if it is not loaded.
  double corner(int i, int j) const
  {
    return loaded(i, j) ? 0.5 * std::max(reach(i, j, true), 0.0) * std::max(reach(i, j, false), 0.0) : 0;
  }

  /// All but the triangle at corner (i, j), which is not loaded.
  double withoutCorner(int i, int j) const
  {
    return 1 - 0.5 * (1 - reach(1 - i, j, true)) * (1 - reach(i, 1 - j, false));
  }

  /// Two loaded neighbours: (0, side) and (1, side) with the edge along x, or (side, 0) and (side, 1) along y.
  double strip(int di, int dj, int side) const
  {
    const bool edge_along_x = dj == 1;
    const int i = edge_along_x ? 0 : side, j = edge_along_x ? side : 0;
    return 0.5 * (reach(i, j, !edge_along_x) + reach(i + dj, j + di, !edge_along_x));
  }

  const double* p_;
  std::ptrdiff_t column_;
};
}  // namespace

double edgeDistance(double p1, double p2, double p3)
{
  if (!(p2 > 0))
  {
    return kLoneCell;
  }
  const double straight = straightEdge(p1, p2);
  // Factor of the term distance^(3/2); the divisor is the value of the bracket for that term itself.
  const double bend = (p3 - 1.42487 * p2 + 0.26582 * p1) / 1.42;
  const double x1 = std::max(straight, 0.0), x2 = 1 + straight;
  return straightEdge(p1 - bend * x1 * std::sqrt(x1), p2 - bend * x2 * std::sqrt(x2));
}

double contactCells(const Eigen::ArrayXXd& framed, bool mirrored)
{
  const Eigen::Index stride = framed.rows(), last_row = framed.rows() - kFrame, last_column = framed.cols() - kFrame;
  double cells = 0;
  for (Eigen::Index j = kFrame - 1; j < last_column; ++j)
  {
    for (Eigen::Index i = kFrame - 1; i < last_row; ++i)
    {
      const Square square(framed.data() + i + j * stride, stride);
      const int corners = square.loadedCorners();
      const double share = corners == 0 || corners == 4 ? 0.25 * corners : square.cutShare();
      cells += mirrored && i == kFrame - 1 ? 0.5 * share : share;
    }
  }
  return cells;
}
}  // namespace wheel_rail_contact
