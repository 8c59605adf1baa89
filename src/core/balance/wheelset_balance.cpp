// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheelset_balance.h"

#include <algorithm>
#include <cmath>

#include "core/balance/both_sides.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr int most_passes = 60;
constexpr int strict_passes = 16;    ///< after these passes, planes and roll may have late_slack times the errors
constexpr double late_slack = 10.0;  ///< for contacts that jump between tread and flange [-]
/// If a state is not solved from a cold start, it is approached from states nearer to the track centre [m].
constexpr std::array<double, 2> detours{0.05e-3, 0.2e-3};
constexpr double roll_per_tolerance = 3e-4;  ///< allowed roll error per unit of contact/tolerance [rad]
constexpr double plane_per_tolerance = 0.1;  ///< allowed plane error per unit of contact/tolerance [rad]
// A pass is far from the balance if a plane, a penetration or the roll is off by more than these values.
constexpr double far_plane = 0.05;       ///< [rad]
constexpr double far_penetration = 0.1;  ///< relative [-]
constexpr double far_roll = 1e-4;        ///< [rad]
constexpr double least_load = 1e-9;  ///< smallest wheel load; below it, the approach is of the order of rounding [N]
constexpr double least_fill = 0.8;   ///< smallest boxFill() [-]
}  // namespace

WheelsetBalance::WheelsetBalance(const ContactModelConfig& config, const GridLevels& levels)
    : config_(config),
      levels_(levels),
      wheel_{WheelContact(config, levels.solver()), WheelContact(config, levels.solver())},
      rail_{BendingRail(config, levels.solver().solvesSupport(), wheel_[0]),
            BendingRail(config, levels.solver().solvesSupport(), wheel_[1])},
      choice_{GridLevelChoice(levels, config.contact.tolerance), GridLevelChoice(levels, config.contact.tolerance)}
{
  reset();
}

void WheelsetBalance::reset()
{
  warm_ = false;
  roll_ = 0;
  finds_loads_ = heightOnBendingRails();
  for (const Side side : sides)
  {
    wheel_[index(side)].reset();
    rail_[index(side)].reset();
    choice_[index(side)] = GridLevelChoice(levels_, config_.contact.tolerance);
  }
}

ContactStatus WheelsetBalance::fail(ContactStatus status, std::string_view reason)
{
  reset();
  reason_ = reason;
  return status;
}

ContactStatus WheelsetBalance::failed(WheelStatus status)
{
  switch (status)
  {
    case WheelStatus::beside_rail:
      return fail(ContactStatus::off_profile, "a wheel is beside its rail");
    case WheelStatus::off_profile:
      return fail(ContactStatus::off_profile, "contact lies beyond the end of a profile");
    case WheelStatus::box_not_found:
      return fail(ContactStatus::not_converged, "no grid was found that covers the whole contact");
    case WheelStatus::spike:
      return fail(ContactStatus::not_converged, "pressure on fewer than three cells");
    default:
      return fail(ContactStatus::not_converged, toString(normal_status_));
  }
}

WheelStatus WheelsetBalance::solveWheel(Side side, const GridLevel& level)
{
  const std::size_t k = index(side);
  WheelContact& wheel = wheel_[k];
  wheel.setSolver(*level.solver);
  if (!config_.wheelset.solve_height_and_roll && !finds_loads_)
  {
    return wheel.solvePenetration(touch_[k], touch_[k].axle_height - state_.z, level.size);
  }
  return load_[k] > 0 ? wheel.solveLoad(touch_[k], load_[k], level.size) : WheelStatus::no_contact;
}

WheelStatus WheelsetBalance::solveWheels(bool rough)
{
  const auto is_failure = [](WheelStatus status)
  { return status != WheelStatus::solved && status != WheelStatus::no_contact; };
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    WheelStatus status = solveWheel(side, rough ? levels_.rough() : choice_[k].level());
    if (is_failure(status) && !rough && choice_[k].leaveClosedForm())
    {
      status = solveWheel(side, choice_[k].level());
    }
    loaded_[k] = status == WheelStatus::solved;
    penetration_[k] = loaded_[k] ? wheel_[k].penetration() : 0;
    if (is_failure(status))
    {
      normal_status_ = wheel_[k].solution().status;
      return status;
    }
  }
  return WheelStatus::solved;
}

/// Moves the rails towards the deflections that the last solutions cause. Returns the remaining difference over the
/// allowed one; converged if at most 1.
double WheelsetBalance::moveRails()
{
  double open = 0;
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    open = std::max(open, rail_[k].follow(loaded_[k], state_.rail_lateral_force[k]));
    penetration_[k] = loaded_[k] ? wheel_[k].penetration() : 0;
  }
  return open;
}

/// True if planes and boxes fit the pressure. Otherwise they are laid again in the next pass. The slack does not apply
/// to slipError().
bool WheelsetBalance::layoutFits(double slack)
{
  bool all = true;
  for (const Side side : sides)
  {
    WheelContact& wheel = wheel_[index(side)];
    const double tolerance = slack * config_.contact.tolerance;
    const bool fits =
        !loaded_[index(side)] ||
        (wheel.planeError() < plane_per_tolerance * tolerance && std::abs(wheel.penetrationError()) < tolerance &&
         (wheel.boxFill() > least_fill || wheel.widened()) && wheel.slipError() < config_.contact.tolerance);
    if (!fits)
    {
      wheel.learn();
    }
    all = all && fits;
  }
  return all;
}

/// True if the remaining roll error [rad] and its effect on each patch are small. The slack does not apply to the
/// effect on the patches.
bool WheelsetBalance::isLevel(double open_roll, double slack) const
{
  const double tolerance = config_.contact.tolerance;
  bool level = std::abs(open_roll) < slack * roll_per_tolerance * tolerance;
  for (const Side side : sides)
  {
    level = level && (!loaded_[index(side)] || wheel_[index(side)].rollError(open_roll) < tolerance);
  }
  return level;
}

/// True if a pass is so far from the balance that a rough grid is sufficient.
bool WheelsetBalance::isFar(double roll_change) const
{
  bool far = std::abs(roll_change) > far_roll;
  for (const Side side : sides)
  {
    const WheelContact& wheel = wheel_[index(side)];
    far = far || (loaded_[index(side)] &&
                  (wheel.planeError() > far_plane || std::abs(wheel.penetrationError()) > far_penetration));
  }
  return far;
}

/// True if the estimated errors meet the tolerance or cannot be reduced. Otherwise finer grids are chosen.
bool WheelsetBalance::fineEnough()
{
  bool enough = true;
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    error_[k] = loaded_[k] ? largestOf(wheel_[k].estimateErrors()) : ErrorEstimate();
    enough = !choice_[k].refine(error_[k]) && enough;
  }
  return enough;
}

/// Chooses the grids after the last rough pass.
void WheelsetBalance::chooseGrids()
{
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    choice_[k].start(loaded_[k] ? largestOf(wheel_[k].estimateErrors()) : ErrorEstimate());
    tryClosedForm(side);
  }
}

/// Replaces closed forms by grids. A Hertz ellipse follows the curvature at a single point, which may prevent
/// convergence of the passes.
void WheelsetBalance::leaveClosedForms()
{
  for (GridLevelChoice& choice : choice_)
  {
    choice.leaveClosedForm();
  }
}

void WheelsetBalance::tryClosedForm(Side side)
{
  const std::size_t k = index(side);
  if (loaded_[k])
  {
    choice_[k].tryClosedForm(wheel_[k].problem(), wheel_[k].solution());
  }
}

/// Starts from the last result: wheel loads and expected penetrations. Returns false if a wheel is beside its rail.
bool WheelsetBalance::begin(const WheelsetState& state)
{
  const double moved = state.y - state_.y;
  state_ = state;
  const double transfer = 0.5 * state.torque_x / config_.wheelset.halfBase();
  load_ = {-0.5 * state.force_z - transfer, -0.5 * state.force_z + transfer};
  for (const Side side : sides)
  {
    wheel_[index(side)].begin(moved);
    choice_[index(side)].arrive(state.y);
    double& load = load_[index(side)];
    load = finds_loads_ ? expectedLoad(side) : load < least_load ? std::min(load, 0.0) : load;
    load_search_[index(side)].begin(load_[index(side)]);
    rail_[index(side)].begin(!warm_, load_[index(side)], state.rail_offset[index(side)]);
  }
  secant_.reset();
  if (!config_.wheelset.solve_height_and_roll)
  {
    roll_ = state.roll;
    return true;
  }
  if (warm_)
  {
    predictRoll(moved);
  }
  else if (!touchFirst())
  {
    return false;
  }
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    penetration_[k] = load_[k] > 0 ? wheel_[k].estimatePenetration(touch_[k], load_[k]) + wheel_[k].deflected() : 0;
  }
  return true;
}

ContactStatus WheelsetBalance::solve(const WheelsetState& state)
{
  const ContactStatus status = searchAround(state);
  if (isUsable(status) || !heightOnBendingRails())
  {
    return status;
  }
  finds_loads_ = !finds_loads_;
  return search(state);
}

bool WheelsetBalance::heightOnBendingRails() const
{
  return !config_.wheelset.solve_height_and_roll && config_.rail_bending.model == RailBendingConfig::Model::compliance;
}

/// Solves a state from the last result, from a cold start, and from results next to the state.
ContactStatus WheelsetBalance::searchAround(const WheelsetState& state)
{
  const bool warm = warm_;
  ContactStatus status = search(state);
  if (!isUsable(status) && warm)
  {
    status = search(state);  // from a cold start
  }
  std::string_view reason = reason_;
  for (auto beside = detours.begin(); !isUsable(status) && beside != detours.end(); ++beside)
  {
    WheelsetState nearer = state;
    nearer.y -= std::copysign(*beside, state.y);
    if (isUsable(search(nearer)))
    {
      status = search(state);
      reason = reason_;
    }
  }
  reason_ = reason;
  return status;
}

ContactStatus WheelsetBalance::search(const WheelsetState& state)
{
  if (!begin(state))
  {
    return failed(WheelStatus::beside_rail);
  }
  bool rough = !warm_;
  for (int pass = 0; pass < most_passes; ++pass)
  {
    if (!place(pass == 0))
    {
      return failed(WheelStatus::beside_rail);
    }
    if (pass == strict_passes)
    {
      leaveClosedForms();
    }
    const WheelStatus status = solveWheels(rough);
    if (status != WheelStatus::solved)
    {
      return failed(status);
    }
    const double difference = heightDifference();
    const double roll_change = config_.wheelset.solve_height_and_roll ? difference / leverSum() : 0;
    const double open = moveRails();
    const double slack = pass < strict_passes ? 1.0 : late_slack;
    const bool fits = layoutFits(slack);
    const bool level = isLevel(roll_change, slack);
    const bool heights_meet = heightsMeet();
    const bool converged = fits && level && heights_meet && open <= 1;
    const bool far = (isFar(roll_change) || open > 1) && pass < strict_passes;
    if (rough && !far)
    {
      chooseGrids();
    }
    if (!rough && converged && fineEnough())
    {
      finish(roll_change);
      return loaded_[0] && loaded_[1] ? ContactStatus::ok : ContactStatus::lift_off;
    }
    rough = far && (rough || (pass == 0 && levels_.count() > 1));  // a grid set by hand is kept in warm starts
    const bool steady = secant_.steady(roll_, difference);
    if (fits || steady || !secant_.takesOver())
    {
      secant_.record(roll_, difference);
    }
  }
  return fail(ContactStatus::not_converged, "no balance of height, roll and rail deflection was found");
}

/// Height and roll from the last pass, corrected to first order for the remaining roll error.
void WheelsetBalance::finish(double roll_change)
{
  warm_ = true;
  open_roll_ = roll_change;
  reason_ = {};
  for (const Side side : sides)
  {
    wheel_[index(side)].finish();
    rail_[index(side)].finish(loaded_[index(side)]);
    choice_[index(side)].coarsen(error_[index(side)]);
    tryClosedForm(side);
  }
  if (!config_.wheelset.solve_height_and_roll)
  {
    height_ = state_.z;
    return;
  }
  roll_ += roll_change;
  const double left = (touch_[0].axle_height - penetration_[0]) - lever(Side::left) * roll_change;
  const double right = (touch_[1].axle_height - penetration_[1]) + lever(Side::right) * roll_change;
  height_ = 0.5 * (left + right);
}
}  // namespace wheel_rail_contact::core
