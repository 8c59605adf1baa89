// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/balance/wheelset_balance.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
constexpr std::array<Side, 2> sides{Side::left, Side::right};
constexpr int most_passes = 60;
constexpr int strict_passes = 16;    ///< after these, planes and roll may be left open by late_slack times as much
constexpr double late_slack = 10.0;  ///< where contact jumps between tread and flange [-]
constexpr int most_roll_steps = 60;
constexpr double roll_limit = 0.2;           ///< [rad]
constexpr double roll_step_limit = 5e-3;     ///< [rad]
constexpr double height_tolerance = 1e-9;    ///< of both axle ends, in finding the roll [m]
constexpr double roll_per_tolerance = 3e-4;  ///< roll left open for each unit of contact/tolerance [rad]
constexpr double plane_per_tolerance = 0.1;  ///< plane error left open for each unit of contact/tolerance [rad]
constexpr double least_fill = 0.8;           ///< share of its expected size that a pressure must have
constexpr double coupling_tolerance = 1e-6;  ///< of deflection due and deflection used, relative
constexpr double roll_arm = 0.1;             ///< makes a roll comparable with a displacement [m]
constexpr double sharpest_radius = 0.01;     ///< of rail heads and wheel flanges [m]
constexpr double slip_share = 0.01;   ///< of contact/tolerance, left open in the gap by the rail's way along the plane
constexpr double same_load = 0.01;    ///< change of a wheel's load that need not move its rail beforehand [-]
constexpr double flange_slope = 0.3;  ///< of a first touch above which it is the flange's [-]
constexpr double flange_step = 2e-4;  ///< by which a rail is set out from under a flange [m]
constexpr double greatest_lateral_share = 2.0;  ///< lateral force that may have to hold it there, of the wheel load [-]
constexpr double early_move = 0.3;  ///< of the way allowed, at which the next answer sets out with the rail moved

std::size_t index(Side side)
{
  return static_cast<std::size_t>(side);
}
}  // namespace

WheelsetBalance::WheelsetBalance(const ContactModelConfig& config, const MethodLadder& ladder)
    : config_(config),
      ladder_(ladder),
      wheel_{WheelContact(config, ladder.solver()), WheelContact(config, ladder.solver())},
      undeflected_(config.rail_profile, config.track),
      bends_(config.rail_bending.model == RailBendingConfig::Model::compliance),
      choice_{RungChoice(ladder, config.contact.tolerance), RungChoice(ladder, config.contact.tolerance)}
{
  support_.yields = bends_ && config.rail_bending.lateral_force == RailBendingConfig::LateralForce::contact &&
                    ladder.solver().solvesSupport();
  support_.compliance = supportCompliance(config.rail_bending.table, config.track.cant);
  reset();
}

void WheelsetBalance::reset()
{
  warm_ = false;
  roll_ = 0;
  rail_ = {};
  const bool prescribed = config_.rail_bending.model == RailBendingConfig::Model::prescribed;
  for (const Side side : sides)
  {
    wheel_[index(side)].reset();
    choice_[index(side)] = RungChoice(ladder_, config_.contact.tolerance);
    setRail(side, prescribed ? config_.rail_bending.prescribed : RailDeflection());
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
    default:
      return fail(ContactStatus::not_converged, toString(normal_status_));
  }
}

bool WheelsetBalance::touchBoth(double roll)
{
  for (const Side side : sides)
  {
    touch_[index(side)] = wheel_[index(side)].touch(toSide(side, {state_.y, 0, state_.yaw, roll}));
  }
  return touch_[0].found && touch_[1].found;
}

double WheelsetBalance::heightDifference() const
{
  return (touch_[0].axle_height - descent_[0]) - (touch_[1].axle_height - descent_[1]);
}

/// The roll at which both axle ends agree, with the descents known so far: the height seen from the left falls with the
/// roll, that from the right rises. Newton's steps, kept within the bracket seen so far.
bool WheelsetBalance::findRoll()
{
  double low = -roll_limit;
  double high = roll_limit;
  for (int i = 0; i < most_roll_steps; ++i)
  {
    if (!touchBoth(roll_))
    {
      return false;
    }
    const double difference = heightDifference();
    if (std::abs(difference) < height_tolerance || high - low < 1e-12)
    {
      return true;
    }
    (difference > 0 ? low : high) = roll_;
    const double levers = touch_[0].lever + touch_[1].lever;
    const double step = std::clamp(difference / levers, -roll_step_limit, roll_step_limit);
    const double next = roll_ + step;
    roll_ = levers > 0 && next > low && next < high ? next : 0.5 * (low + high);
  }
  return false;
}

void WheelsetBalance::setRail(Side side, const RailDeflection& deflection)
{
  rail_[index(side)].deflection = deflection;
  support_.placed = toCoordinates(deflection);
  wheel_[index(side)].setRail(undeflected_.deflected(deflection), support_);
}

WheelStatus WheelsetBalance::solveWheels(bool rough)
{
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    WheelContact& wheel = wheel_[k];
    const GridSize& size = rough ? ladder_.rough().size : choice_[k].rung().size;
    WheelStatus status = WheelStatus::no_contact;
    if (!config_.wheelset.solve_height_and_roll)
    {
      status = wheel.solveDescent(touch_[k], touch_[k].axle_height - state_.z, size);
    }
    else if (load_[k] > 0)
    {
      status = wheel.solveLoad(touch_[k], load_[k], size);
    }
    loaded_[k] = status == WheelStatus::solved;
    descent_[k] = loaded_[k] ? wheel.descent() : 0;
    if (!loaded_[k] && status != WheelStatus::no_contact)
    {
      normal_status_ = wheel.solution().status;
      return status;
    }
  }
  return WheelStatus::solved;
}

/// Takes the forces of the last solutions over to the rail's results, with the lateral force that is to bend it.
RailForce WheelsetBalance::takeForce(Side side)
{
  const std::size_t k = index(side);
  const RailBendingConfig& bending = config_.rail_bending;
  WheelForces forces = loaded_[k] ? wheel_[k].forces() : WheelForces();
  const double from_contact = forces.outward;
  if (bending.lateral_force == RailBendingConfig::LateralForce::topic)
  {
    forces.outward = state_.rail_lateral_force[k];
  }
  else if (bending.lateral_force == RailBendingConfig::LateralForce::constant)
  {
    forces.outward = bending.lateral_force_value;
  }
  forces.moment += (forces.outward - from_contact) * wheel_[k].heightOverReference();
  rail_[k].lateral_force = forces.outward;
  rail_[k].vertical_force = forces.vertical;
  return {forces.outward, forces.vertical, forces.moment};
}

/// A rail's way along the contact planes since it was set, over the one allowed: the gap takes it to first order, and
/// slip²/(2R) is left.
double WheelsetBalance::slipOver(Side side) const
{
  const WheelContact& wheel = wheel_[index(side)];
  const double left_open = slip_share * config_.contact.tolerance * wheel.elasticDescent();
  return wheel.railSlip() / std::sqrt(2 * sharpest_radius * left_open);
}

/// Lets the rail follow the contact solution. Returns slipOver().
double WheelsetBalance::followContact(Side side)
{
  const std::size_t k = index(side);
  WheelContact& wheel = wheel_[k];
  if (!loaded_[k])
  {
    const bool straight = toCoordinates(rail_[k].deflection).isZero(0);
    setRail(side, RailDeflection());
    return straight ? 0 : 2;
  }
  const double open = slipOver(side);
  if (open > 1)
  {
    descent_[k] = wheel.elasticDescent();
    const Eigen::Vector3d placed = toCoordinates(rail_[k].deflection);
    const Eigen::Vector3d way = wheel.support() - placed;
    setRail(side, toDeflection(placed + step_[k].share(wheel.railSlip(), way[0]) * way));
  }
  return open;
}

/// Brings the deflection nearer to the one due under a force. Returns their difference, over the one allowed.
double WheelsetBalance::mixDeflection(Side side, const RailForce& force)
{
  const std::size_t k = index(side);
  const RailDeflection& used = rail_[k].deflection;
  const RailDeflection due = deflectionInTrack(config_.rail_bending.table, force, config_.track.cant);
  const Eigen::Vector3d x(used.lateral, used.vertical, roll_arm * used.roll);
  const Eigen::Vector3d image(due.lateral, due.vertical, roll_arm * due.roll);
  const double difference = image.isZero(0) ? x.norm() : (image - x).norm() / image.norm();
  if (difference > coupling_tolerance)
  {
    const Eigen::Vector3d next = coupling_[k].next(x, image);
    setRail(side, {next[0], next[1], next[2] / roll_arm});
  }
  return difference / coupling_tolerance;
}

/// Moves the rails to where the last solutions want them. Returns how far they still are from it: settled up to 1.
double WheelsetBalance::moveRails()
{
  double open = 0;
  for (const Side side : sides)
  {
    const RailForce force = takeForce(side);
    if (bends_)
    {
      open = std::max(open, support_.yields ? followContact(side) : mixDeflection(side, force));
    }
  }
  return open;
}

/// True if planes and boxes fit the pressure; otherwise they are laid anew in the next pass.
bool WheelsetBalance::layoutFits(double slack)
{
  bool all = true;
  for (const Side side : sides)
  {
    WheelContact& wheel = wheel_[index(side)];
    const double tolerance = slack * config_.contact.tolerance;
    const bool fits = !loaded_[index(side)] ||
                      (wheel.planeError() < plane_per_tolerance * tolerance &&
                       std::abs(wheel.descentError()) < tolerance && (wheel.boxFill() > least_fill || wheel.widened()));
    if (!fits)
    {
      wheel.learn();
    }
    all = all && fits;
  }
  return all;
}

/// True if the estimated errors meet the tolerance or cannot be made smaller; otherwise finer grids are chosen.
bool WheelsetBalance::fineEnough()
{
  bool enough = true;
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    error_[k] = loaded_[k] ? wheel_[k].errorEstimate() : 0;
    enough = !choice_[k].climb(error_[k]) && enough;
  }
  return enough;
}

/// Chooses the first grids after the rough pass.
void WheelsetBalance::chooseGrids()
{
  for (const Side side : sides)
  {
    choice_[index(side)].start(loaded_[index(side)] ? wheel_[index(side)].errorEstimate() : 0);
  }
}

/// Sets the rails, from cold, to where the wheel loads alone bend them; later to where they were in the last answer, in
/// proportion to the load, if that is a good part of the way allowed or the load is another.
void WheelsetBalance::setRails()
{
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    if (bends_ && !warm_)
    {
      const RailForce load{0, std::max(load_[k], 0.0), 0};
      setRail(side, deflectionInTrack(config_.rail_bending.table, load, config_.track.cant));
    }
    else if (support_.yields && loaded_[k])
    {
      const bool free = config_.wheelset.solve_height_and_roll;
      const double ratio = free ? std::max(load_[k], 0.0) / rail_[k].vertical_force : 1;
      if (std::abs(ratio - 1) > same_load || slipOver(side) > early_move)
      {
        setRail(side, toDeflection(ratio * toCoordinates(rail_[k].deflection)));
      }
    }
  }
}

/// From cold: where the straight rail would lift the wheel by its flange, sets the rail out until the wheel's tread
/// comes down on it, if its load can bend the rail so far. The flange then comes into contact beside the tread.
bool WheelsetBalance::letFlangesDown()
{
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    const RailDeflection straight = rail_[k].deflection;
    const double most = greatest_lateral_share * load_[k] * support_.compliance(0, 0);
    RailDeflection out = straight;
    while (touch_[k].found && touch_[k].contact.slope > flange_slope && out.lateral < straight.lateral + most)
    {
      out.lateral += flange_step;
      setRail(side, out);
      touch_[k] = wheel_[k].touch(toSide(side, {state_.y, 0, state_.yaw, roll_}));
    }
    if (!touch_[k].found || touch_[k].contact.slope > flange_slope)
    {
      setRail(side, straight);
    }
  }
  return touchBoth(roll_);
}

/// Sets out from the last answer: wheel loads, and descents to be expected under them.
bool WheelsetBalance::begin(const WheelsetState& state)
{
  state_ = state;
  const double transfer = 0.5 * state.torque_x / config_.wheelset.halfBase();
  load_ = {-0.5 * state.force_z - transfer, -0.5 * state.force_z + transfer};
  coupling_[0].reset();
  coupling_[1].reset();
  step_[0].reset();
  step_[1].reset();
  wheel_[0].begin();
  wheel_[1].begin();
  secant_.reset();
  if (!config_.wheelset.solve_height_and_roll)
  {
    roll_ = state.roll;
    return true;
  }
  setRails();
  if (!warm_ && !(touchBoth(roll_) && (!support_.yields || letFlangesDown())))
  {
    return false;
  }
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    descent_[k] = load_[k] > 0 ? wheel_[k].estimateDescent(touch_[k], load_[k]) + wheel_[k].yielded() : 0;
  }
  return true;
}

/// Places the wheelset for the next pass.
bool WheelsetBalance::place()
{
  if (!config_.wheelset.solve_height_and_roll)
  {
    return touchBoth(roll_);
  }
  if (secant_.takesOver())  // as long as planes and boxes do not fit, the roll stays
  {
    roll_ = secant_.roll();
    return touchBoth(roll_);
  }
  return findRoll();
}

ContactStatus WheelsetBalance::solve(const WheelsetState& state)
{
  const bool warm = warm_;
  const ContactStatus status = search(state);
  return isUsable(status) || !warm ? status : search(state);  // once more from cold
}

ContactStatus WheelsetBalance::search(const WheelsetState& state)
{
  if (!begin(state))
  {
    return failed(WheelStatus::beside_rail);
  }
  for (int pass = 0; pass < most_passes; ++pass)
  {
    const bool first = pass == 0 && !warm_;
    if (!place())
    {
      return failed(WheelStatus::beside_rail);
    }
    const WheelStatus status = solveWheels(first);
    if (status != WheelStatus::solved)
    {
      return failed(status);
    }
    const double roll_change = config_.wheelset.solve_height_and_roll ? heightDifference() / leverSum() : 0;
    const double difference = heightDifference();
    const double open = moveRails();
    const double slack = pass < strict_passes ? 1.0 : late_slack;
    const bool fits = layoutFits(slack);
    const bool level = std::abs(roll_change) < slack * roll_per_tolerance * config_.contact.tolerance;
    const bool settled = fits && level && open <= 1;
    if (first)
    {
      chooseGrids();
    }
    else if (settled && fineEnough())
    {
      finish(roll_change);
      return loaded_[0] && loaded_[1] ? ContactStatus::ok : ContactStatus::lift_off;
    }
    if (fits || !secant_.takesOver())
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
  reason_ = {};
  for (const Side side : sides)
  {
    wheel_[index(side)].learn();
    if (support_.yields && loaded_[index(side)])
    {
      rail_[index(side)].deflection = toDeflection(wheel_[index(side)].support());
    }
    choice_[index(side)].descend(error_[index(side)]);
  }
  if (!config_.wheelset.solve_height_and_roll)
  {
    height_ = state_.z;
    return;
  }
  roll_ += roll_change;
  const double left = (touch_[0].axle_height - descent_[0]) - lever(Side::left) * roll_change;
  const double right = (touch_[1].axle_height - descent_[1]) + lever(Side::right) * roll_change;
  height_ = 0.5 * (left + right);
}

double WheelsetBalance::lever(Side side) const
{
  return loaded_[index(side)] ? wheel_[index(side)].lever() : touch_[index(side)].lever;
}

double WheelsetBalance::leverSum() const
{
  return lever(Side::left) + lever(Side::right);
}
}  // namespace wheel_rail_contact
