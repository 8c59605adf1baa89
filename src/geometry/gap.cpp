// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/geometry/gap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
constexpr int newton_iterations = 12;
/// Distance along the plane at which a point counts as found [m]; the rest is made up for by the slope there, which
/// leaves an error of curvature * tolerance² / 2 < 1e-10 m on the sharpest arcs.
constexpr double tangential_tolerance = 1e-6;
/// How far from a column's crest the wheel's profile is told by its derivatives there, if no joint lies within [m]: the
/// third derivative leaves 1e-11 m on the sharpest arcs. Across a joint it would jump, and the search not end.
constexpr double near_crest = 2e-5;

/// A point seen from the plane.
struct LocalPoint
{
  double n;      ///< height over the plane [m]
  double slope;  ///< dn/dt [-]
};

/// Finds the point of a plane curve (`at(u, point)`, false where it has none) over place `t` of the plane.
template <typename Curve>
bool pointOver(const PlaneAxes& axes, double t, Curve at, double& u, LocalPoint& out)
{
  for (int i = 0; i < newton_iterations; ++i)
  {
    PlanePoint point;
    if (!at(u, point))
    {
      return false;
    }
    const double stretch = axes.dt(point);
    if (!(stretch > 0))
    {
      return false;
    }
    const double per_stretch = 1 / stretch;
    const double miss = t - axes.t(point);
    u += miss * per_stretch;
    if (std::abs(miss) < tangential_tolerance)
    {
      out.slope = axes.dn(point) * per_stretch;
      out.n = axes.n(point) + out.slope * miss;
      return true;
    }
  }
  return false;
}

/// Height of the wheel over one column as a polynomial of x.
using Quartic = std::array<double, 5>;

/// How far the wheel's points over the other places of a column lie from the one over its crest, along the profile [m].
using Shifts = std::array<double, 5>;

/// Polynomials through the heights at places that all columns share.
class HeightFit
{
 public:
  /// Places for columns that are symmetric: the crest and these [m]; for others: -2h, -h, 0, h, 2h.
  explicit HeightFit(double reach)
      : inner_(0.6 * reach),
        outer_(reach),
        per_inner_(1 / (inner_ * inner_)),
        per_outer_(1 / (outer_ * outer_)),
        per_difference_(1 / (outer_ * outer_ - inner_ * inner_)),
        h_(0.5 * reach),
        per_h_(1 / h_)
  {
  }

  double inner() const { return inner_; }
  double outer() const { return outer_; }
  double h() const { return h_; }

  Quartic even(double n_crest, double n_inner, double n_outer) const
  {
    const double c1 = (n_inner - n_crest) * per_inner_;
    const double c2 = (n_outer - n_crest) * per_outer_;
    const double fourth = (c2 - c1) * per_difference_;
    return {n_crest, 0, c1 - fourth * inner_ * inner_, 0, fourth};
  }

  Quartic full(const std::array<double, 5>& n) const
  {
    const double odd1 = 0.5 * (n[3] - n[1]);
    const double odd2 = 0.5 * (n[4] - n[0]);
    const double even1 = 0.5 * (n[3] + n[1]) - n[2];
    const double even2 = 0.5 * (n[4] + n[0]) - n[2];
    const double third = (odd2 - 2 * odd1) * (1.0 / 6);
    const double fourth = (even2 - 4 * even1) * (1.0 / 12);
    const double square = per_h_ * per_h_;
    return {n[2], (odd1 - third) * per_h_, (even1 - fourth) * square, third * square * per_h_,
            fourth * square * square};
  }

 private:
  double inner_, outer_;                           ///< [m]
  double per_inner_, per_outer_, per_difference_;  ///< of the squares [1/m²]
  double h_, per_h_;                               ///< [m], [1/m]
};

/// Point of the wheel's profile over the middle of a column.
struct Crest
{
  double u = 0;         ///< [m]
  CurvePoint point{};   ///< there
  LocalPoint seen{};    ///< from the plane
  bool smooth = false;  ///< no joint lies within near_crest
};

/// One column: both bodies over place t of the plane.
class ColumnBuilder
{
 public:
  ColumnBuilder(const PlacedWheel& wheel, const PlacedRail& rail, const ContactPlane& plane, const Grid& grid)
      : wheel_(wheel),
        rail_(rail),
        plane_(plane),
        axes_(plane),
        symmetric_(grid.symmetric),
        fit_(0.5 * grid.nx * grid.dx)
  {
  }

  /// `column` and `shifts` hold the starting parameters and take the result.
  bool build(double t, GapColumn& column, Shifts& shifts, Quartic& height) const
  {
    LocalPoint rail;
    const auto rail_curve = [this](double u, PlanePoint& point)
    {
      point = rail_.at(u);
      return true;
    };
    Crest crest;
    if (!pointOver(axes_, t, rail_curve, column.rail_u, rail) || !findCrest(t, column.wheel_u, crest) ||
        !(symmetric_ ? symmetricHeight(t, crest, shifts, height) : fullHeight(t, crest, shifts, height)))
    {
      return false;
    }
    height[0] -= rail.n;
    column.slope = 0.5 * (rail.slope + crest.seen.slope);
    column.parting = crest.seen.slope - rail.slope;
    column.rail_height = rail.n;
    return true;
  }

 private:
  bool findCrest(double t, double& u, Crest& crest) const
  {
    const auto curve = [&](double at, PlanePoint& point)
    {
      crest.u = at;
      crest.point = wheel_.profile().at(at);
      return wheel_.section(crest.point, plane_.x, point);
    };
    const bool found = pointOver(axes_, t, curve, u, crest.seen);
    crest.smooth = found && wheel_.profile().isOneSection(crest.u - near_crest, crest.u + near_crest);
    return found;
  }

  CurvePoint pointBeside(const Crest& crest, double shift) const
  {
    if (!crest.smooth || std::abs(shift) > near_crest)
    {
      return wheel_.profile().at(crest.u + shift);
    }
    const CurvePoint& p = crest.point;
    return {p.y + shift * (p.dy + 0.5 * shift * p.ddy),
            p.z + shift * (p.dz + 0.5 * shift * p.ddz),
            p.dy + shift * p.ddy,
            p.dz + shift * p.ddz,
            p.ddy,
            p.ddz};
  }

  /// Over place x of the column; `shift` is a guess and takes the result.
  bool wheelBeside(double t, double x, const Crest& crest, double& shift, LocalPoint& out) const
  {
    const auto curve = [&](double from_crest, PlanePoint& point)
    { return wheel_.section(pointBeside(crest, from_crest), plane_.x + x, point); };
    return pointOver(axes_, t, curve, shift, out);
  }

  bool symmetricHeight(double t, const Crest& crest, Shifts& shifts, Quartic& height) const
  {
    LocalPoint inner;
    LocalPoint outer;
    if (!wheelBeside(t, fit_.inner(), crest, shifts[0], inner) ||
        !wheelBeside(t, fit_.outer(), crest, shifts[1], outer))
    {
      return false;
    }
    height = fit_.even(crest.seen.n, inner.n, outer.n);
    return true;
  }

  bool fullHeight(double t, const Crest& crest, Shifts& shifts, Quartic& height) const
  {
    std::array<double, 5> n{};
    for (std::size_t i = 0; i < n.size(); ++i)
    {
      const double x = (static_cast<double>(i) - 2) * fit_.h();
      LocalPoint point = crest.seen;
      if (i != 2 && !wheelBeside(t, x, crest, shifts[i], point))
      {
        return false;
      }
      n[i] = point.n;
    }
    height = fit_.full(n);
    return true;
  }

  const PlacedWheel& wheel_;
  const PlacedRail& rail_;
  const ContactPlane& plane_;
  PlaneAxes axes_;
  bool symmetric_;
  HeightFit fit_;
};

/// By value: to the compiler, what is written may change any number it does not hold itself.
void fillColumn(Grid grid, Quartic c, int column, Eigen::ArrayXXd& gap)
{
  double* height = gap.col(column).data();
  for (int row = 0; row < grid.rows(); ++row)
  {
    const double x = grid.x(row);
    height[row] = c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
  }
}

/// Columns `first`, first + step, … to the grid's edge; each starts from its neighbours' parameters.
bool buildColumns(const ColumnBuilder& builder, const Grid& grid, int first, int step, GapColumn column,
                  Eigen::ArrayXXd& gap, std::vector<GapColumn>& columns)
{
  GapColumn before = column;
  Shifts shifts{};
  bool found_any = false;
  for (int j = first; j >= 0 && j < grid.ny; j += step)
  {
    GapColumn next = column;
    next.rail_u += column.rail_u - before.rail_u;
    next.wheel_u += column.wheel_u - before.wheel_u;
    Quartic height;
    const auto at = static_cast<std::size_t>(j);
    if (builder.build(grid.y(j), next, shifts, height))
    {
      fillColumn(grid, height, j, gap);
      before = found_any ? column : next;
      column = next;
      columns[at] = next;
      found_any = true;
    }
    else
    {
      gap.col(j).setConstant(no_body_gap);
      columns[at] = column;
      before = column;
      shifts = {};
    }
  }
  return found_any;
}
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

PlaneAxes::PlaneAxes(const ContactPlane& plane)
    : y_(plane.y), z_(plane.z), cosine_(std::cos(plane.angle)), sine_(std::sin(plane.angle))
{
}

bool buildGap(const PlacedWheel& wheel, const PlacedRail& rail, const ContactPlane& plane, const Grid& grid,
              Eigen::ArrayXXd& gap, std::vector<GapColumn>& columns)
{
  gap.resize(grid.rows(), grid.ny);
  columns.resize(static_cast<std::size_t>(grid.ny));
  const ColumnBuilder builder(wheel, rail, plane, grid);
  const GapColumn origin{0, plane.wheel_u, plane.rail_u};
  const int middle = std::clamp(static_cast<int>(std::lround(-grid.y0 / grid.dy)), 0, grid.ny - 1);
  const bool up = buildColumns(builder, grid, middle, 1, origin, gap, columns);
  const bool down = buildColumns(builder, grid, middle - 1, -1, origin, gap, columns);
  return up || down;
}
}  // namespace wheel_rail_contact
