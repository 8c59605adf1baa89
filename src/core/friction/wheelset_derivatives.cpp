// SPDX-License-Identifier: BSD-3-Clause
#include "core/friction/wheelset_derivatives.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
using Eigen::Vector3d;

constexpr int force_y = 1, force_z = 2, moment_x = 3;
constexpr int y_column = 0, z_column = 1, roll_column = 2, yaw_column = 3, rotation_column = 9;
/// Columns of ContactDerivatives::forces that are columns of `solution`; -1: a load.
constexpr std::array<int, 8> columns_of_solution{y_column, yaw_column, -1, -1, 4, 5, 8, rotation_column};
constexpr int movements = MovedContact::movements;
}  // namespace

void WheelsetDerivatives::clear(ContactDerivatives& out) const
{
  const bool solves = config_.wheelset.solve_height_and_roll;
  out.forces.setConstant(6, hasCreep() ? known : ContactDerivatives::positions, NAN);
  out.solution.setConstant(solves ? 6 : 0, solves ? (hasCreep() ? 8 : ContactDerivatives::givens) : 0, NAN);
}

/// Reason for which there are none; otherwise empty.
std::string_view WheelsetDerivatives::fault(const WheelsetBalance& balance, const RollingWheelset* rolling) const
{
  const NormalMethod method = config_.contact.method;
  if (method != NormalMethod::automatic && method != NormalMethod::conjugate_gradient)
  {
    return "no derivatives: contact/method is neither auto nor conjugate_gradient";
  }
  if (rolling != nullptr && config_.creep.method == CreepMethod::exact)
  {
    return "no derivatives: creep/method is exact";
  }
  if (balance.wheel(Side::left).support().bends() &&
      config_.rail_bending.lateral_force != RailBendingConfig::LateralForce::contact)
  {
    return "no derivatives: rail_bending/lateral_force is not that of the contact";
  }
  const auto is_edged = [&](Side side)
  { return balance.wheel(side).loaded() && !(balance.wheel(side).isSmooth() && balance.wheel(side).rim().smooth); };
  return is_edged(Side::left) || is_edged(Side::right) ? "no derivatives: the contact is at an edge along the track"
                                                       : "";
}

std::string_view WheelsetDerivatives::find(const WheelsetBalance& balance, RollingWheelset* rolling,
                                           ContactDerivatives& out)
{
  if (const std::string_view reason = fault(balance, rolling); !reason.empty())
  {
    return reason;
  }
  for (const Side side : sides)
  {
    if (balance.wheel(side).loaded())
    {
      contacts_[side].find(config_, side, balance.wheel(side).contact(), balance.islands(side), balance.pose());
    }
  }
  if (rolling != nullptr)
  {
    friction_.find(*rolling, contacts_);
  }
  if (!findForces(balance, rolling, false))
  {
    return "no derivatives: the deflection of a rail or the rotation is at a branch";
  }
  out.forces = (wheels_.left + wheels_.right).leftCols(out.forces.cols());
  if (!config_.wheelset.solve_height_and_roll)
  {
    return "";
  }
  if (!balance.wheel(Side::left).loaded() || !balance.wheel(Side::right).loaded())
  {
    return "no derivatives of height and roll: a wheel carries no load";
  }
  const bool is_found = (rolling == nullptr || findForces(balance, rolling, true)) && findSolution(out);
  if (!is_found)
  {
    out.solution.setConstant(NAN);
    return "no derivatives of height and roll: they are at a branch";
  }
  return "";
}

/// Adds the change of the wrench on a loaded wheel, and the right sides of the equations: forces on the rail that bend
/// it, and moment of friction about the axle.
void WheelsetDerivatives::addWheel(Side side, const RollingWheelset* rolling, bool follows, Wrench& wrench,
                                   Equations& equations) const
{
  const int index = static_cast<int>(side), roll = MovedFriction::inputs + index;
  const auto add = [&](const auto& changed, int column)
  {
    constexpr int width = std::decay_t<decltype(changed)>::ColsAtCompileTime;
    wrench.template middleCols<width>(column) += changed.template topRows<6>();
    equations.template block<3, width>(3 * index, column) +=
        changed.template middleRows<3>(MovedContact::first_on_rail);
  };
  add(contacts_[side].changes(), movements * index);
  add(rolledOutward(side, contacts_[side].values()), roll);
  if (rolling != nullptr)
  {
    const MovedFriction::Changes rubs = friction_.changes(side, follows);
    const MovedFriction::Values rolled = rolledOutward(side, friction_.values(side));
    const Eigen::RowVector3d axle = axleDirection(rolling->motion().yaw, rolling->motion().roll);
    add(rubs, 0);
    add(rolled, roll);
    equations.row(6).leftCols<MovedFriction::inputs>() += axle * rubs.middleRows<3>(moment_x);
    equations(6, roll) += axle * rolled.segment<3>(moment_x);
  }
}

/// Sets the motion over ground by what is known.
void WheelsetDerivatives::addMotion(const WheelsetPose& axle, const RollingWheelset& rolling,
                                    Eigen::Ref<Eigen::Matrix<double, 6, known>> motion)
{
  const Vector3d& turn = rolling.frameTurn();
  const auto by_place = [&](const Vector3d& place) { return turn.cross(place); };
  motion.rightCols<6>().setIdentity();
  motion.block<3, 1>(0, y_column) = rolling.speed() * by_place(Vector3d::UnitY());
  motion.block<3, 1>(0, z_column) = rolling.speed() * by_place(Vector3d::UnitZ());
  motion.block<3, 1>(0, movements) += by_place({0, axle.y, axle.z});
  motion.block<3, 1>(3, movements) += Vector3d(turn.x(), turn.z(), turn.y());
}

/// Finds the change of the wrench on each wheel.
/// @return false at a branch
bool WheelsetDerivatives::findForces(const WheelsetBalance& balance, const RollingWheelset* rolling, bool follows)
{
  Sides<Wrench> wrenches;
  Equations equations = Equations::Zero();
  // Inputs by the unknown forces on the rails and the rotation, and by what is known.
  Eigen::Matrix<double, inputs, 7> by_unknown = Eigen::Matrix<double, inputs, 7>::Zero();
  Eigen::Matrix<double, inputs, known> by_known = Eigen::Matrix<double, inputs, known>::Zero();
  Eigen::Matrix<double, 7, known> right = Eigen::Matrix<double, 7, known>::Zero();
  for (const Side side : sides)
  {
    const int index = static_cast<int>(side), first = movements * index;
    wrenches[side].setZero();
    if (balance.wheel(side).loaded())
    {
      addWheel(side, rolling, follows, wrenches[side], equations);
      const Eigen::Matrix3d& compliance = balance.wheel(side).support().compliance();
      by_unknown.block<movements, 3>(first, 3 * index) = MovedContact::byRail() * compliance;
      by_unknown.block<1, 3>(MovedFriction::inputs + index, 3 * index) = compliance.row(2);
      by_known.block<movements, movements>(first, 0) = contacts_[side].byAxle();
    }
  }
  if (rolling != nullptr)
  {
    addMotion(balance.pose(), *rolling, by_known.middleRows<6>(MovedFriction::first_motion));
  }
  Eigen::Matrix<double, 7, 7> open = Eigen::Matrix<double, 7, 7>::Identity();
  if (rolling != nullptr && isFree() && !equations.row(6).isZero(0))
  {
    by_known.row(MovedFriction::inputs - 1).setZero();
    by_unknown(MovedFriction::inputs - 1, 6) = 1;
    open(6, 6) = 0;
    // The axle turns in the moment of friction.
    const Vector3d moment =
        friction_.values(Side::left).segment<3>(moment_x) + friction_.values(Side::right).segment<3>(moment_x);
    const double yaw = rolling->motion().yaw, roll = rolling->motion().roll;
    right(6, roll_column) =
        moment.dot(Vector3d(std::sin(yaw) * std::sin(roll), -std::cos(yaw) * std::sin(roll), std::cos(roll)));
    right(6, yaw_column) = moment.dot(Vector3d::UnitZ().cross(axleDirection(yaw, roll)));
  }
  else
  {
    equations.row(6).setZero();
  }
  open -= equations * by_unknown;
  right += equations * by_known;
  const auto is_stable = [&](int size) { return open.topLeftCorner(size, size).determinant() > 0; };
  if (!(is_stable(3) && is_stable(6) && is_stable(7)))
  {
    return false;
  }
  const Eigen::Matrix<double, 7, known> change = open.partialPivLu().solve(right);
  for (const Side side : sides)
  {
    wheels_[side] = wrenches[side] * (by_unknown * change + by_known);
  }
  return wheels_.left.allFinite() && wheels_.right.allFinite();
}

/// Height and roll follow from the equations of the balance (implicit function theorem). The sign of their determinant
/// is that of a stable balance of two like wheels, on rails of the same height.
/// @return false at a branch
bool WheelsetDerivatives::findSolution(ContactDerivatives& out) const
{
  Eigen::Matrix<double, 2, known> by_axle;  // vertical forces, or force and moment
  Eigen::Matrix2d by_load;                  // by force_z and torque_x
  by_axle << wheels_.left.row(force_z), wheels_.right.row(force_z);
  by_load << 0.5, 0.5 / config_.wheelset.halfBase(), 0.5, -0.5 / config_.wheelset.halfBase();
  double sign = -1;
  if (config_.wheelset.balance == WheelsetConfig::Balance::moments)
  {
    by_axle << wheels_.left.row(force_z) + wheels_.right.row(force_z),
        wheels_.left.row(moment_x) + wheels_.right.row(moment_x);
    by_load.setIdentity();
    sign = 1;
  }
  const Eigen::Matrix2d unknown = by_axle.middleCols<2>(z_column);
  if (!(sign * unknown.determinant() > 0))
  {
    return false;
  }
  for (int column = 0; column < out.solution.cols(); ++column)
  {
    const int from = columns_of_solution[static_cast<std::size_t>(column)];
    const Eigen::Vector2d change =
        -unknown.partialPivLu().solve(from < 0 ? by_load.col(column - 2).eval() : by_axle.col(from).eval());
    out.solution.col(column).head<2>() = change;
    for (const Side side : sides)
    {
      const Eigen::Matrix<double, 6, 1> forces =
          wheels_[side].middleCols<2>(z_column) * change + (from < 0 ? 0 : 1) * wheels_[side].col(std::max(from, 0));
      out.solution.col(column).segment<2>(2 + 2 * static_cast<int>(side)) << forces[force_z],
          -sideSign(side) * forces[force_y];
    }
  }
  return out.solution.allFinite();
}
}  // namespace wheel_rail_contact::core
