// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/wheelset_contact.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/balance/grid_levels.h"
#include "core/balance/patch_result.h"
#include "core/balance/wheelset_balance.h"
#include "core/constants.h"
#include "core/friction/contact_friction.h"
#include "core/friction/wheelset_derivatives.h"
#include "core/state_check.h"
#include "core/stress_beneath.h"
#include "core/text/formatted.h"
#include "core/wheel_wrench.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double lateral_limit = 0.1;        ///< largest accepted lateral position from the track centre [m]
constexpr double stiffness_residual = 1e-3;  ///< of stiffness(), see ContactTangent
constexpr double other_roll = 5e-3;          ///< distance of the starts that search for other equilibria [rad]
constexpr double other_force = 0.05;         ///< difference of the forces of another equilibrium [-]

/// Places along the line for which a rail is known.
struct PlaceRange
{
  const char* name;
  double begin, end;    ///< [m]
  bool is_gap = false;  ///< unknown between these places, instead of beyond them

  /// Reason why a place [m] is rejected.
  std::string reason(double x) const
  {
    return formatted(is_gap ? "the wheelset at %.10g m is in a gap of %s, from %.10g to %.10g m (longest_gap)"
                            : "the wheelset at %.10g m is outside %s, from %.10g to %.10g m",
                     x, name, begin, end);
  }
};
}  // namespace

class WheelsetContact::Calculation
{
 public:
  explicit Calculation(ContactModelConfig config)
      : config_(checked(std::move(config))),
        levels_(config_),
        balance_(config_, levels_),
        friction_(config_),
        stress_(config_)
  {
    if (config_.contact.derivatives)
    {
      derivatives_.emplace(config_);
    }
    if (config_.contact.check_branches && config_.wheelset.solve_height_and_roll)
    {
      other_.emplace(config_, levels_);
    }
  }

  const WheelsetResult& evaluate(const WheelsetState& state)
  {
    const bool given = !config_.wheelset.solve_height_and_roll;
    result_.x = state.x;
    result_.distance = state.distance;
    result_.y = state.y;
    result_.yaw = state.yaw;
    result_.z = given ? state.z : config_.wheelset.meanRadius();
    result_.roll = given ? state.roll : 0;
    solve(state);
    fillResult();
    if (isUsable(result_.status))
    {
      if (friction_.acts(state))
      {
        friction_.addTo(balance_, result_);
      }
      result_.near_branch = other_ && hasOther(friction_.withFriction(state));
      result_.above_tolerance = result_.above_tolerance || friction_.isOpen();
      result_.reason = remark(state);
      addImplausibleForces();
      addDerivatives(friction_.acts(state));
    }
    return result_;
  }

  Eigen::Matrix3d stiffness(Side side)
  {
    if (!isUsable(result_.status) || !balance_.wheel(side).loaded())
    {
      return Eigen::Matrix3d::Zero();
    }
    const MotionMatrix all = balance_.wheel(side).contact().stiffness(stiffness_residual);
    // The wheel moving outward opens the gap as the rail moving inward does.
    const double sign = sideSign(side);
    Eigen::Matrix<double, motions, 3> track = Eigen::Matrix<double, motions, 3>::Zero();
    track(rail_lateral, 0) = -sign;
    track(wheel_up, 1) = 1;
    track(wheel_roll, 2) = sign;
    return track.transpose() * all * track;
  }

  void reset()
  {
    balance_.reset();
    friction_.reset();
  }
  const ContactModelConfig& config() const { return config_; }

 private:
  /// Fills what follows from the balance.
  void fillResult()
  {
    result_.rail = {};
    result_.wheel = {};
    result_.rail_wrench = Wrench();
    result_.speed = result_.rotation = 0;
    result_.implausible_force = false;
    result_.above_tolerance = result_.near_branch = result_.points_missing = false;
    result_.derivatives = {};
    is_noisy_ = false;
    patch_count_ = 0;
    if (isUsable(result_.status))
    {
      result_.rail = {balance_.wheel(Side::left).rail(), balance_.wheel(Side::right).rail()};
      result_.z = balance_.height();
      result_.roll = balance_.roll();
      addPatches(Side::left);
      addPatches(Side::right);
      sumForces(Side::left);
      sumForces(Side::right);
    }
    result_.patches.resize(patch_count_);
  }

  void solve(const WheelsetState& state)
  {
    if (const std::string_view reason = faultOf(state, !config_.wheelset.solve_height_and_roll); !reason.empty())
    {
      result_.status = ContactStatus::invalid_input;
      result_.reason = reason;
      return;
    }
    if (const std::optional<PlaceRange> range = exceededRange(state.distance))
    {
      result_.status = ContactStatus::outside_line;
      result_.reason = range->reason(state.distance);
      return;
    }
    if (!(std::abs(state.y - trackCentre(state)) <= lateral_limit))
    {
      result_.status = ContactStatus::invalid_input;
      result_.reason = "lateral position is beyond 0.1 m from the track centre";
      return;
    }
    if (friction_.acts(state))
    {
      result_.status = friction_.solve(state, balance_);
      result_.reason = friction_.reason();
    }
    else
    {
      friction_.reset();
      friction_.bear(balance_);
      result_.status = balance_.solve(state);
      result_.reason = balance_.reason();
    }
    if (result_.status == ContactStatus::too_deep)
    {
      result_.reason = tooDeep(state.z, balance_.depth());
    }
  }

  /// Lateral position of the track centre between the displaced rails, track frame [m].
  double trackCentre(const WheelsetState& state) const
  {
    const TrackLine* line = config_.track.line.get();
    return middleOf(state.rail_displacement) + (line != nullptr ? middleOf(line->at(state.distance).rail) : 0);
  }

  /// The range that a place [m] is outside of; empty if it is on the line.
  std::optional<PlaceRange> exceededRange(double x) const
  {
    const TrackLine* line = config_.track.line.get();
    if (line != nullptr && !line->contains(x))
    {
      const bool is_inside = x > line->begin() && x < line->end();
      const std::array<double, 2> ends =
          is_inside ? *line->gapAt(x) : std::array<double, 2>{line->begin(), line->end()};
      return PlaceRange{"track/line", ends[0], ends[1], is_inside};
    }
    for (const Side side : sides)
    {
      const RailSections* sections = config_.rail_sections[side].get();
      if (sections != nullptr && !sections->contains(x))
      {
        const RailSeries& running = sections->parts().front();
        const bool everywhere = running.size() == 1;  // the place is not a number, or infinite
        return PlaceRange{side == Side::left ? "the sections of the left rail" : "the sections of the right rail",
                          everywhere ? -infinity : running.front().x, everywhere ? infinity : running.back().x};
      }
    }
    return std::nullopt;
  }

  static ContactModelConfig checked(ContactModelConfig config)
  {
    validate(config);
    return config;
  }

  /// True if another equilibrium is found from a cold start or from a start at another roll.
  /// @param state  with the friction on the wheels
  bool hasOther(const WheelsetState& state)
  {
    friction_.bear(*other_);
    for (const double roll : {0.0, balance_.roll() - other_roll, balance_.roll() + other_roll})
    {
      other_->reset(roll);
      if (isUsable(other_->solve(state)) && (differs(Side::left) || differs(Side::right)))
      {
        return true;
      }
    }
    return false;
  }

  bool differs(Side side) const
  {
    const RailResult one = balance_.wheel(side).rail(), two = other_->wheel(side).rail();
    const double force = std::hypot(one.lateral_force, one.vertical_force);
    return std::hypot(two.lateral_force - one.lateral_force, two.vertical_force - one.vertical_force) >
           other_force * force;
  }

  /// Remark on a usable result: a wheel that carries no load, missing points of a profile, another equilibrium, or an
  /// error estimate above the tolerance; otherwise empty.
  std::string_view remark(const WheelsetState& state) const
  {
    const bool left = balance_.wheel(Side::left).loaded(), right = balance_.wheel(Side::right).loaded();
    if (left && right)
    {
      return result_.points_missing ? "points of a profile are missing at a contact: its shape is not known there"
             : result_.near_branch  ? "another equilibrium exists: the result depends on the states before"
             : friction_.isOpen()
                 ? "friction and the balance of the normal forces agree within 2 %, but not within the tolerance"
             : !balance_.wheel(Side::left).isSmooth()
                 ? "the left rail has an edge along the track: its highest place carries the wheel"
             : !balance_.wheel(Side::right).isSmooth()
                 ? "the right rail has an edge along the track: its highest place carries the wheel"
             : !balance_.wheel(Side::left).rim().smooth
                 ? "the left wheel has an edge along its circumference: its lowest place carries it"
             : !balance_.wheel(Side::right).rim().smooth
                 ? "the right wheel has an edge along its circumference: its lowest place carries it"
             : result_.above_tolerance ? "the estimated error of a wheel is above contact/tolerance"
             : is_noisy_ ? "the noise of the points of a profile leaves the highest pressure open by more than "
                           "contact/tolerance"
             : friction_.isSet() && !friction_.acts(state) ? "no creep forces: the speed is below 0.01 m/s"
                                                           : "";
    }
    if (!left && !right)
    {
      return "neither wheel carries a load";
    }
    if (balance_.lifts())
    {
      return left ? "the right wheel lifts: the moments about the axle centre are not in balance"
                  : "the left wheel lifts: the moments about the axle centre are not in balance";
    }
    return left ? "the right wheel carries no load" : "the left wheel carries no load";
  }

  /// Adds forces beyond the plausible bound to the reason.
  void addImplausibleForces()
  {
    for (const Side side : sides)
    {
      const WheelForces& wheel = result_.wheel[side];
      const double force = std::hypot(wheel.vertical, wheel.lateral);
      if (force > largest_force_)
      {
        result_.implausible_force = true;
        result_.reason += (result_.reason.empty() ? "" : "; ") +
                          formatted("implausible force of the %s wheel: %.3g MN, above %.3g MN", nameOf(side),
                                    1e-6 * force, 1e-6 * largest_force_);
      }
    }
  }

  /// @param rubs  there are creep forces
  void addDerivatives(bool rubs)
  {
    if (!derivatives_)
    {
      return;
    }
    derivatives_->clear(result_.derivatives);
    const std::string_view fault =
        result_.near_branch  ? "no derivatives: another equilibrium exists"
        : friction_.isOpen() ? "no derivatives: friction jumps"
                             : derivatives_->find(balance_, rubs ? &friction_.rolling() : nullptr, result_.derivatives);
    result_.reason += result_.reason.empty() || fault.empty() ? "" : "; ";
    result_.reason += fault;
  }

  void addPatches(Side side)
  {
    const std::size_t count = balance_.wheel(side).loaded() ? balance_.islands(side).islands().size() : 0;
    for (std::size_t k = 0; k < count; ++k)
    {
      result_.patches.resize(std::max(result_.patches.size(), patch_count_ + 1));
      PatchResult& patch = result_.patches[patch_count_++];
      fillPatch(side, balance_, k, patch);
      const ShapeEffect shape = shapeEffect(side, balance_, *config_.wheel_profile[side], k, patch.max_pressure);
      patch.error_estimate = std::hypot(patch.error_estimate, shape.max_pressure);
      result_.points_missing = result_.points_missing || shape.missing;
      is_noisy_ = is_noisy_ || shape.max_pressure > config_.contact.tolerance;
      patch.method = levels_.solver().name();
      patch.creep = {};
      stress_.fill(side, balance_, k, patch);
    }
    result_.above_tolerance = result_.above_tolerance || balance_.wheelError(side) > config_.contact.tolerance;
  }

  /// Adds the forces of the patches of a wheel to those of the wheel and to the wrench on the axle centre.
  void sumForces(Side side)
  {
    WheelForces& wheel = result_.wheel[side];
    Wrench wrench;
    for (std::size_t k = 0; k < patch_count_; ++k)
    {
      const PatchResult& patch = result_.patches[k];
      if (patch.side == side)
      {
        wheel.vertical += patch.vertical_force;
        wheel.lateral += patch.lateral_force;
        const Eigen::Vector3d force = forceOnWheel(patch);
        const double y = patch.pose.y - result_.y, z = patch.pose.z - result_.z;
        wrench.force += force;
        wrench.moment +=
            Eigen::Vector3d(0, z * force.x() - patch.pose.x * force.z(), patch.pose.x * force.y() - y * force.x());
      }
    }
    wrench.moment.x() = sideSign(side) * balance_.wheel(side).moment();
    result_.rail_wrench += wrench;
  }

  ContactModelConfig config_;
  GridLevels levels_;
  WheelsetBalance balance_;
  double largest_force_ = plausible_force * std::pow(modelScale(config_.track, config_.wheelset), 2);  ///< [N]
  ContactFriction friction_;
  StressBeneath stress_;
  std::optional<WheelsetBalance> other_;  ///< searches for other equilibria
  std::optional<WheelsetDerivatives> derivatives_;
  WheelsetResult result_;
  std::size_t patch_count_ = 0;
  bool is_noisy_ = false;  ///< the noise of a profile opens a pressure by more than the tolerance
};

WheelsetContact::WheelsetContact(ContactModelConfig config)
    : calculation_(std::make_unique<Calculation>(std::move(config)))
{
}

WheelsetContact::~WheelsetContact() = default;
WheelsetContact::WheelsetContact(WheelsetContact&&) noexcept = default;
WheelsetContact& WheelsetContact::operator=(WheelsetContact&&) noexcept = default;

const WheelsetResult& WheelsetContact::evaluate(const WheelsetState& state)
{
  return calculation_->evaluate(state);
}

Eigen::Matrix3d WheelsetContact::stiffness(Side side)
{
  return calculation_->stiffness(side);
}

void WheelsetContact::reset()
{
  calculation_->reset();
}

const ContactModelConfig& WheelsetContact::config() const
{
  return calculation_->config();
}
}  // namespace wheel_rail_contact::core
