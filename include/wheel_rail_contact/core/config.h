// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "wheel_rail_contact/core/creep.h"
#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/normal_solver.h"
#include "wheel_rail_contact/core/profile.h"
#include "wheel_rail_contact/core/rail_compliance.h"
#include "wheel_rail_contact/core/sides.h"
#include "wheel_rail_contact/core/stress.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Method and accuracy of the contact solution.
struct ContactConfig
{
  /// Default `automatic`: conjugate gradients on a grid for the tolerance, and on finer ones (at most three) while the
  /// estimated error of the wheel exceeds the tolerance.
  NormalMethod method = NormalMethod::automatic;
  /// Target relative error of highest pressure, area and approach [-], in (0, 1). It determines the grid and the
  /// residual at which the iteration stops.
  double tolerance = 0.01;
  /// Number of cells of a grid along the track: even, 4 to 256; 0: chosen from the tolerance (`automatic`: its first
  /// grid; other methods: for half the expected error). Set both numbers or neither. With both, every method uses this
  /// grid, and `automatic` is conjugate gradients on it.
  int cells_along = 0;
  int cells_across = 0;  ///< number of cells of a grid across the track; same rule as cells_along
  /// Also searches for other equilibria of each state, see WheelsetResult::near_branch. Takes about ten times as long.
  /// No effect if height and roll are given.
  bool check_branches = false;
  /// Also computes WheelsetResult::derivatives. Only with `automatic` and `conjugate_gradient`, without creep forces or
  /// with `linear` and `fastsim`, and where rails bend under the lateral force of the contact.
  bool derivatives = false;
};

/// Checks that every parameter is within its range.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const ContactConfig& contact);

/// All parameters of a WheelsetContact. All profiles must be set; all other members have usable defaults.
struct ContactModelConfig
{
  /// Profile of each wheel, from the flange to the field side on both sides: one profile for both wheels makes them
  /// mirror images. Must not be null. See profile_reader.h.
  Sides<std::shared_ptr<const Profile>> wheel_profile;
  /// Profile of each rail, from the gauge to the field side, upright (before it is turned by
  /// TrackConfig::rail_inclination). Must not be null, unless `rail_sections` is set, which replaces it.
  Sides<std::shared_ptr<const Profile>> rail_profile;
  /// Rail whose profile changes along the line, or of several parts; null: `rail_profile` everywhere. See
  /// WheelsetState::distance.
  Sides<std::shared_ptr<const RailSections>> rail_sections;
  Sides<Material> wheel_material;  ///< of each wheel; default: steel
  Sides<Material> rail_material;   ///< of each rail; default: steel
  TrackConfig track;               ///< position and inclination of the rails
  WheelsetConfig wheelset;         ///< dimensions of the wheelset; whether its height and roll are solved or given
  ContactConfig contact;           ///< method and tolerance of the contact solution
  StressConfig stress;             ///< stress beneath the patches; default: not computed
  RailBendingConfig rail_bending;  ///< deflection of the rails; default: rigid rails
  CreepConfig creep;               ///< friction of the contacts; default: none
};

/// Checks that all profiles are set, that every parameter is within its range, and that the wheelset fits the track
/// (checkFit()).
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const ContactModelConfig& config);

/// Checks that the wheelset fits the track. At y = 0 both flanges have a clearance, and both wheels touch the heads of
/// their rails near the running circles. The flange back of a profile is where wheelset/tape_circle places it.
/// @return dimensions that are possible, but rarely meant, one sentence each
/// @throw std::invalid_argument with the dimensions that contradict each other.
std::vector<std::string> checkFit(const ContactModelConfig& config);
}  // namespace wheel_rail_contact::core
