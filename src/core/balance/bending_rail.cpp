// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/bending_rail.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double coupling_tolerance = 1e-6;  ///< relative difference of the mixed deflections, see mix() [-]
constexpr double roll_arm = 0.1;             ///< converts a roll to a comparable displacement [m]
constexpr double sharpest_radius = 0.01;     ///< smallest radius of rail heads and wheel flanges [m]
constexpr double slip_share = 0.01;          ///< gap error in slipRatio(), over contact/tolerance [-]
constexpr double early_move = 0.3;           ///< share of the allowed displacement, see begin() [-]
constexpr double same_load = 0.01;    ///< change of a wheel load up to which the rail keeps its start position [-]
constexpr double flange_step = 2e-4;  ///< step of clearFlange() [m]
constexpr double greatest_lateral_share = 2.0;  ///< lateral over vertical force, limit in clearFlange() [-]
constexpr double farthest_displacement = 0.05;  ///< limit of the displacement of a head [m], [rad]
constexpr double unconverged = 2.0;             ///< any value above 1
}  // namespace

BendingRail::BendingRail(const ContactModelConfig& config, bool solved_with_contact, WheelContact& wheel)
    : config_(config),
      wheel_(wheel),
      undeflected_(config.rail_profile, config.track),
      compliance_(supportCompliance(config.rail_bending.table, config.track.rail_inclination))
{
  if (config.rail_bending.model == RailBendingConfig::Model::compliance)
  {
    const bool own_force = config.rail_bending.lateral_force == RailBendingConfig::LateralForce::contact;
    mode_ = own_force && solved_with_contact ? Mode::solved : Mode::mixed;
  }
  reset();
}

void BendingRail::reset()
{
  const bool prescribed = config_.rail_bending.model == RailBendingConfig::Model::prescribed;
  result_ = RailResult();
  result_.deflection = prescribed ? config_.rail_bending.prescribed : RailDeflection();
  own_ = toCoordinates(result_.deflection);
  offset_.setZero();
  loaded_ = false;
  set(own_);
}

void BendingRail::set(const Eigen::Vector3d& own)
{
  const double norm = own.norm();
  placed_ = norm > farthest_displacement ? Eigen::Vector3d(farthest_displacement / norm * own) : own;
  Support support;
  support.placed = placed_;
  if (mode_ == Mode::solved)
  {
    support.compliant = true;
    support.compliance = compliance_;
  }
  wheel_.setRail(undeflected_.deflected(toDeflection(placed_ + offset_)), support);
}

/// Own deflection under the wheel load alone [m], [rad].
Eigen::Vector3d BendingRail::underLoad(double load) const
{
  return compliance_ * Eigen::Vector3d(0, -std::max(load, 0.0), 0);
}

/// Removes the rail's own deflection. Returns 0 if there was none, otherwise a value above 1 (see follow()).
double BendingRail::setStraight()
{
  if (placed_.isZero(0))
  {
    return 0;
  }
  set(Eigen::Vector3d::Zero());
  return unconverged;
}

void BendingRail::moveTo(const Eigen::Vector3d& own)
{
  const Eigen::Vector3d move = own - placed_;
  set(placed_ + step_.share(wheel_.railSlip(), move[0]) * move);
}

void BendingRail::begin(bool cold, double load, const RailDeflection& offset)
{
  mixing_.reset();
  step_.reset();
  remaining_deflection_ = 0;
  if (mode_ == Mode::held)
  {
    return;
  }
  const bool elsewhere = toCoordinates(offset) != offset_;
  offset_ = toCoordinates(offset);
  if (cold)
  {
    set(underLoad(load));
  }
  else if (mode_ == Mode::solved && loaded_)
  {
    const double ratio = std::max(load, 0.0) / result_.vertical_force;
    if (elsewhere || std::abs(ratio - 1) > same_load || slipRatio() > early_move)
    {
      set(ratio * own_);
    }
  }
  else if (elsewhere)
  {
    set(placed_);
  }
}

RigidTouch BendingRail::clearFlange(const RigidTouch& touch, const WheelsetPose& pose, double load)
{
  const auto on_flange = [](const RigidTouch& seen) { return seen.found && seen.contact.slope > flange_slope; };
  if (mode_ != Mode::solved || !on_flange(touch))
  {
    return touch;
  }
  const Eigen::Vector3d start = underLoad(load);
  const double most = greatest_lateral_share * load * compliance_(0, 0);
  RigidTouch moved = touch;
  for (double outward = flange_step; on_flange(moved) && outward < most; outward += flange_step)
  {
    set(start + Eigen::Vector3d(outward, 0, 0));
    moved = wheel_.touch(pose);
  }
  if (moved.found && !on_flange(moved))
  {
    return moved;
  }
  set(start);
  return wheel_.touch(pose);
}

RigidTouch BendingRail::touchAtRest(const WheelsetPose& pose, double given_lateral, const RailDeflection& offset)
{
  const Eigen::Vector3d rest = compliance_ * Eigen::Vector3d(lateralForce(0, given_lateral), 0, 0);
  wheel_.setRail(undeflected_.deflected(toDeflection(rest + toCoordinates(offset))));
  const RigidTouch touch = wheel_.touch(pose);
  set(placed_);
  return touch;
}

/// Lateral force that bends the rail, according to rail_bending/lateral_force [N].
double BendingRail::lateralForce(double of_contact, double given) const
{
  using LateralForce = RailBendingConfig::LateralForce;
  const RailBendingConfig& bending = config_.rail_bending;
  return bending.lateral_force == LateralForce::topic      ? given
         : bending.lateral_force == LateralForce::constant ? bending.lateral_force_value
                                                           : of_contact;
}

double BendingRail::deflectionPerLoad(const RigidTouch& touch) const
{
  const bool own = config_.rail_bending.lateral_force == RailBendingConfig::LateralForce::contact;
  const Eigen::Vector3d along(own ? touch.contact.slope : 0, -1, 0);
  return along.dot(compliance_ * along);
}

double BendingRail::deflectionPerLoad() const
{
  const WheelForces& forces = wheel_.forces();
  const Eigen::Vector3d along(forces.outward, -forces.vertical, forces.moment);
  Eigen::Vector3d more = along;
  more[0] = config_.rail_bending.lateral_force == RailBendingConfig::LateralForce::contact ? forces.outward : 0;
  return along.dot(compliance_ * more) / (forces.vertical * forces.vertical);
}

/// Copies the forces of the last solution to the result. The lateral force is the one that bends the rail.
RailForce BendingRail::takeForce(bool loaded, double given_lateral)
{
  WheelForces forces = loaded ? wheel_.forces() : WheelForces();
  const double from_contact = forces.outward;
  forces.outward = lateralForce(from_contact, given_lateral);
  forces.moment += (forces.outward - from_contact) * wheel_.heightOverReference();
  result_.lateral_force = forces.outward;
  result_.vertical_force = forces.vertical;
  result_.moment = forces.moment;
  return {forces.outward, forces.vertical, forces.moment};
}

/// Displacement of the rail along the contact planes since it was set, over the allowed one. The gap contains it to
/// first order; the remaining error is slip²/(2R). The gap does not contain the sliding of the wheel as it moves down
/// with the rail; it counts by deflectionError() over the tolerance.
double BendingRail::slipRatio() const
{
  const double left_open = slip_share * config_.contact.tolerance * wheel_.elasticPenetration();
  return std::max(wheel_.railSlip() / std::sqrt(2 * sharpest_radius * left_open),
                  wheel_.deflectionError() / config_.contact.tolerance);
}

double BendingRail::followContact(bool loaded)
{
  if (!loaded)
  {
    return setStraight();
  }
  const double open = slipRatio();
  if (open > 1)
  {
    moveTo(wheel_.support());
  }
  return open;
}

/// Moves the deflection towards the one that a force causes. Returns their relative difference over the allowed one.
double BendingRail::mix(const RailForce& force)
{
  const Eigen::Vector3d due =
      toCoordinates(deflectionInTrack(config_.rail_bending.table, force, config_.track.rail_inclination));
  const Eigen::Vector3d along(wheel_.forces().outward, -force.vertical, wheel_.forces().moment);
  remaining_deflection_ = force.vertical > 0 ? along.dot(due - placed_) / force.vertical : 0;
  if (due.isZero(0))
  {
    return setStraight();
  }
  const Eigen::Vector3d scale(1, 1, roll_arm);
  const Eigen::Vector3d x = placed_.cwiseProduct(scale);
  const Eigen::Vector3d image = due.cwiseProduct(scale);
  const double difference = (image - x).norm() / image.norm();
  if (difference > coupling_tolerance)
  {
    const Eigen::Vector3d next = mixing_.next(x, image).cwiseQuotient(scale);
    set(next.norm() < farthest_displacement ? next : due);  // the mixing may fail with values that are not numbers
  }
  return difference / coupling_tolerance;
}

double BendingRail::follow(bool loaded, double given_lateral)
{
  const RailForce force = takeForce(loaded, given_lateral);
  if (mode_ == Mode::held)
  {
    return 0;
  }
  return mode_ == Mode::solved ? followContact(loaded) : mix(force);
}

void BendingRail::finish(bool loaded)
{
  loaded_ = loaded;
  own_ = mode_ == Mode::solved && loaded ? wheel_.support() : placed_;
  result_.deflection = toDeflection(own_ + offset_);
}
}  // namespace wheel_rail_contact::core
