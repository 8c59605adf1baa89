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
constexpr int strict_passes = 16;    ///< after these, planes and roll may be left open by late_slack times as much
constexpr double late_slack = 10.0;  ///< where contact jumps between tread and flange [-]
/// Where a state is not found from cold, it is approached from beside it, nearer to the track's centre [m].
constexpr std::array<double, 2> detours{0.05e-3, 0.2e-3};
constexpr double roll_per_tolerance = 3e-4;  ///< roll left open for each unit of contact/tolerance [rad]
constexpr double plane_per_tolerance = 0.1;  ///< plane error left open for each unit of contact/tolerance [rad]
// A pass is far from the balance while a plane, a descent or the roll is off by more than this.
constexpr double far_plane = 0.05;       ///< [rad]
constexpr double far_penetration = 0.1;  ///< relative [-]
constexpr double far_roll = 1e-4;        ///< [rad]
constexpr double least_load = 1e-9;      ///< of a wheel; the approach under less is rounding of its place [N]
constexpr double least_fill = 0.8;       ///< share of its expected size that a pressure must have
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
      return fail(ContactStatus::not_converged, "no grid was found that holds all of the contact");
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

/// Moves the rails to where the last solutions want them. Returns how far they still are from it: settled up to 1.
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

/// True if planes and boxes fit the pressure; otherwise they are laid anew in the next pass. What the wheel has slid
/// along the planes since the gaps were built is given no slack.
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

/// True if the roll left open [rad] is small, and small for each patch: there no slack is given.
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

/// True if a pass is so far from the balance that a rough grid tells as well where to go.
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

/// True if the estimated errors meet the tolerance or cannot be made smaller; otherwise finer grids are chosen.
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

/// Chooses grids after the last rough pass.
void WheelsetBalance::chooseGrids()
{
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    choice_[k].start(loaded_[k] ? largestOf(wheel_[k].estimateErrors()) : ErrorEstimate());
    tryClosedForm(side);
  }
}

/// Their ellipses follow the curvature of a single place, which may keep passes from settling.
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

/// Sets out from the last answer: wheel loads, and descents to be expected under them.
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
    foresee(moved);
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

/// From the last answer, from cold, and from beside the state.
ContactStatus WheelsetBalance::searchAround(const WheelsetState& state)
{
  const bool warm = warm_;
  ContactStatus status = search(state);
  if (!isUsable(status) && warm)
  {
    status = search(state);  // from cold
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
    const bool high = heightsMeet();
    const bool settled = fits && level && high && open <= 1;
    const bool far = (isFar(roll_change) || open > 1) && pass < strict_passes;
    if (rough && !far)
    {
      chooseGrids();
    }
    if (!rough && settled && fineEnough())
    {
      finish(roll_change);
      return loaded_[0] && loaded_[1] ? ContactStatus::ok : ContactStatus::lift_off;
    }
    rough = far && (rough || (pass == 0 && levels_.count() > 1));  // a grid given by hand is kept while warm
    const bool steady = secant_.steady(roll_, difference);
    if (fits || steady || !secant_.takesOver())
    {
      secant_.record(roll_, difference);
    }
  }
  return fail(ContactStatus::not_converged, "height, roll and rail deflection found no common balance");
}

/// Height and roll from the last pass; what the roll was still off is made up for to first order.
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
