// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact_friction.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/track/rail_along.h"
#include "core/track/root_bracket.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
namespace
{
using Eigen::Vector3d;

constexpr double least_speed = 0.01;        ///< below it there are no creep forces [m/s]
constexpr double narrow_range = 1e-4;       ///< of the free rotation about the last one, at first [-]
constexpr double largest_step = 1;          ///< of an extrapolation, over the friction [-]
constexpr double half_station = 1e-3;       ///< for the direction of a rail on a line [m]
constexpr double rotation_accuracy = 1e-8;  ///< of the free rotation, which is that of the longitudinal creepage [-]

/// Direction of the tangent plane across the track, and its normal.
Vector3d across(double angle)
{
  return {0, std::cos(angle), std::sin(angle)};
}

Vector3d normal(double angle)
{
  return {0, -std::sin(angle), std::cos(angle)};
}

/// Friction of a contact on the wheelset, track axes.
Wrench onWheelset(const ContactPlace& place, const CreepForce& friction)
{
  const Vector3d force = Vector3d(friction.x, 0, 0) + friction.y * across(place.angle);
  return {force, place.position.cross(force) + friction.moment * normal(place.angle)};
}

/// Movement of a rail at a contact, y left and z up, for a movement of its head.
Eigen::Vector2d movementAt(const PatchResult& patch, const PlanePoint& head, const RailVelocity& of_head)
{
  const double sign = sideSign(patch.side);
  return {sign * (of_head.lateral + of_head.roll * (patch.pose.z - head.z)),
          of_head.vertical - of_head.roll * (sign * patch.pose.y - head.y)};
}

/// Movement of each rail head per distance along the track.
Sides<RailVelocity> directionsAt(const TrackLine* line, double distance, const Sides<PlanePoint>& heads)
{
  if (line == nullptr)
  {
    return {};
  }
  const double begin = std::max(line->begin(), distance - half_station),
               end = std::min(line->end(), distance + half_station);
  const Sides<RailDeflection> from = displacementsAt(line->at(begin), heads),
                              to = displacementsAt(line->at(end), heads);
  return Sides<RailVelocity>(
      [&](Side side)
      {
        return RailVelocity{(to[side].lateral - from[side].lateral) / (end - begin),
                            (to[side].vertical - from[side].vertical) / (end - begin),
                            (to[side].roll - from[side].roll) / (end - begin)};
      });
}
}  // namespace

ContactFriction::ContactFriction(const ContactModelConfig& config)
    : config_(config), solver_(makeCreepSolver(config.creep.method)), free_rotation_(1 / config.wheelset.meanRadius())
{
  for (const Side side : sides)
  {
    elasticity_[side] =
        isSet() ? shearElasticity(config.wheel_material[side], config.rail_material[side]) : ShearElasticity();
  }
}

void ContactFriction::reset()
{
  assumed_.setZero();
  free_rotation_ = 1 / config_.wheelset.meanRadius();
}

bool ContactFriction::acts(const WheelsetState& state) const
{
  return isSet() && std::abs(state.motion.speed) >= least_speed;
}

WheelsetState ContactFriction::withFriction(WheelsetState state) const
{
  const auto left = ofSide(Side::left), right = ofSide(Side::right);
  state.force_z += left[0] + right[0];
  state.torque_x += config_.wheelset.balance == WheelsetConfig::Balance::moments
                        ? left[1] + right[1]
                        : config_.wheelset.halfBase() * (left[0] - right[0]);
  return state;
}

std::string_view ContactFriction::fill(const WheelsetState& state, const Sides<PlanePoint>& heads,
                                       WheelsetResult& result)
{
  setContacts(state, heads, result);
  const double level = std::cos(result.roll);
  const Vector3d axle(-std::sin(state.yaw) * level, std::cos(state.yaw) * level, std::sin(result.roll));
  if (config_.creep.rotation == CreepConfig::Rotation::given)
  {
    momentAbout(axle, state.motion.rotation);
  }
  else if (!rollFreely(axle))
  {
    reset();
    return "no rotation of the wheelset was found at which friction has no moment about the axle";
  }
  Friction found = Friction::Zero();
  for (std::size_t k = 0; k < count_; ++k)
  {
    const CreepStatus status = contacts_[k].solution.status;
    if (!isUsable(status))
    {
      reset();
      return toString(status);
    }
    PatchResult& patch = result.patches[k];
    const CreepSolution& solution = contacts_[k].solution;
    PatchCreep& creep = patch.creep;
    creep.creepage = contacts_[k].problem.creepage;
    creep.force = solution.force;
    creep.adhesion_share = solution.adhesion_share;
    creep.power = solution.power;
    creep.error_estimate = solution.error_estimate;
    if (config_.creep.field)
    {
      creep.traction_x = solution.traction_x;
      creep.traction_y = solution.traction_y;
    }
    addForces(patch, contacts_[k], heads[patch.side], result, found);
  }
  result.speed = motion_.speed;
  result.rotation = motion_.rotation;
  change_ = changeTo(found, result.wheel);
  if (change_ < best_change_)
  {
    best_ = assumed_;
    best_change_ = change_;
  }
  assumed_ = extrapolated(found);
  return {};
}

bool ContactFriction::returnToBest(double limit)
{
  if (best_change_ > limit)
  {
    return false;
  }
  assumed_ = best_;
  best_change_ = infinity;
  return true;
}

/// Largest difference of the found friction from the assumed one over the normal force of its wheel [-]. That of a
/// wheel without load counts over the other one.
double ContactFriction::changeTo(const Friction& found, const Sides<WheelForces>& wheels) const
{
  const auto normalForce = [&](Side side)
  {
    const WheelForces& wheel = wheels[side];
    return std::hypot(wheel.vertical - wheel.friction_vertical, wheel.lateral - wheel.friction_lateral);
  };
  const Sides<double> forces(normalForce);
  const Friction open = found - assumed_;
  double largest = 0;
  for (const Side side : sides)
  {
    const auto of = open.segment<of_side>(of_side * static_cast<int>(side));
    const double force = forces[side] > 0 ? forces[side] : std::max(forces.left, forces.right);
    const double changed = std::hypot(of[0], of[1] / config_.wheelset.halfBase(), of.segment<2>(2).norm());
    largest = changed > 0 ? std::max(largest, force > 0 ? changed / force : infinity) : largest;
  }
  return largest;
}

/// Combination of the last passes for which the difference of found and assumed friction would be least.
ContactFriction::Friction ContactFriction::extrapolated(const Friction& found)
{
  const int last = passes_++, count = std::min(last, depth);
  found_[place(last)] = found;
  open_[place(last)] = found - assumed_;
  Eigen::Matrix<double, 2 * of_side, Eigen::Dynamic, 0, 2 * of_side, depth> turns(2 * of_side, count);
  Eigen::Matrix<double, 2 * of_side, Eigen::Dynamic, 0, 2 * of_side, depth> steps(2 * of_side, count);
  for (int k = 0; k < count; ++k)
  {
    turns.col(k) = open_[place(last - k)] - open_[place(last - k - 1)];
    steps.col(k) = found_[place(last - k)] - found_[place(last - k - 1)];
  }
  if (count == 0)
  {
    return found;
  }
  const Friction next = found - steps * turns.colPivHouseholderQr().solve(open_[place(last)]);
  return next.allFinite() && (next - found).norm() < largest_step * found.norm() ? next : found;
}

void ContactFriction::setContacts(const WheelsetState& state, const Sides<PlanePoint>& heads, WheelsetResult& result)
{
  const Sides<RailVelocity> directions = directionsAt(config_.track.line.get(), state.distance, heads);
  for (const Side side : sides)
  {
    result.rail[side].lateral_slope = directions[side].lateral;
    result.rail[side].vertical_slope = directions[side].vertical;
  }
  count_ = result.patches.size();
  contacts_.resize(std::max(contacts_.size(), count_));
  motion_ = state.motion;
  motion_.yaw = state.yaw;
  motion_.roll = result.roll;
  Sides<std::size_t> strongest(count_);
  for (std::size_t k = 0; k < count_; ++k)
  {
    const PatchResult& patch = result.patches[k];
    Contact& contact = contacts_[k];
    const Vector3d on_rail(patch.pose.x, patch.pose.y - result.y, patch.pose.z - result.z);
    contact.place = {};
    contact.place.position = on_rail - patch.approach * normal(patch.pose.angle);
    contact.place.angle = patch.pose.angle;
    const Eigen::Vector2d velocity = movementAt(patch, heads[patch.side], state.rail_velocity[patch.side]);
    contact.place.rail_velocity_y = velocity.x();
    contact.place.rail_velocity_z = velocity.y();
    const Eigen::Vector2d slope = movementAt(patch, heads[patch.side], directions[patch.side]);
    contact.place.slope_y = slope.x();
    contact.place.slope_z = slope.y();
    contact.problem.speed = motion_.speed;
    contact.problem.normal_force = patch.normal_force;
    contact.problem.semi_axis_along = patch.semi_axis_along;
    contact.problem.semi_axis_across = patch.semi_axis_across;
    contact.problem.grid = patch.grid;
    contact.problem.pressure = patch.pressure;
    contact.problem.elasticity = elasticity_[patch.side];
    contact.problem.friction = config_.creep.friction[patch.side];
    std::size_t& most = strongest[patch.side];
    most = most == count_ || patch.normal_force > result.patches[most].normal_force ? k : most;
  }
  if (config_.wheelset.solve_height_and_roll)
  {
    motion_.vertical_velocity = NAN;
    const bool both = strongest.left < count_ && strongest.right < count_;
    motion_.roll_rate =
        both ? followingRollRate(motion_, contacts_[strongest.left].place, contacts_[strongest.right].place) : 0;
  }
}

/// Solves all patches at a rotation [rad/s]. Returns the moment of their forces on the wheelset about the axle [N m].
double ContactFriction::momentAbout(const Vector3d& axle, double rotation)
{
  motion_.rotation = rotation;
  double sum = 0;
  for (std::size_t k = 0; k < count_; ++k)
  {
    Contact& contact = contacts_[k];
    contact.problem.creepage = creepages(motion_, contact.place);
    solver_->solve(contact.problem, false, contact.solution);
    sum += axle.dot(onWheelset(contact.place, contact.solution.force).moment);
  }
  return sum;
}

/// Solves all patches at the rotation at which friction has no moment about the axle. The moment falls as the wheelset
/// turns faster. The range about the last rotation is widened until it contains the root. @return false if none does
bool ContactFriction::rollFreely(const Vector3d& axle)
{
  const auto moment = [&](double rotation) { return momentAbout(axle, rotation); };
  const double rolling = std::abs(motion_.speed) / config_.wheelset.meanRadius();
  const double start = std::clamp(free_rotation_ * motion_.speed, -1.5 * rolling, 1.5 * rolling);
  if (count_ == 0)
  {
    motion_.rotation = motion_.speed / config_.wheelset.meanRadius();
    return true;
  }
  for (double range = narrow_range * rolling; range < 2 * rolling; range *= 10)
  {
    const double at_low = moment(start - range), at_high = moment(start + range);
    if (at_low > 0 && at_high < 0)
    {
      bracketedRoot(moment, start - range, at_low, start + range, at_high, rotation_accuracy * rolling);
      free_rotation_ = motion_.rotation / motion_.speed;  // the root is the last place
      return true;
    }
  }
  return false;
}

void ContactFriction::addForces(PatchResult& patch, const Contact& contact, const PlanePoint& head,
                                WheelsetResult& result, Friction& found) const
{
  const auto [force, moment] = onWheelset(contact.place, contact.solution.force);
  const double sign = sideSign(patch.side);
  const double outward = -sign * force.y(), up = -force.z();
  patch.creep.vertical_force = -up;
  patch.creep.lateral_force = outward;
  patch.vertical_force -= up;
  patch.lateral_force += outward;
  WheelForces& wheel = result.wheel[patch.side];
  wheel.vertical -= up;
  wheel.lateral += outward;
  wheel.friction_vertical -= up;
  wheel.friction_lateral += outward;
  result.rail_wrench.force += force;
  result.rail_wrench.moment += moment;
  // A given lateral force replaces that of the contact.
  const double bending = config_.rail_bending.lateral_force == RailBendingConfig::LateralForce::contact ? outward : 0;
  found.segment<of_side>(of_side * static_cast<int>(patch.side)) +=
      (Eigen::Matrix<double, of_side, 1>() << force.z(), moment.x(), bending, up,
       bending * (patch.pose.z - head.z) - up * (sign * patch.pose.y - head.y))
          .finished();
}
}  // namespace wheel_rail_contact::core
