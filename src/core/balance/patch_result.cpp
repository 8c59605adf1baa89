// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/patch_result.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/normal/measures/pressure_measures.h"
#include "core/track/gap.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double least_approach = 1e-12;  ///< smaller ones are rounding [m]

/// Centre of pressure on a grid [m].
struct Centre
{
  double x = 0, y = 0;
};

Centre centreOf(const Grid& grid, const Eigen::ArrayXXd& pressure)
{
  Centre centre;
  const double sum = pressure.sum();
  for (int j = 0; j < grid.ny; ++j)
  {
    centre.y += pressure.col(j).sum() / sum * grid.y(j);
  }
  for (int i = 0; i < grid.rows() && !grid.symmetric; ++i)
  {
    centre.x += pressure.row(i).sum() / sum * grid.x(i);
  }
  return centre;
}

/// Force of an island on the rail [N].
struct Force
{
  double forward = 0, outward = 0, down = 0;
};

/// @param x  of the centre of pressure [m]
Force forceOf(const PlacedRail& rail, const Grid& grid, double x, const Eigen::ArrayXXd& pressure,
              const std::vector<SurfaceColumn>& columns, std::size_t begin)
{
  Force force;
  for (int j = 0; j < grid.ny; ++j)
  {
    const double share = grid.cellArea() * pressure.col(j).sum();
    const SurfaceColumn& column = columns[begin + static_cast<std::size_t>(j)];
    force.outward -= share * column.perOutward();
    force.down += share * column.perUp();
    force.forward += share * rail.ownAlong(column.rail_u).slopeAt(x);
  }
  return force;
}

/// Point and tangent of a rail at the place x from the axle [m].
PlanePoint beside(const PlacedRail& rail, double u, double x)
{
  PlanePoint point = rail.at(u);
  const double rise = rail.ownAlong(u).at(x) / std::hypot(point.dy, point.dz);
  point.y -= rise * point.dz;
  point.z += rise * point.dy;
  return point;
}

/// Change of the normal force per approach [N/m]. The stiffness of a flat punch with the shape of the contact is at
/// least the squared force over the work [J] of any pressure (Thomson's principle). The pressure of a contact on an
/// ellipse falls short by 1.2; so does about that of a contact on a surface that turns, which is no ellipse.
double normalStiffness(const PatchResult& patch, double work, double of_ellipse)
{
  constexpr double largest_turn = 0.4, over_bound = 1.2;
  const double bound = over_bound * patch.normal_force * patch.normal_force / work;
  return patch.half_space_ratio > largest_turn ? NAN : std::max(of_ellipse, bound);
}

/// Copies the whole pressure field of a patch, in track axes, from the centre of pressure.
void copyPressure(Side side, const Grid& grid, const Centre& centre, const Eigen::ArrayXXd& stored, PatchResult& result)
{
  const double first = (0.5 - 0.5 * grid.nx) * grid.dx, y0 = grid.y0 - centre.y;
  const double mirrored = -(y0 + (grid.ny - 1) * grid.dy);
  result.grid = {grid.nx, grid.ny, grid.dx, grid.dy, first - centre.x, side == Side::left ? y0 : mirrored};
  wholePressure(side, grid, stored, result.pressure);
}

constexpr double size_error = 0.012;     ///< [-]
constexpr double turned_factor = 0.12;   ///< [1/rad²]
constexpr double parallel_factor = 0.5;  ///< normals that turn are taken to be parallel [1/rad²]
constexpr double largest_ratio = 0.55;   ///< of the contacts that were compared, approximately [rad]
constexpr double not_known = 1;          ///< [-]

/// Arc length from the origin of a profile to the parameter u [m].
double arcFromOrigin(const Profile& profile, double u)
{
  return arcLength(profile, profile.partAt(u).origin, u);
}
}  // namespace

void fillPatch(Side side, const WheelsetBalance& balance, std::size_t island, PatchResult& out)
{
  const Islands& islands = balance.islands(side);
  const Island& of = islands.islands()[island];
  const PatchGap& gap = islands.problem().patches[island];
  const NormalSolution& solution = islands.solution();
  const PatchPressure& pressure = solution.patches[island];
  const WheelContact& contact = balance.wheel(side).contact();
  const std::vector<SurfaceColumn>& columns = contact.grids().columns()[of.patch];
  const auto begin = static_cast<std::size_t>(of.begin);

  const Centre centre = centreOf(gap.grid, pressure.pressure);
  const double place = std::clamp((centre.y - gap.grid.y0) / gap.grid.dy, 0.0, std::max(gap.grid.ny - 1.000001, 0.0));
  const auto before = begin + static_cast<std::size_t>(place);
  const double share = place - std::floor(place);
  const auto between = [share](double first, double second) { return first + share * (second - first); };
  const ProfilePlaces places{between(columns[before].wheel_u, columns[before + 1].wheel_u),
                             between(columns[before].rail_u, columns[before + 1].rail_u)};
  const double x = contact.grids().originOf(of.patch).x + centre.x;
  const PlanePoint origin = beside(contact.rail(), places.rail_u, x);
  const Force force = forceOf(contact.rail(), gap.grid, x, pressure.pressure, columns, begin);
  const double angle = std::atan2(force.outward, force.down), sign = sideSign(side);
  out.side = side;
  out.contact_angle = angle;
  out.normal_force = std::hypot(force.outward, force.down);
  out.slope_along = force.forward / out.normal_force;
  out.pose = {x, sign * origin.y, origin.z, sign * angle, -std::atan(out.slope_along)};
  out.vertical_force = force.down;
  out.lateral_force = force.outward;
  placeOnBodies(balance.config(), balance.pose(), contact.rail(), places, out);
  Eigen::Index row = 0, deepest = 0;
  gap.gap.minCoeff(&row, &deepest);
  const SurfaceColumn& column = columns[begin + static_cast<std::size_t>(deepest)];
  out.approach = overlapAlongNormal(contact.wheel(), contact.rail(), column.wheel_u, column.rail_u, gap.grid.dy);
  out.area = pressure.area;
  const SemiAxes ellipse = equalEllipse(pressure);
  out.semi_axis_along = ellipse.along;
  out.semi_axis_across = ellipse.across;
  out.max_pressure = pressure.max_pressure;
  out.error_estimate =
      std::hypot(balance.errors(side)[island].largest(),
                 balance.balanceError(side) * contact.overlap() / std::max(out.approach, least_approach));
  out.iterations = solution.iterations;
  out.residual = solution.residual;
  out.half_space_ratio = halfSpaceRatio(columns, of.first, of.last);
  out.left_out = contact.leftOut();
  const bool turns = 2 * out.half_space_ratio > plane_turn, is_complete = out.left_out.empty();
  const double work = force.down * solution.approach - gap.grid.cellArea() * (pressure.pressure * gap.gap).sum();
  out.normal_stiffness =
      normalStiffness(out, turns && is_complete ? work : infinity, punchStiffness(ellipse, islands.problem().modulus));
  const bool is_turned = is_complete && contact.problem().normals[of.patch].areTurned();
  out.model_error = modelError(out.half_space_ratio, is_turned);
  if (is_complete && !turns)  // normals may be parallel or not, depending on the grid
  {
    out.error_estimate += parallel_factor * out.half_space_ratio * out.half_space_ratio;
  }
  copyPressure(side, gap.grid, centre, pressure.pressure, out);
}

void wholePressure(Side side, const Grid& grid, const Eigen::ArrayXXd& stored, Eigen::ArrayXXd& whole)
{
  whole.resize(grid.nx, grid.ny);
  if (grid.symmetric)
  {
    whole.bottomRows(grid.rows()) = stored;
    whole.topRows(grid.rows()) = stored.colwise().reverse();
  }
  else
  {
    whole = stored;
  }
  if (side == Side::right)
  {
    whole.rowwise().reverseInPlace();
  }
}

double modelError(double half_space_ratio, bool is_turned)
{
  if (!(half_space_ratio <= largest_ratio))
  {
    return not_known;
  }
  return size_error + (is_turned ? turned_factor : parallel_factor) * half_space_ratio * half_space_ratio;
}

ShapeEffect shapeEffect(Side side, const WheelsetBalance& balance, const Profile& profile, std::size_t island,
                        double max_pressure)
{
  const WheelContact& contact = balance.wheel(side).contact();
  const Island& of = balance.islands(side).islands()[island];
  const std::vector<SurfaceColumn>& columns = contact.grids().columns()[of.patch];
  const SurfaceColumn &begin = columns[static_cast<std::size_t>(of.first)],
                      &end = columns[static_cast<std::size_t>(of.last)];
  const ShapeError of_rail = contact.rail().profile().errorWithin(begin.rail_u, end.rail_u);
  const ShapeError of_wheel =
      profile.errorWithin(std::min(begin.wheel_u, end.wheel_u), std::max(begin.wheel_u, end.wheel_u));
  if (of_rail.missing || of_wheel.missing)
  {
    return {1, true};
  }
  const double curvature_error = std::hypot(of_rail.curvature, of_wheel.curvature);
  if (curvature_error == 0 || of.first == of.last)
  {
    return {};
  }
  const double width = static_cast<double>(of.last - of.first) * contact.problem().patches[of.patch].grid.dy;
  const double curvature = std::abs(end.wheel_slope - begin.wheel_slope) / width;
  const double position_error = std::hypot(of_rail.position, of_wheel.position);
  const double long_waves = 0.5 * curvature_error / curvature;
  const double short_waves =
      std::sqrt(0.5) * contact.problem().modulus * std::sqrt(position_error * curvature_error) / max_pressure;
  return {std::min({long_waves, short_waves, 1.0}), false};
}

void placeOnBodies(const ContactModelConfig& config, const WheelsetPose& axle, const PlacedRail& rail,
                   const ProfilePlaces& places, PatchResult& patch)
{
  const Eigen::Vector3d forward(std::cos(axle.yaw), std::sin(axle.yaw), 0);
  const Eigen::Vector3d up = forward.cross(axleDirection(axle.yaw, axle.roll));
  const Eigen::Vector3d place(patch.pose.x, patch.pose.y - axle.y, patch.pose.z - axle.z);
  patch.wheel_angle = std::atan2(place.dot(forward), -place.dot(up));

  const Profile& wheel = *config.wheel_profile[patch.side];
  const PlacedWheel placed(wheel, config.wheelset, patch.side, toSide(patch.side, axle), rail.rim().rise);
  const double wheel_u = placed.opposite(beside(rail, places.rail_u, patch.pose.x), patch.pose.x, places.wheel_u);
  const CurvePoint on_wheel = wheel.at(wheel_u);
  patch.rolling_radius = placed.sections().radius - on_wheel.z + rail.rim().along.at(patch.pose.x);
  patch.wheel_s = arcFromOrigin(wheel, wheel_u);
  patch.rail_s = arcFromOrigin(rail.profile(), places.rail_u);
  patch.curvature_along = std::abs(on_wheel.dy) / std::hypot(on_wheel.dy, on_wheel.dz) / patch.rolling_radius;
  patch.curvature_along -= rail.along(places.rail_u).curvature;
  patch.curvature_across = on_wheel.curvature() - rail.profile().at(places.rail_u).curvature();
}
}  // namespace wheel_rail_contact::core
