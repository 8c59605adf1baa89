// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheel_equilibrium.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/balance/tuning.h"
#include "core/balance/wheel_loads.h"
#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double least_move = 1e-9;  ///< of a rail without contact that is neglected [m]
}  // namespace

/// Length of a movement of the rail head; a roll counts by its effect on the crown [m].
static double lengthOf(const Eigen::Vector3d& move)
{
  return std::hypot(move[0], move[1], ComplianceTable::reference_depth * move[2]);
}

/// Forces of a trial and what it gave.
struct WheelEquilibrium::Trial
{
  Eigen::Vector3d forces, open;
  double height = 0, merit = infinity, noise = 0;
};

WheelEquilibrium::WheelEquilibrium(const ContactModelConfig& config, Side side, NormalSolver& solver, double accuracy)
    : config_(config),
      accuracy_(accuracy),
      rail_(config, side),
      contact_(config, side, rail_.atRest(), solver, rail_.longest()),
      own_force_(config.rail_bending.lateral_force == RailBendingConfig::LateralForce::contact)
{
  setRail(0, RailDeflection());
}

void WheelEquilibrium::reset()
{
  forces_.setZero();
  response_.rates.setZero();
  contact_.forget();
}

void WheelEquilibrium::moveTo(double x)
{
  if (rail_.moveTo(x))
  {
    placed_.reset();
  }
}

void WheelEquilibrium::setRail(double lateral, const RailDeflection& displaced)
{
  const RailBendingConfig& bending = config_.rail_bending;
  const bool is_constant = bending.lateral_force == RailBendingConfig::LateralForce::constant;
  given_lateral_ = is_constant ? bending.lateral_force_value : lateral;
  rail_.displace(displaced);
}

/// Places the rail as the forces deflect it.
void WheelEquilibrium::place(const Eigen::Vector3d& forces)
{
  const Eigen::Vector3d coordinates = rail_.under(forces);
  if (!placed_ || coordinates != *placed_)
  {
    contact_.setRail(rail_.placedAt(coordinates, rim_), !placed_);
    placed_ = coordinates;
  }
}

/// Forces on the rail that belong to the last solution.
Eigen::Vector3d WheelEquilibrium::target() const
{
  Eigen::Vector3d forces = contact_.solved().forces().tail<3>();
  if (!own_force_)
  {
    // The given force acts at the height of the contact.
    forces[2] += (given_lateral_ - forces[0]) * contact_.solved().heightOverReference();
    forces[0] = given_lateral_;
  }
  return forces;
}

MotionVector WheelEquilibrium::railMove(const Eigen::Vector3d& move)
{
  MotionVector all = MotionVector::Zero();
  all.tail<3>() = move;
  return all;
}

void WheelEquilibrium::respond()
{
  if (responded())
  {
    return;
  }
  response_ = {};
  response_.is_exact = true;
  approximateRates();
  if (!rail_.bends() && config_.wheelset.balance != WheelsetConfig::Balance::moments)
  {
    const MotionVector vertical = contact_.verticalStiffness();
    if (vertical.allFinite() && vertical[wheel_up] > 0)
    {
      response_.rates.row(height_rate) << -vertical[wheel_roll], vertical[rail_lateral], -1;
      response_.rates.row(height_rate) /= vertical[wheel_up];
      response_.rates(moment_rate, by_load) = vertical[wheel_roll] / vertical[wheel_up];
    }
    return;
  }
  const MotionMatrix stiffness = contact_.stiffness();
  if (stiffness.allFinite() && stiffness(wheel_up, wheel_up) > 0)
  {
    setRates(stiffness);
  }
}

/// Sets the rates of height and moment for a constant distribution of the pressure, constant forces on the rail, and an
/// overlap as of paraboloids.
void WheelEquilibrium::approximateRates()
{
  const double load = contact_.solved().forces()[wheel_up];
  response_.rates.row(height_rate) << contact_.solved().heightPer(wheel_roll),
      -contact_.solved().heightPer(rail_lateral), -WheelLoads::overlap_per_load * contact_.overlap() / load;
  response_.rates.row(moment_rate) << 0, 0, moment() / load;
}

/// Sets the rates from the stiffness of the contact and the compliance of the rail. A lateral movement of the wheel
/// opens the gap as that of the rail in the other direction does.
void WheelEquilibrium::setRates(const MotionMatrix& stiffness)
{
  // Columns: the three coordinates of the rail, then the inputs. Rows: moment and forces on the rail.
  Eigen::Matrix<double, motions, 6> force;
  force << -stiffness.rightCols<3>(), -stiffness.col(wheel_roll), stiffness.col(rail_lateral), MotionVector::Zero();
  Eigen::Matrix<double, 1, 6> height = Eigen::Matrix<double, 1, 6>::Zero();
  if (isUnderLoad())
  {
    height = force.row(wheel_up) / stiffness(wheel_up, wheel_up);
    height[5] = -1 / stiffness(wheel_up, wheel_up);  // the contact carries more by as much as the load grows
    force -= stiffness.col(wheel_up) * height;
  }
  Eigen::Matrix<double, 4, 6> of_rail = force.bottomRows<4>();
  if (!own_force_)
  {
    of_rail.row(3) -= contact_.solved().heightOverReference() * of_rail.row(1);
    of_rail.row(1).setZero();
  }
  response_.per_force = of_rail.bottomLeftCorner<3, 3>() * rail_.compliance();
  response_.height_per_force = rail_.compliance() * height.head<3>().transpose();
  for (int input = 0; input < inputs; ++input)
  {
    const Eigen::Vector3d change = step(of_rail.col(3 + input).tail<3>());
    response_.rates(height_rate, input) = height[3 + input] + response_.height_per_force.dot(change);
    response_.rates(moment_rate, input) =
        of_rail(0, 3 + input) + of_rail.row(0).head<3>().dot(rail_.compliance() * change);
    response_.rates.col(input).tail<3>() = change;
  }
}

/// Step of the forces that closes the difference `open` between the forces of the contact and those on the rail.
Eigen::Vector3d WheelEquilibrium::step(const Eigen::Vector3d& open) const
{
  const Eigen::Vector3d step = (Eigen::Matrix3d::Identity() - response_.per_force).partialPivLu().solve(open);
  return step.allFinite() ? step : open;
}

/// Position of first touch without load.
WheelStatus WheelEquilibrium::touchAtRest(const WheelsetPose& pose)
{
  forces_ = restForces();
  place(forces_);
  loaded_ = false;
  const WheelStatus status = contact_.touch(pose);
  height_ = contact_.height();
  const InitialContact& touch = contact_.grids().touch();
  const double z = contact_.rail().at(touch.rail_u).z;
  touch_slope_ = -(touch.y - pose.y + (z - height_) * touch.slope);
  return status;
}

/// Forces on the rail without a contact.
Eigen::Vector3d WheelEquilibrium::restForces() const
{
  return own_force_ ? Eigen::Vector3d::Zero() : Eigen::Vector3d(given_lateral_, 0, 0);
}

/// Solves the contact on the rail as these forces deflect it; without a load, at the height of the pose.
WheelStatus WheelEquilibrium::solveOn(const Eigen::Vector3d& forces, const WheelsetPose& pose, double load,
                                      OverlapGrids::Choice choice, Trial& trial)
{
  place(forces);
  const WheelStatus status = load > 0 ? contact_.solveLoad(pose, load, choice) : contact_.solveAt(pose, choice);
  loaded_ = status == WheelStatus::solved;
  if (loaded_ && !response_.is_exact)
  {
    approximateRates();
  }
  trial.forces = forces;
  trial.height = height_ = contact_.height();
  trial.open = (loaded_ ? target() : restForces()) - forces;
  if (own_force_ && rail_.bends())
  {
    trial.merit = contact_.solved().energy() + 0.5 * forces.dot(rail_.compliance() * forces) + load * contact_.height();
    const double nonlinear = std::max(tuning::last_step, std::abs(contact_.remaining()) / contact_.overlap());
    trial.noise = loaded_ ? nonlinear * nonlinear * contact_.solved().energy() : 0;
  }
  else
  {
    trial.merit = lengthOf(rail_.compliance() * trial.open);
  }
  return status;
}

/// True if the last solution is in equilibrium. Otherwise sets the step of the forces that leads to it.
bool WheelEquilibrium::isEquilibrium(const Trial& trial, Eigen::Vector3d& step)
{
  step = trial.open;
  if (!loaded_)
  {
    return lengthOf(rail_.compliance() * trial.open) <= least_move;
  }
  const bool deep = !isUnderLoad() || contact_.isDeepEnough();
  if (!rail_.bends())
  {
    return deep;
  }
  const auto even = [&](const Eigen::Vector3d& change)
  { return contact_.solved().opening(railMove(rail_.compliance() * change)) <= accuracy_ * contact_.overlap(); };
  if (deep && even(trial.open))
  {
    return true;
  }
  respond();
  step = this->step(trial.open);
  if (own_force_ && !(step.dot(rail_.compliance() * trial.open) > 0))  // not a direction of falling energy
  {
    step = trial.open;
  }
  return deep && even(step) && isNearlyClosed(trial);
}

WheelStatus WheelEquilibrium::search(const WheelsetPose& pose, double load, const KeptResult& kept)
{
  WheelsetPose at = pose;
  Eigen::Vector3d forces = forces_, step = Eigen::Vector3d::Zero(), rise_per_force = Eigen::Vector3d::Zero();
  forces[1] = load > 0 ? -load : forces[1];
  forces[0] = own_force_ ? forces[0] : given_lateral_;
  Trial best, trial;
  double share = 1;
  for (int i = 0; i < tuning::most_solutions; ++i)
  {
    const auto choice = kept.grids || i > 0 ? OverlapGrids::Choice::kept : OverlapGrids::Choice::own;
    response_.is_exact = response_.is_exact && kept.response && i < tuning::early_solutions;
    const WheelStatus status = solveOn(forces, at, load, choice, trial);
    const bool usable = loaded_ || status == WheelStatus::no_contact;
    const bool first = !std::isfinite(best.merit);
    if (!usable && (first || !rail_.bends()))
    {
      return status;
    }
    const bool jump = !first && usable && jumps(best, trial);
    const double shorter = first ? 1 : usable ? shortened(best, trial, jump) : 0.5;
    const bool is_shortest = usable && shorter < 1 && share <= tuning::shortest_share;
    if ((jump || is_shortest) && isNear(step) && isNearlyClosed(trial))
    {
      return accept(trial, Eigen::Vector3d::Zero(), status);  // the forces jump here as the grids change
    }
    if (!usable || (shorter < 1 && share > tuning::shortest_share))
    {
      share *= shorter;
    }
    else
    {
      best = trial;
      share = 1;
      if (isEquilibrium(trial, step))
      {
        return accept(trial, step, status);
      }
      const double far = lengthOf(rail_.compliance() * step);
      step *= far > tuning::longest_step ? tuning::longest_step / far : 1;
      rise_per_force = load > 0 && response_.is_exact ? response_.height_per_force : Eigen::Vector3d::Zero();
    }
    forces = best.forces + share * step;
    at.z = load > 0 ? best.height + rise_per_force.dot(share * step) : at.z;
  }
  return WheelStatus::unbalanced;
}

/// True if the forces of the contact and those on the rail are nearly equal. The stiffness is that of an exact
/// solution; with other methods, a step may be small because it is wrong.
bool WheelEquilibrium::isNearlyClosed(const Trial& trial)
{
  return trial.open.head<2>().norm() <= tuning::last_step * trial.forces.head<2>().norm();
}

/// True if the last solution carries load, and a step would change the contact little.
bool WheelEquilibrium::isNear(const Eigen::Vector3d& step) const
{
  return loaded_ && contact_.isDeepEnough() &&
         contact_.solved().opening(railMove(rail_.compliance() * step)) <=
             tuning::jump_share * accuracy_ * contact_.overlap();
}

/// Takes the last solution, with a last step of the forces, as the result.
WheelStatus WheelEquilibrium::accept(const Trial& trial, const Eigen::Vector3d& step, WheelStatus status)
{
  forces_ =
      rail_.bends() ? Eigen::Vector3d(trial.forces + step) : Eigen::Vector3d(contact_.solved().forces().tail<3>());
  if (isUnderLoad() && loaded_ && rail_.bends())
  {
    const Eigen::Vector3d move = rail_.compliance() * step;
    height_ += contact_.solved().heightPer(rail_lateral) * move[0] + contact_.solved().heightPer(rail_up) * move[1] +
               contact_.solved().heightPer(rail_roll) * move[2];
  }
  return status;
}

/// True if the energy changes by the cells between two trials: it is convex, but rises by more than its last slope.
bool WheelEquilibrium::jumps(const Trial& best, const Trial& trial) const
{
  const double last = -trial.open.dot(rail_.compliance() * (trial.forces - best.forces));
  return own_force_ && trial.merit - best.merit > std::max({trial.noise, best.noise, last});
}

/// Share of the last step to be tried next; 1 if its end is accepted: if the energy has fallen, or if it is the same
/// within its noise and its slope is smaller. The energy is convex: one that rises by more than its last slope is wrong
/// by the cells. The share is where the tangents of the energy at both ends meet (at the kink, if another place comes
/// into contact), or where the slope vanishes.
double WheelEquilibrium::shortened(const Trial& best, const Trial& trial, bool jump) const
{
  const double rise = trial.merit - best.merit, noise = std::max(trial.noise, best.noise);
  const Eigen::Vector3d move = rail_.compliance() * (trial.forces - best.forces);
  const double before = -best.open.dot(move), after = -trial.open.dot(move);
  if (!own_force_)
  {
    return rise <= 0 ? 1 : 0.5;
  }
  const bool is_known = rise > noise && !jump;
  if (rise < -noise || (!is_known && std::abs(after) <= (1 - tuning::shortest_share) * std::abs(before)))
  {
    return 1;
  }
  const double share = rise > noise ? (rise - after) / (before - after) : before / (before - after);
  return after > 0 && before < 0 ? std::clamp(share, tuning::shortest_share, 1 - tuning::shortest_share) : 0.5;
}

double WheelEquilibrium::rate(Output output, Input input) const
{
  if (!loaded_)
  {
    return output != height_rate ? 0
           : input == by_roll    ? touch_slope_
           : input == by_lateral ? contact_.grids().touch().slope
                                 : 0;
  }
  return response_.rates(output, input);
}

void WheelEquilibrium::predict(double lateral, double roll, double load)
{
  if (loaded_ && rail_.bends())
  {
    forces_ += response_.rates.bottomRows<3>() * Eigen::Vector3d(roll, lateral, load);
  }
}

double WheelEquilibrium::opening(double roll, double load) const
{
  if (!loaded_)
  {
    return 0;
  }
  MotionVector move = MotionVector::Zero();
  move[wheel_roll] = roll;
  if (rail_.bends() && response_.is_exact)
  {
    move.tail<3>() = rail_.compliance() * (response_.rates.bottomRows<3>() * Eigen::Vector3d(roll, 0, load));
  }
  return contact_.solved().opening(move) / contact_.overlap();
}

RailResult WheelEquilibrium::rail() const
{
  RailResult result;
  result.deflection = toDeflection(rail_.under(forces_));
  result.given = rail_.displacement();
  result.slope = rail_.course().slope;
  const Eigen::Vector3d forces = forces_ + rail_.borne();
  result.lateral_force = forces[0];
  result.vertical_force = -forces[1];
  result.moment = forces[2];
  return result;
}
}  // namespace wheel_rail_contact::core
