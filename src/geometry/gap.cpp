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
    const double miss = t - axes.t(point);
    u += miss / stretch;
    if (std::abs(miss) < tangential_tolerance)
    {
      out.slope = axes.dn(point) / stretch;
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

/// Even polynomial through the crest and two more places.
Quartic evenQuartic(double n0, double x1, double n1, double x2, double n2)
{
  const double s1 = x1 * x1;
  const double s2 = x2 * x2;
  const double c1 = (n1 - n0) / s1;
  const double c2 = (n2 - n0) / s2;
  const double fourth = (c2 - c1) / (s2 - s1);
  return {n0, 0, c1 - fourth * s1, 0, fourth};
}

/// Polynomial through n(-2h), n(-h), n(0), n(h), n(2h).
Quartic fullQuartic(double h, const std::array<double, 5>& n)
{
  const double odd1 = 0.5 * (n[3] - n[1]);
  const double odd2 = 0.5 * (n[4] - n[0]);
  const double even1 = 0.5 * (n[3] + n[1]) - n[2];
  const double even2 = 0.5 * (n[4] + n[0]) - n[2];
  const double third = (odd2 - 2 * odd1) / 6;
  const double fourth = (even2 - 4 * even1) / 12;
  return {n[2], (odd1 - third) / h, (even1 - fourth) / (h * h), third / (h * h * h), fourth / (h * h * h * h)};
}

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
        reach_(0.5 * grid.nx * grid.dx)
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
    LocalPoint crest;
    if (!pointOver(axes_, t, rail_curve, column.rail_u, rail) || !wheelOver(t, 0, column.wheel_u, crest) ||
        !(symmetric_ ? symmetricHeight(t, column.wheel_u, crest.n, shifts, height)
                     : fullHeight(t, column.wheel_u, crest.n, shifts, height)))
    {
      return false;
    }
    height[0] -= rail.n;
    column.slope = 0.5 * (rail.slope + crest.slope);
    column.parting = crest.slope - rail.slope;
    column.rail_height = rail.n;
    return true;
  }

 private:
  bool wheelOver(double t, double x, double& u, LocalPoint& out) const
  {
    const auto curve = [this, x](double at, PlanePoint& point)
    { return wheel_.section(wheel_.profile().at(at), plane_.x + x, point); };
    return pointOver(axes_, t, curve, u, out);
  }

  /// Over place x of the column whose crest has parameter `u`; `shift` is a guess and takes the result.
  bool wheelBeside(double t, double x, double u, double& shift, LocalPoint& out) const
  {
    double u_beside = u + shift;
    const bool found = wheelOver(t, x, u_beside, out);
    shift = u_beside - u;
    return found;
  }

  bool symmetricHeight(double t, double u, double crest, Shifts& shifts, Quartic& height) const
  {
    LocalPoint inner;
    LocalPoint outer;
    if (!wheelBeside(t, 0.6 * reach_, u, shifts[0], inner) || !wheelBeside(t, reach_, u, shifts[1], outer))
    {
      return false;
    }
    height = evenQuartic(crest, 0.6 * reach_, inner.n, reach_, outer.n);
    return true;
  }

  bool fullHeight(double t, double u, double crest, Shifts& shifts, Quartic& height) const
  {
    std::array<double, 5> n{};
    for (std::size_t i = 0; i < n.size(); ++i)
    {
      const double x = (0.5 * static_cast<double>(i) - 1) * reach_;
      LocalPoint point{crest, 0};
      if (i != 2 && !wheelBeside(t, x, u, shifts[i], point))
      {
        return false;
      }
      n[i] = point.n;
    }
    height = fullQuartic(0.5 * reach_, n);
    return true;
  }

  const PlacedWheel& wheel_;
  const PlacedRail& rail_;
  const ContactPlane& plane_;
  PlaneAxes axes_;
  bool symmetric_;
  double reach_;
};

void fillColumn(const Grid& grid, const Quartic& c, int column, Eigen::ArrayXXd& gap)
{
  for (int row = 0; row < grid.rows(); ++row)
  {
    const double x = grid.x(row);
    gap(row, column) = c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
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
