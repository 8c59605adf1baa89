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
/// By how much each crossing of the edge with a line of cell centres makes the polygon too large [cells].
constexpr double kEachCrossing = 0.005;
/// By how much its chords cut a closed edge short [cells], and what few cells take away from that [cells²].
constexpr double kChords = 0.67, kFewCells = 1.5;
/// By how much more on each of the four sides, per cell that the edge lies farther out there; and what of it goes by
/// that squared, for square cells and per unit of the logarithm of their shape.
constexpr double kTip = 0.295, kTipBend = 0.335, kLongTipBend = 0.295;
/// How far out crossings are found at an edge askew to their line, per unit of the logarithm of the cells' shape, each
/// end of a chord: anywhere between two cells; by the place there (and on square cells); by its square on steep edges,
/// and on very long cells. See EdgePolygon.
constexpr double kAskew = 0.0026, kPlace = 0.18, kSquarePlace = -0.024, kSteep = -0.469, kVeryLong = -0.0115;

double straightEdge(double p1, double p2)
{
  const double outer = std::min(p1, p2);
  return (1.07425 * outer - 0.17475 * p2) / (p2 - 0.42487 * outer);
}

/// Distances of the edge on the four sides of a square between neighbouring cell centres, from the loaded end of each.
struct Sides
{
  double lower = 0, upper = 0;  ///< along x, at the first and second column
  double left = 0, right = 0;   ///< along y, at the first and second row
};

double triangle(double a, double b)
{
  return 0.5 * std::max(a, 0.0) * std::max(b, 0.0);
}

/// A chord's ends on lines along x, or on lines along y, by the edge's distances d there.
struct Ends
{
  int count = 0;
  double place = 0;   ///< sum of t = d - kLoneCell
  double square = 0;  ///< sum of t² less its mean over all places

  Ends() = default;
  explicit Ends(double distance) { add(distance); }
  Ends(double first, double last)
  {
    add(first);
    add(last);
  }
  void add(double distance)
  {
    const double t = distance - kLoneCell;
    ++count;
    place += t;
    square += t * t - 1.0 / 12;
  }
};

/// How the edge crosses a square between neighbouring cell centres; nothing where two chords do.
struct Chord
{
  double rows = 0, columns = 0;  ///< its extent [cells]
  Ends along, across;            ///< on lines along x, on lines along y
};

struct Square
{
  double share;  ///< loaded
  Chord chord;
};

/// One corner is loaded, or all others are; `a` and `b` are the distances along x and along y.
Square loadedCorner(double a, double b)
{
  return {triangle(a, b), {a, b, Ends(a), Ends(b)}};
}

Square emptyCorner(double a, double b)
{
  return {1 - 0.5 * (1 - a) * (1 - b), {1 - a, 1 - b, Ends(a), Ends(b)}};
}

/// Bits of `corners`: 1 first row and column, 2 second row, 4 second column, 8 both second.
Square squareOf(unsigned corners, const Sides& s)
{
  switch (corners)
  {
    case 1:
      return loadedCorner(s.lower, s.left);
    case 2:
      return loadedCorner(s.lower, s.right);
    case 4:
      return loadedCorner(s.upper, s.left);
    case 8:
      return loadedCorner(s.upper, s.right);
    case 1 + 8:
      return {triangle(s.lower, s.left) + triangle(s.upper, s.right), {}};
    case 2 + 4:
      return {triangle(s.lower, s.right) + triangle(s.upper, s.left), {}};
    case 1 + 2:
    case 4 + 8:
      return {0.5 * (s.left + s.right), {1, s.right - s.left, Ends(), Ends(s.left, s.right)}};
    case 1 + 4:
    case 2 + 8:
      return {0.5 * (s.lower + s.upper), {s.upper - s.lower, 1, Ends(s.lower, s.upper), Ends()}};
    case 15 - 1:
      return emptyCorner(s.lower, s.left);
    case 15 - 2:
      return emptyCorner(s.lower, s.right);
    case 15 - 4:
      return emptyCorner(s.upper, s.left);
    default:
      return emptyCorner(s.upper, s.right);
  }
}

/// What ends on lines along x make a chord too far out by; a rule for those along y as well, rows and columns swapped
/// and the other sign of `longer`. `squared_sine`: of the angle in the plane between the edge and what is square to the
/// lines; `length`: the chord's, in cells.
double askewAtEnds(const Ends& ends, double rows, double columns, double length, double squared_sine, double longer)
{
  const double slope = rows / length, askew = slope * columns;
  return longer * kAskew * ends.count * squared_sine + (longer * kPlace + kSquarePlace) * askew * ends.place +
         longer * (kSteep * slope * slope * askew + kVeryLong * std::abs(longer) * columns * squared_sine) *
             ends.square;
}

/// What both ends of a chord make it too far out by [cells].
double askewAt(const Chord& chord, double aspect, double longer)
{
  const double rows = std::abs(chord.rows), columns = std::abs(chord.columns);
  const double length = std::sqrt(rows * rows + columns * columns);
  if (!(length > 0))
  {
    return 0;
  }
  const double along = aspect * rows * aspect * rows, across = columns * columns, sum = along + across;
  return askewAtEnds(chord.along, rows, columns, length, along / sum, longer) +
         askewAtEnds(chord.across, columns, rows, length, across / sum, -longer);
}

/// Edge's distance from the loaded one of two neighbouring cells, `p` and the one `step` further.
double reach(const double* p, std::ptrdiff_t step)
{
  const double* loaded = p[0] > 0 ? p : p + step;
  const std::ptrdiff_t inward = p[0] > 0 ? -step : step;
  return std::min(edgeDistance(loaded[0], loaded[inward], loaded[2 * inward]), 1.0);
}
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

void EdgePolygon::frame(const Eigen::ArrayXXd& pressure, bool mirrored)
{
  rows_ = pressure.rows();
  columns_ = pressure.cols();
  stride_ = rows_ + 2 * kFrame;
  mirrored_ = mirrored;
  framed_.assign(static_cast<std::size_t>(stride_ * (columns_ + 2 * kFrame)), 0.0);
  for (Eigen::Index j = 0; j < columns_; ++j)
  {
    double* column = framed_.data() + kFrame + (j + kFrame) * stride_;
    std::copy_n(pressure.data() + j * rows_, rows_, column);
    for (Eigen::Index i = 0; mirrored && i < std::min<Eigen::Index>(kFrame, rows_); ++i)
    {
      column[-1 - i] = column[i];
    }
  }
}

double EdgePolygon::cells(double aspect)
{
  const double longer = std::log(aspect);
  const double polygon = polygonCells(aspect, longer);
  return std::max(polygon - excess(polygon, longer), 0.0);
}

void EdgePolygon::Tip::see(int outward, double reach)
{
  if (outward > line)
  {
    line = outward;
    farthest = reach;
  }
  else if (outward == line)
  {
    farthest = std::max(farthest, reach);
  }
}

double EdgePolygon::Tip::cutShort(double longer) const
{
  const double t = farthest - kLoneCell;
  return line > none ? (kTip - (kTipBend - kLongTipBend * longer) * t) * t : 0;
}

double EdgePolygon::excess(double polygon, double longer) const
{
  const double images = mirrored_ ? 2 : 1;
  const double chords = std::max(kChords - kFewCells / std::max(images * polygon, 1.0), 0.0);
  const double tips_along = front_.cutShort(longer) + (mirrored_ ? 0 : back_.cutShort(longer));
  const double tips_across = left_.cutShort(-longer) + right_.cutShort(-longer);
  return kEachCrossing * crossings_ + askew_ - tips_along - (chords + tips_across) / images;
}

double EdgePolygon::polygonCells(double aspect, double longer)
{
  crossings_ = 0;
  askew_ = 0;
  front_ = back_ = left_ = right_ = {};
  along_.resize(static_cast<std::size_t>(stride_));
  double whole = 0, middle = 0;
  for (Eigen::Index j = -1; j < columns_; ++j)
  {
    const double *p = at(-1, j), *q = p + stride_;
    unsigned corners = (p[0] > 0 ? 2U : 0U) | (q[0] > 0 ? 8U : 0U);
    Sides sides;
    sides.right = corners == 2 || corners == 8 ? reach(p, stride_) : 0;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(rows_); ++i, ++p, ++q)
    {
      // Half of this square's corners and two of its sides are its neighbours', of the row and the column before.
      corners = (corners >> 1 & 5U) | (p[1] > 0 ? 2U : 0U) | (q[1] > 0 ? 8U : 0U);
      double share = corners == 15 ? 1 : 0;
      if (corners != 0 && corners != 15)
      {
        const unsigned second_row = corners & 10U, second_column = corners & 12U;
        sides.left = sides.right;
        const bool crosses_row = second_row == 2 || second_row == 8;
        const bool crosses_column = second_column == 4 || second_column == 8;
        sides.right = crosses_row ? reach(p + 1, stride_) : 0;
        sides.lower = along_[i];
        sides.upper = crosses_column ? reach(q, 1) : 0;
        along_[i] = sides.upper;
        const int row = static_cast<int>(i), column = static_cast<int>(j);
        if (crosses_row)
        {
          ++crossings_;
          second_row == 2 ? right_.see(column, sides.right) : left_.see(-column, sides.right);
        }
        if (crosses_column)
        {
          ++crossings_;
          second_column == 4 ? front_.see(row, sides.upper) : back_.see(-row, sides.upper);
        }
        const Square square = squareOf(corners, sides);
        share = square.share;
        askew_ += askewAt(square.chord, aspect, longer);  // nothing at x = 0 of a mirrored pressure
      }
      whole += share;
      middle += i == 0 ? share : 0;
    }
  }
  return mirrored_ ? whole - 0.5 * middle : whole;
}
}  // namespace wheel_rail_contact
