// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/contact_derivatives.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "core/balance/overlap_grids.h"
#include "core/balance/patch_result.h"
#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
using Wrench6 = Eigen::Matrix<double, 6, 1>;
using Movements = MovedContact::Movements;

constexpr std::size_t outward = 0, up = 1, turn_z = 3;  // movements; 2 is a roll
/// Movements for the differences of the geometry [m], [rad]: small against an overlap, large against the accuracy of
/// the points of a gap. A yaw hardly changes the gap of cells that move with the contact.
constexpr std::array<double, MovedContact::movements> small_movements{1e-6, 1e-6, 1e-6, 5e-5};

constexpr int force_x = 0, force_y = 1, force_z = 2, moment_x = 3, moment_y = 4, moment_z = 5;

WheelsetPose moved(WheelsetPose axle, std::size_t movement, double step)
{
  const std::array<double*, MovedContact::movements> all{&axle.y, &axle.z, &axle.roll, &axle.yaw};
  *all[movement] += step;
  return axle;
}

/// Signs of the components of a wrench in track axes and in side axes.
Wrench6 mirrored(double sign)
{
  Wrench6 signs;
  signs << 1, sign, 1, sign, 1, sign;
  return signs;
}
}  // namespace

/// Builds the gaps of an axle on the cells of the solution. The cells move along the track with the contact: a yaw
/// moves it by far more than it changes it, and a fixed grid would add its own ripple.
void MovedContact::build(const WheelsetPose& axle, Cells& cells)
{
  const std::vector<PatchGap>& patches = problem_->patches;
  const PlacedWheel wheel = wheelAt(axle), before = contact_->wheel();
  cells.patches.resize(patches.size());
  cells.columns.resize(patches.size());
  cells.x.resize(patches.size());
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    PatchGap& patch = cells.patches[k];
    patch.grid = patches[k].grid;
    SurfaceOrigin origin = contact_->grids().originOf(k);
    const CurvePoint middle = wheel.profile().at(origin.wheel_u);
    origin.x += wheel.locusX(middle) - before.locusX(middle);
    cells.x[k] = origin.x;
    buildSurfaceGap(wheel, contact_->rail(), origin, patch.grid, patch.gap, slope_, cells.columns[k]);
    leaveOutWalls(cells.columns[k], patch);
    raiseByCells(patch);
  }
}

PlacedWheel MovedContact::wheelAt(const WheelsetPose& axle) const
{
  return {*config_->wheel_profile[side_], config_->wheelset, side_, axle, contact_->rail().rim().rise};
}

/// Force and moment of the pressure, and of its change by a movement, on the wheel. As in a result, each island acts at
/// its centre of pressure; only the moment about x is that of the columns.
Wrench6 MovedContact::wrenchOf(const Cells& cells, const WheelsetPose& axle, double step,
                               const std::vector<Eigen::ArrayXXd>& change) const
{
  Wrench6 sum = Wrench6::Zero();
  for (const Island& island : *islands_)
  {
    const std::size_t k = island.patch;
    const Grid& grid = cells.patches[k].grid;
    const Eigen::ArrayXXd& pressure = solution_->patches[k].pressure;
    double whole = 0, lever_x = 0, lever_y = 0, lever_z = 0;  // [N], [N m]
    Wrench6 part = Wrench6::Zero();
    AlongShape along{0, 0};  // weighted with the forces
    for (Eigen::Index j = island.begin; j < island.begin + island.columns; ++j)
    {
      double force = 0;
      for (Eigen::Index i = 0; i < grid.rows(); ++i)
      {
        const double in_cell = grid.cellArea() * (pressure(i, j) + step * change[k](i, j));
        force += in_cell;
        lever_x += in_cell * (cells.x[k] + (grid.symmetric ? 0 : grid.x(static_cast<int>(i))));
      }
      if (force == 0)
      {
        continue;
      }
      const SurfaceColumn& column = cells.columns[k][static_cast<std::size_t>(j)];
      const double y = force * column.perOutward(), z = force * column.perUp();
      const double arm_y = column.y - axle.y, arm_z = column.z - axle.z;
      whole += force;
      lever_y += force * arm_y;
      lever_z += force * arm_z;
      part[force_y] += y;
      part[force_z] += z;
      part[moment_x] += arm_y * z - arm_z * y;
      const AlongShape own = contact_->rail().ownAlong(column.rail_u);
      along.slope += force * own.slope;
      along.curvature += force * own.curvature;
    }
    const double x = lever_x / whole;
    part[force_x] = -along.slopeAt(x);
    part[moment_y] = lever_z / whole * part[force_x] - x * part[force_z];
    part[moment_z] = x * part[force_y] - lever_y / whole * part[force_x];
    sum += part;
  }
  return sum;
}

/// Finds the changes by the movements from `first` to `end` (exclusive) on the cells of a problem.
void MovedContact::findColumns(std::size_t first, std::size_t end, const CurvedProblem& problem,
                               const NormalSolution& solution, const WheelsetPose& axle)
{
  problem_ = &problem;
  solution_ = &solution;
  openings_.resize(end - first);
  for (std::size_t m = first; m < end; ++m)
  {
    const double step = small_movements[m];
    build(moved(axle, m, step), ahead_[m]);
    build(moved(axle, m, -step), behind_[m]);
    const std::vector<PatchGap>&ahead = ahead_[m].patches, &behind = behind_[m].patches;
    openings_[m - first].resize(ahead.size());
    for (std::size_t k = 0; k < ahead.size(); ++k)
    {
      openings_[m - first][k] = (ahead[k].gap - behind[k].gap) / (2 * step);
    }
  }
  tangent_.pressures(problem, solution, openings_, changes_);
  for (std::size_t m = first; m < end; ++m)
  {
    const double step = small_movements[m];
    const std::vector<Eigen::ArrayXXd>& change = changes_[m - first];
    const Wrench6 ahead = wrenchOf(ahead_[m], moved(axle, m, step), step, change),
                  behind = wrenchOf(behind_[m], moved(axle, m, -step), -step, change);
    held_.col(static_cast<Eigen::Index>(m)) = (ahead - behind) / (2 * step);
    wrench_ = 0.5 * (ahead + behind);
  }
}

void MovedContact::find(const ContactModelConfig& config, Side side, const WheelContact& contact,
                        const Islands& islands, const WheelsetPose& axle)
{
  config_ = &config;
  side_ = side;
  contact_ = &contact;
  islands_ = &islands.islands();
  problem_ = &contact.problem();
  solution_ = &contact.solution();
  if (!problem_->patches.front().grid.symmetric)
  {
    findColumns(0, movements, *problem_, *solution_, axle);
    return;
  }
  findColumns(0, turn_z, *problem_, *solution_, axle);
  unfold();
  findColumns(turn_z, movements, whole_problem_, whole_solution_, axle);
}

/// Copies problem and pressure to whole grids: a yaw changes a symmetric pressure to one that is not.
void MovedContact::unfold()
{
  whole_problem_ = *problem_;
  whole_solution_.patches.resize(problem_->patches.size());
  for (std::size_t k = 0; k < problem_->patches.size(); ++k)
  {
    wholePressure(Side::left, problem_->patches[k].grid, solution_->patches[k].pressure,
                  whole_solution_.patches[k].pressure);
    whole_problem_.patches[k].grid.symmetric = false;
  }
}

/// A rail that moves is a wheel that moves the other way. A rail that rolls outward by an angle about its reference
/// point is a wheel that rolls about this point, seen from axes that roll back.
Movements MovedContact::onBendingRail(const WheelEquilibrium& wheel, const WheelsetPose& axle, bool own_force) const
{
  const SupportedRail& support = wheel.support();
  if (!support.bends())
  {
    return held_;
  }
  const PlanePoint head = wheel.contact().rail().referencePoint();
  const double y = axle.y - head.y, z = axle.z - head.z;
  Eigen::Matrix<double, movements, 3> as_axle = Eigen::Matrix<double, movements, 3>::Zero();
  as_axle(outward, 0) = as_axle(up, 1) = -1;
  as_axle.col(2) << -z, y, 1, 0;
  Eigen::Matrix<double, 6, 3> by_rail = held_ * as_axle;
  Wrench6 turned;
  turned << 0, wrench_[force_z], -wrench_[force_y], 0, wrench_[moment_z], -wrench_[moment_y];
  by_rail.col(2) += turned;
  // Forces on the rail along its coordinates: (-Y, -Z, M - z Y + y Z).
  const auto on_rail = [&](const auto& change)
  {
    Eigen::Matrix<double, 3, std::decay_t<decltype(change)>::ColsAtCompileTime> forces;
    forces << -change.row(force_y), -change.row(force_z),
        change.row(moment_x) - z * change.row(force_y) + y * change.row(force_z);
    return forces;
  };
  Eigen::Matrix<double, 3, movements> by_axle = on_rail(held_);
  by_axle(2, outward) += wrench_[force_z];
  by_axle(2, up) -= wrench_[force_y];
  Eigen::Matrix3d back = on_rail(by_rail);
  back(2, 0) -= wrench_[force_z];
  back(2, 1) += wrench_[force_y];
  if (!own_force)  // a given lateral force acts at the height of the contact
  {
    const double height = wheel.contact().solved().heightOverReference();
    by_axle.row(2) -= height * by_axle.row(0);
    back.row(2) -= height * back.row(0);
    by_axle.row(0).setZero();
    back.row(0).setZero();
  }
  const Eigen::Matrix3d closed = Eigen::Matrix3d::Identity() - back * support.compliance();
  if (!(closed.determinant() > 0))
  {
    return Movements::Constant(NAN);
  }
  return held_ + by_rail * support.compliance() * closed.partialPivLu().solve(by_axle);
}

/// Sets all derivatives to NaN.
std::string_view WheelsetDerivatives::missing(std::string_view reason, ContactDerivatives& out) const
{
  const bool solves = config_.wheelset.solve_height_and_roll;
  out.forces.setConstant(6, ContactDerivatives::positions, NAN);
  out.solution.setConstant(solves ? 6 : 0, solves ? ContactDerivatives::positions : 0, NAN);
  return reason;
}

std::string_view WheelsetDerivatives::find(const WheelsetBalance& balance, ContactDerivatives& out)
{
  const NormalMethod method = config_.contact.method;
  const bool own_force = config_.rail_bending.lateral_force == RailBendingConfig::LateralForce::contact;
  const bool solves = config_.wheelset.solve_height_and_roll;
  out.forces.setZero(6, ContactDerivatives::positions);
  if (method != NormalMethod::automatic && method != NormalMethod::conjugate_gradient)
  {
    return missing("no derivatives: contact/method is neither auto nor conjugate_gradient", out);
  }
  for (const Side side : sides)
  {
    const double sign = sideSign(side);
    const WheelEquilibrium& wheel = balance.wheel(side);
    wheels_[side].setZero();
    if (wheel.loaded())
    {
      const WheelsetPose axle = toSide(side, balance.pose());
      contacts_[side].find(config_, side, wheel.contact(), balance.islands(side), axle);
      const Eigen::Vector4d movements(sign, 1, sign, sign);
      wheels_[side] =
          mirrored(sign).asDiagonal() * contacts_[side].onBendingRail(wheel, axle, own_force) * movements.asDiagonal();
    }
    out.forces += wheels_[side];
  }
  if (!out.forces.allFinite())
  {
    return missing("no derivatives: the deflection of a rail is at a branch", out);
  }
  if (solves && !solve(balance, out))
  {
    out.solution.setConstant(NAN);
    return "no derivatives of height and roll: they are at a branch";
  }
  return "";
}

/// Height of the axle over that at which a wheel without load touches its rail: change by y, z, roll and yaw.
Eigen::RowVector4d WheelsetDerivatives::touchRow(const WheelsetBalance& balance, Side side) const
{
  using Wheel = WheelEquilibrium;
  const Wheel& wheel = balance.wheel(side);
  const double sign = sideSign(side), by_lateral = sign * wheel.rate(Wheel::height_rate, Wheel::by_lateral);
  const CurvePoint point = config_.wheel_profile[side]->at(wheel.contact().grids().touch().wheel_u);
  const double x = wheel.contact().wheel().locusX(point);
  return {-by_lateral, 1, -sign * wheel.rate(Wheel::height_rate, Wheel::by_roll), -by_lateral * x};
}

/// Height and roll follow from the equations of the balance (implicit function theorem). The sign of their determinant
/// is that of a stable balance of two like wheels, on rails of the same height.
/// @return false at a branch
bool WheelsetDerivatives::solve(const WheelsetBalance& balance, ContactDerivatives& out) const
{
  const double base = 2 * config_.wheelset.halfBase();
  const bool by_moments = config_.wheelset.balance == WheelsetConfig::Balance::moments;
  const bool both = balance.wheel(Side::left).loaded() && balance.wheel(Side::right).loaded();
  Eigen::Matrix<double, 2, 4> by_axle;  // equations by y, z, roll, yaw
  Eigen::Matrix2d by_load;              // by force_z and torque_x
  if (by_moments && both)
  {
    by_axle << out.forces.row(force_z), out.forces.row(moment_x);
    by_load.setIdentity();
  }
  else
  {
    for (const Side side : sides)
    {
      const int row = static_cast<int>(side);
      const bool loaded = balance.wheel(side).loaded();
      by_axle.row(row) = loaded ? Eigen::RowVector4d(wheels_[side].row(force_z)) : touchRow(balance, side);
      by_load.row(row) = !loaded      ? Eigen::RowVector2d(0, 0)
                         : by_moments ? Eigen::RowVector2d(1, 0)
                                      : Eigen::RowVector2d(0.5, sideSign(side) / base);
    }
  }
  Eigen::Matrix2d unknown, given;
  unknown << by_axle.col(1), by_axle.col(2);
  given << by_axle.col(0), by_axle.col(3);
  Eigen::Matrix<double, 2, 4> right;
  right << given, by_load;
  out.solution.resize(6, ContactDerivatives::positions);
  if (!((both && !by_moments ? -1 : 1) * unknown.determinant() > 0))
  {
    return false;
  }
  const Eigen::Matrix<double, 2, 4> change = -unknown.partialPivLu().solve(right);
  out.solution.topRows<2>() = change;
  for (const Side side : sides)
  {
    const Movements& wheel = wheels_[side];
    Eigen::Matrix<double, 2, 4> forces;
    forces << wheel.row(force_z), -sideSign(side) * wheel.row(force_y);
    Eigen::Matrix<double, 2, 2> by_solution, by_given;
    by_solution << forces.col(1), forces.col(2);
    by_given << forces.col(0), forces.col(3);
    Eigen::Matrix<double, 2, 4> total = by_solution * change;
    total.leftCols<2>() += by_given;
    out.solution.middleRows<2>(2 + 2 * static_cast<int>(side)) = total;
  }
  return out.solution.allFinite();
}
}  // namespace wheel_rail_contact::core
