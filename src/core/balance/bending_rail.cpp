// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/bending_rail.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double coupling_tolerance = 1e-6;  ///< of deflection due and deflection used, where they are mixed, relative
constexpr double roll_arm = 0.1;             ///< makes a roll comparable with a displacement [m]
constexpr double sharpest_radius = 0.01;     ///< of rail heads and wheel flanges [m]
constexpr double slip_share = 0.01;   ///< of contact/tolerance, left open in the gap by the rail's way along the plane
constexpr double early_move = 0.3;    ///< of the way allowed, at which the next answer sets out with the rail moved
constexpr double same_load = 0.01;    ///< change of a wheel's load that need not move its rail beforehand [-]
constexpr double effect_share = 0.3;  ///< of contact/tolerance, below which the rail's bending is left out of the gap
constexpr double effect_reserve = 0.5;          ///< of that, from which on a bent rail is held straight again
constexpr double flange_step = 2e-4;            ///< by which a rail is set out from under a flange [m]
constexpr double greatest_lateral_share = 2.0;  ///< lateral force that may have to hold it there, of the wheel load [-]
constexpr double farthest_displacement = 0.05;  ///< that a head is ever set from its place [m], [rad]
constexpr double unsettled = 2.0;               ///< any value above 1
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
  straight_ = mode_ == Mode::solved;
  straighten_ = false;
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
    support.compliant = !straight_;
    support.compliance = compliance_;
  }
  wheel_.setRail(undeflected_.deflected(toDeflection(placed_ + offset_)), support);
}

/// Own deflection under the wheel load alone [m], [rad].
Eigen::Vector3d BendingRail::underLoad(double load) const
{
  return compliance_ * Eigen::Vector3d(0, -std::max(load, 0.0), 0);
}

/// Takes the rail back to where the wheel does not bend it. Returns if it was there, as follow() does.
double BendingRail::setStraight()
{
  if (placed_.isZero(0))
  {
    return 0;
  }
  set(Eigen::Vector3d::Zero());
  return unsettled;
}

void BendingRail::moveTo(const Eigen::Vector3d& own)
{
  const Eigen::Vector3d way = own - placed_;
  set(placed_ + step_.share(wheel_.railSlip(), way[0]) * way);
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
  straight_ = mode_ == Mode::solved && (cold || straight_ || straighten_);
  if (cold || straighten_)
  {
    set(straight_ ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : underLoad(load));
  }
  else if (mode_ == Mode::solved && !straight_ && loaded_)
  {
    const double ratio = std::max(load, 0.0) / result_.vertical_force;
    if (elsewhere || std::abs(ratio - 1) > same_load || slipOver() > early_move)
    {
      set(ratio * own_);
    }
  }
  else if (elsewhere)
  {
    set(placed_);
  }
  straighten_ = false;
}

RigidTouch BendingRail::letFlangeDown(const RigidTouch& touch, const WheelsetPose& pose, double load)
{
  const auto on_flange = [](const RigidTouch& seen) { return seen.found && seen.contact.slope > flange_slope; };
  if (mode_ != Mode::solved || !on_flange(touch))
  {
    return touch;
  }
  straight_ = false;
  const Eigen::Vector3d start = underLoad(load);
  const double most = greatest_lateral_share * load * compliance_(0, 0);
  RigidTouch moved = touch;
  for (double way = flange_step; on_flange(moved) && way < most; way += flange_step)
  {
    set(start + Eigen::Vector3d(way, 0, 0));
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

/// The lateral force that is to bend the rail.
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

/// Takes the forces of the last solution over to the results, with the lateral force that is to bend the rail.
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

/// The rail's way along the contact planes since it was set, over the one allowed: the gap takes it to first order, and
/// slip²/(2R) is left. What the wheel slides as it comes down by that way is not in the gap at all.
double BendingRail::slipOver() const
{
  const double left_open = slip_share * config_.contact.tolerance * wheel_.elasticPenetration();
  return std::max(wheel_.railSlip() / std::sqrt(2 * sharpest_radius * left_open),
                  wheel_.deflectionError() / config_.contact.tolerance);
}

double BendingRail::effectLimit() const
{
  return effect_share * config_.contact.tolerance;
}

double BendingRail::followContact(bool loaded)
{
  if (!loaded)
  {
    return setStraight();
  }
  if (straight_)
  {
    if (wheel_.effectOf(wheel_.support(), effectLimit()) < effectLimit())
    {
      return 0;
    }
    straight_ = false;
    moveTo(wheel_.support());
    return unsettled;
  }
  const double open = slipOver();
  if (open > 1)
  {
    moveTo(wheel_.support());
  }
  return open;
}

/// Brings the deflection nearer to the one due under a force. Returns their difference, over the one allowed.
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
    set(next.norm() < farthest_displacement ? next : due);  // the mixing may find no direction, and then no number
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
  const bool solved = mode_ == Mode::solved && loaded;
  own_ = solved ? wheel_.support() : placed_;
  result_.deflection = toDeflection(own_ + offset_);
  result_.coupled = mode_ == Mode::mixed || (solved && !straight_);
  straighten_ = solved && !straight_ && wheel_.effectOf(own_, effectLimit()) < effect_reserve * effectLimit();
}
}  // namespace wheel_rail_contact::core
