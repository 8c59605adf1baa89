// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/wheelset_contact.h"

#include <algorithm>
#include <cmath>

#include "core/balance/grid_levels.h"
#include "core/balance/wheelset_balance.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double angle_limit = 0.2;    ///< largest accepted yaw and given roll [rad]
constexpr double lateral_limit = 0.1;  ///< largest accepted lateral position [m]
constexpr double height_limit = 1.0;   ///< largest accepted axle height, if given [m]
constexpr double force_limit = 1e8;    ///< largest accepted load [N], [N m]
constexpr double offset_limit = 0.1;   ///< largest accepted displacement of a rail by other wheelsets [m]

bool within(double value, double limit)
{
  return std::abs(value) <= limit;
}

bool within(const RailDeflection& offset)
{
  return within(offset.lateral, offset_limit) && within(offset.vertical, offset_limit) &&
         within(offset.roll, angle_limit);
}

/// Reason why a state is rejected; empty if it is valid.
std::string_view fault(const WheelsetState& state, bool height_and_roll_given)
{
  if (!within(state.y, lateral_limit))
  {
    return "lateral position is not a number or beyond 0.1 m";
  }
  if (!within(state.yaw, angle_limit))
  {
    return "yaw is not a number or beyond 0.2 rad";
  }
  if (!within(state.force_z, force_limit) || !within(state.torque_x, force_limit))
  {
    return "load is not a number or beyond 1e8 N";
  }
  if (!within(state.rail_lateral_force[0], force_limit) || !within(state.rail_lateral_force[1], force_limit))
  {
    return "lateral rail force is not a number or beyond 1e8 N";
  }
  if (!within(state.rail_offset[0]) || !within(state.rail_offset[1]))
  {
    return "deflection of a rail by other wheelsets is not a number or beyond 0.1 m or 0.2 rad";
  }
  if (height_and_roll_given && !within(state.roll, angle_limit))
  {
    return "roll is not a number or beyond 0.2 rad";
  }
  if (height_and_roll_given && !within(state.z, height_limit))
  {
    return "height is not a number or beyond 1 m";
  }
  return {};
}

/// Copies the whole pressure field of a patch, in track axes. A symmetric grid stores only half of the cells. On the
/// right side the field is mirrored.
void spread(Side side, const Grid& grid, const Eigen::ArrayXXd& stored, PatchResult& result)
{
  result.grid = {grid.nx, grid.ny, grid.dx, grid.dy, grid.y0};
  result.pressure.resize(grid.nx, grid.ny);
  if (grid.symmetric)
  {
    result.pressure.bottomRows(grid.rows()) = stored;
    result.pressure.topRows(grid.rows()) = stored.colwise().reverse();
  }
  else
  {
    result.pressure = stored;
  }
  if (side == Side::right)
  {
    result.grid.y0 = -(grid.y0 + (grid.ny - 1) * grid.dy);
    result.pressure.rowwise().reverseInPlace();
  }
}
}  // namespace

class WheelsetContact::Chain
{
 public:
  explicit Chain(ContactModelConfig config)
      : config_(checked(std::move(config))), levels_(config_), balance_(config_, levels_)
  {
  }

  const WheelsetResult& evaluate(const WheelsetState& state)
  {
    const bool given = !config_.wheelset.solve_height_and_roll;
    result_.x = state.x;
    result_.y = state.y;
    result_.yaw = state.yaw;
    result_.z = given ? state.z : config_.wheelset.rolling_radius;
    result_.roll = given ? state.roll : 0;
    const std::string_view reason = fault(state, given);
    result_.status = reason.empty() ? balance_.solve(state) : ContactStatus::invalid_input;
    result_.reason = reason.empty() ? balance_.reason() : reason;
    result_.rail = {balance_.rail(Side::left), balance_.rail(Side::right)};
    result_.above_tolerance = false;
    patch_count_ = 0;
    if (isUsable(result_.status))
    {
      result_.z = balance_.height();
      result_.roll = balance_.roll();
      addPatches(Side::left);
      addPatches(Side::right);
      result_.reason = remark();
    }
    result_.patches.resize(patch_count_);
    return result_;
  }

  void reset() { balance_.reset(); }
  const ContactModelConfig& config() const { return config_; }

 private:
  static ContactModelConfig checked(ContactModelConfig config)
  {
    validate(config);
    return config;
  }

  /// Remark on a usable result: wheels that carry no load, or an error estimate above the tolerance; otherwise empty.
  std::string_view remark() const
  {
    if (balance_.loaded(Side::left) && balance_.loaded(Side::right))
    {
      return result_.above_tolerance ? "an error estimate is above contact/tolerance" : "";
    }
    if (balance_.loaded(Side::left))
    {
      return "the right wheel carries no load";
    }
    return balance_.loaded(Side::right) ? "the left wheel carries no load" : "neither wheel carries a load";
  }

  void addPatches(Side side)
  {
    const WheelContact& wheel = balance_.wheel(side);
    for (std::size_t k = 0; balance_.loaded(side) && k < wheel.patches().size(); ++k)
    {
      if (wheel.solution().patches[k].force > 0)
      {
        result_.patches.resize(std::max(result_.patches.size(), patch_count_ + 1));
        PatchResult& patch = result_.patches[patch_count_++];
        fill(side, wheel, k, patch);
        result_.above_tolerance = result_.above_tolerance || patch.error_estimate > config_.contact.tolerance;
      }
    }
  }

  void fill(Side side, const WheelContact& wheel, std::size_t k, PatchResult& out) const
  {
    const WheelPatch& patch = wheel.patches()[k];
    const PatchPressure& pressure = wheel.solution().patches[k];
    const double sign = sideSign(side);
    out.side = side;
    out.method = wheel.solver().name();
    const Eigen::Vector2d displacement = wheel.railDisplacement(patch);
    out.pose = {patch.plane.x, sign * (patch.plane.y + displacement[0]), patch.plane.z + displacement[1],
                sign * patch.plane.angle};
    out.contact_angle = std::abs(patch.plane.angle);
    out.normal_force = pressure.force;
    out.approach = wheel.patchApproach(k);
    out.area = pressure.area;
    out.max_pressure = pressure.max_pressure;
    out.error_estimate = std::hypot(wheel.errors()[k].largest(), wheel.layoutError(k, balance_.openRoll()));
    out.iterations = wheel.solution().iterations;
    out.residual = wheel.solution().residual;
    out.half_space_ratio = wheel.halfSpaceRatio(k);
    spread(side, wheel.problem().patches[k].grid, pressure.pressure, out);
  }

  ContactModelConfig config_;
  GridLevels levels_;
  WheelsetBalance balance_;
  WheelsetResult result_;
  std::size_t patch_count_ = 0;
};

WheelsetContact::WheelsetContact(ContactModelConfig config) : chain_(std::make_unique<Chain>(std::move(config))) {}

WheelsetContact::~WheelsetContact() = default;
WheelsetContact::WheelsetContact(WheelsetContact&&) noexcept = default;
WheelsetContact& WheelsetContact::operator=(WheelsetContact&&) noexcept = default;

const WheelsetResult& WheelsetContact::evaluate(const WheelsetState& state)
{
  return chain_->evaluate(state);
}

void WheelsetContact::reset()
{
  chain_->reset();
}

const ContactModelConfig& WheelsetContact::config() const
{
  return chain_->config();
}
}  // namespace wheel_rail_contact::core
