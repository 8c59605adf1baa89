// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/track/placement.h"
#include "paper/printed_figures.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::paper
{
/// A displacement of both rails, with the wheelset at the position of the case. Reference results are those of the
/// program CONTACT (Vollebregt and Kalker, version of July 2025).
struct Case
{
  std::string name;
  bool is_given;                     ///< the deflection is `crown`; otherwise it is computed
  RailDeflection crown;              ///< displacement of the rail crowns
  Figures printed;                   ///< results printed in the paper
  std::optional<Figures> reference;  ///< of CONTACT, at roll 0
};

/// The cases:
/// - "without": undeflected rails.
/// - "shifted": displaced outward as printed.
/// - "turned": displaced as printed and turned inward; this agrees with the printed results.
/// - "own_rail": the deflection of the rail of config/rails/paper.yaml under the printed lateral force and the wheel
///   load. It is not given.
std::vector<Case> paperCases();

/// Patches of the left wheel.
std::vector<PatchResult> leftPatches(const WheelsetResult& result);

/// Results of the left wheel, zero if it has no patches.
Figures leftFigures(const WheelsetResult& result);

/// A solved case: left wheel, which runs towards its flange, in side axes (which equal the track axes there).
struct Placement
{
  Case of;
  RailDeflection deflection;      ///< deflection of the left rail head, at its reference point
  double roll;                    ///< roll of the balanced wheelset [rad]
  Figures balanced;               ///< left wheel of the balanced wheelset
  std::vector<PlanePoint> rail;   ///< rail profile
  std::vector<PlanePoint> wheel;  ///< outline, lowered to first touch
  PlanePoint initial_contact;
  std::vector<PatchResult> patches;  ///< patches of the left wheel
};

/// Solves a case with the options of `config` (config/paper.yaml). Its compliance table is used for "own_rail" only.
/// @throw std::runtime_error if there is no solution
Placement solveCase(const ContactModelConfig& config, const Case& of);
}  // namespace wheel_rail_contact::core::paper
