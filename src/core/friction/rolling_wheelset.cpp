// SPDX-License-Identifier: BSD-3-Clause
#include "core/friction/rolling_wheelset.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/track/root_bracket.h"
#include "core/track/track_frame.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
using Eigen::Vector3d;

namespace
{
constexpr double narrow_range = 1e-4;  ///< of the free rotation about the last one, at first [-]
constexpr int most_secants = 6;
constexpr double largest_secant = 0.01;  ///< distance from the last rotation, over that of pure rolling [-]
/// Accuracy of the free rotation, which is that of the longitudinal creepage [-]. The tractions of `exact` change by
/// 5e-4 in their last sweep, which is the change by a longitudinal creepage of about 1e-6.
constexpr double rotation_accuracy = 1e-8, rotation_accuracy_exact = 1e-6;
}  // namespace

RollingWheelset::RollingWheelset(const ContactModelConfig& config)
    : config_(config), free_rotation_(1 / config.wheelset.meanRadius())
{
  for (const Side side : sides)
  {
    elasticity_[side] = config.creep.method != CreepMethod::none
                            ? shearElasticity(config.wheel_material[side], config.rail_material[side])
                            : ShearElasticity();
  }
}

void RollingWheelset::reset()
{
  free_rotation_ = 1 / config_.wheelset.meanRadius();
  free_slope_ = 0;
  for (RollingContact& contact : contacts_)
  {
    contact.forget();
  }
}

std::string_view RollingWheelset::solve(const WheelsetState& state, const WheelsetBalance& balance)
{
  const TrackLine* line = config_.track.line.get();
  turn_ = line != nullptr ? turnOf(*line, state.distance) : Vector3d::Zero();
  frame_turn_ = state.motion_over_ground ? Vector3d::Zero() : turn_;
  setContacts(state, balance);
  setMotion(state, balance);
  const Vector3d axle = axleDirection(motion_.yaw, motion_.roll);
  if (config_.creep.rotation == CreepConfig::Rotation::given)
  {
    momentAbout(axle, motion_.rotation);
  }
  else if (!rollFreely(axle))
  {
    return "no rotation of the wheelset was found at which friction has no moment about the axle";
  }
  const auto failed = [](CreepStatus status) { return !isUsable(status); };
  const auto first = std::find_if(statuses_.begin(), statuses_.end(), failed);
  return first == statuses_.end() ? std::string_view() : toString(*first);
}

void RollingWheelset::setContacts(const WheelsetState& state, const WheelsetBalance& balance)
{
  count_ = 0;
  contact_of_.clear();
  for (const Side side : sides)
  {
    const RailRates bend{sideSign(side) * turn_.z(), -turn_.y(), 0}, &velocity = state.rail_velocity[side];
    const RailMotion direction{balance.wheel(side).rail().slope, bend};
    const Islands& islands = balance.islands(side);
    for (std::size_t i = 0; balance.wheel(side).loaded() && i < islands.islands().size(); ++i)
    {
      const Island& island = islands.islands()[i];
      if (i == 0 || island.patch != islands.islands()[i - 1].patch)
      {
        RollingContact& contact = nextContact(side);
        contact.place(side, balance, island.patch, direction, velocity);
        if (config_.creep.method == CreepMethod::linear)
        {
          contact.join();
        }
      }
      contact_of_.push_back(count_ - 1);
    }
  }
  statuses_.assign(count_, CreepStatus::invalid_problem);
}

RollingContact& RollingWheelset::nextContact(Side side)
{
  if (contacts_.size() == count_)
  {
    contacts_.emplace_back(config_.creep.method);
  }
  RollingContact& contact = contacts_[count_++];
  contact.setMaterial(elasticity_[side], config_.creep.friction[side]);
  return contact;
}

/// Where height and roll are solved, the wheels follow their rails.
void RollingWheelset::setMotion(const WheelsetState& state, const WheelsetBalance& balance)
{
  motion_ = state.motion;
  motion_.yaw = state.yaw;
  motion_.roll = balance.roll();
  speed_ = motion_.speed;
  frame_rotation_ = 0;
  if (!frame_turn_.isZero(0))
  {
    const Vector3d turn = speed_ * frame_turn_, velocity = turn.cross(Vector3d(0, state.y, balance.height()));
    motion_.speed += velocity.x();
    motion_.lateral_velocity += velocity.y();
    motion_.vertical_velocity += velocity.z();
    motion_.roll_rate += turn.x();
    motion_.rotation += frame_rotation_ = turn.y();
    motion_.yaw_rate += turn.z();
  }
  if (config_.wheelset.solve_height_and_roll)
  {
    const std::size_t left = strongest(Side::left), right = strongest(Side::right);
    if (count_ > 0)
    {
      followRails(contacts_[std::min(left, right)].centre(), contacts_[right < count_ ? right : left].centre(),
                  motion_);
    }
  }
}

std::size_t RollingWheelset::strongest(Side side) const
{
  std::size_t most = count_;
  for (std::size_t k = 0; k < count_; ++k)
  {
    const bool is_stronger = most == count_ || contacts_[k].normalForce() > contacts_[most].normalForce();
    most = contacts_[k].side() == side && is_stronger ? k : most;
  }
  return most;
}

/// Solves all contacts at a rotation [rad/s]. Returns the moment of their forces on the wheelset about the axle [N m].
double RollingWheelset::momentAbout(const Vector3d& axle, double rotation)
{
  motion_.rotation = rotation;
  double sum = 0;
  for (std::size_t k = 0; k < count_; ++k)
  {
    statuses_[k] = contacts_[k].solve(motion_, config_.wheelset.solve_height_and_roll);
    sum += axle.dot(contacts_[k].onWheelset().moment);
  }
  return sum;
}

/// Solves all contacts at the rotation at which friction has no moment about the axle. The moment falls as the wheelset
/// turns faster. Where secants lead astray, the range about the last rotation is widened until it contains the root.
/// @return false if none does
bool RollingWheelset::rollFreely(const Vector3d& axle)
{
  const auto moment = [&](double rotation) { return momentAbout(axle, rotation); };
  const double rolling = std::abs(motion_.speed) / config_.wheelset.meanRadius();
  const double start = std::clamp(free_rotation_ * motion_.speed, -1.5 * rolling, 1.5 * rolling);
  const double accuracy =
      rolling * (config_.creep.method == CreepMethod::exact ? rotation_accuracy_exact : rotation_accuracy);
  if (count_ == 0)
  {
    motion_.rotation = motion_.speed / config_.wheelset.meanRadius();
    return true;
  }
  bool is_found = followSecants(axle, start, accuracy);
  for (double range = narrow_range * rolling; !is_found && range < 2 * rolling; range *= 10)
  {
    const double at_low = moment(start - range), at_high = moment(start + range);
    if (at_low == 0 && at_high == 0)  // no friction
    {
      moment(motion_.speed / config_.wheelset.meanRadius());
      return true;
    }
    if (at_low > 0 && at_high < 0)
    {
      bracketedRoot(moment, start - range, at_low, start + range, at_high, accuracy);
      free_slope_ = std::abs(motion_.speed) * (at_high - at_low) / (2 * range);
      is_found = true;  // the root is the last place
    }
  }
  free_rotation_ = is_found ? motion_.rotation / motion_.speed : free_rotation_;
  return is_found;
}

/// Follows secants from a rotation to the free one, the first one with the last slope.
/// @return false if they lead astray
bool RollingWheelset::followSecants(const Vector3d& axle, double start, double accuracy)
{
  const double speed = std::abs(motion_.speed), farthest = largest_secant * speed / config_.wheelset.meanRadius();
  double value = free_slope_ < 0 ? momentAbout(axle, start) : 0;
  for (int step = 0; step < most_secants && value != 0 && free_slope_ < 0; ++step)
  {
    const double change = -value * speed / free_slope_, rotation = motion_.rotation + change;
    if (std::abs(change) <= accuracy || std::abs(rotation - start) > farthest)
    {
      return std::abs(change) <= accuracy;
    }
    const double next = momentAbout(axle, rotation);
    free_slope_ = speed * (next - value) / change;
    value = next;
  }
  return false;
}

template <typename Quantity, typename Get>
Quantity RollingWheelset::sumOf(Side side, Quantity sum, const Get& get) const
{
  for (std::size_t k = 0; k < count_; ++k)
  {
    if (contacts_[k].side() == side)
    {
      sum += get(contacts_[k]);
    }
  }
  return sum;
}

double RollingWheelset::normalForce(Side side) const
{
  return sumOf(side, 0.0, [](const RollingContact& contact) { return contact.normalForce(); });
}

Wrench RollingWheelset::onWheel(Side side) const
{
  return sumOf(side, Wrench(), [](const RollingContact& contact) { return contact.onWheelset(); });
}

Vector3d RollingWheelset::onRail(Side side, bool with_lateral) const
{
  const Vector3d zero = Vector3d::Zero();
  return sumOf(side, zero, [&](const RollingContact& contact) { return contact.onRail(with_lateral); });
}

void RollingWheelset::addTo(const WheelsetBalance& balance, WheelsetResult& result) const
{
  result.speed = speed_;
  result.rotation = motion_.rotation - frame_rotation_;
  std::size_t patch = 0;
  for (const Side side : sides)
  {
    const std::vector<Island>& islands = balance.islands(side).islands();
    WheelForces& wheel = result.wheel[side];
    for (std::size_t i = 0; balance.wheel(side).loaded() && i < islands.size(); ++i, ++patch)
    {
      PatchResult& of = result.patches[patch];
      contacts_[contact_of_[patch]].addTo(islands[i], config_.creep.field, of);
      wheel.vertical += of.creep.vertical_force;
      wheel.lateral += of.creep.lateral_force;
      wheel.friction_vertical += of.creep.vertical_force;
      wheel.friction_lateral += of.creep.lateral_force;
    }
    result.rail_wrench += onWheel(side);
  }
}
}  // namespace wheel_rail_contact::core
