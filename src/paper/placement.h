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
/// A displacement of both rails under the wheelset at the case's position.
struct Case
{
  std::string name;
  RailDeflection crown;              ///< displacement of the rails' crowns
  Figures printed;                   ///< what the paper prints
  std::optional<Figures> reference;  ///< of the program CONTACT at roll 0 (Vollebregt and Kalker, version of July 2025)
};

/// "without": undeflected. "shifted": displaced outward as printed. "turned": the same and turned inward, which meets
/// the printed figures. "own_rail": as the rail of config/rails/paper.yaml gives way under the printed lateral force
/// and the wheel load; here without the displacement, which has to be found.
std::vector<Case> paperCases();

/// Of the left wheel's patches in an answer; zero where there are none.
Figures leftFigures(const WheelsetResult& result);

/// A case as placed and solved; the left wheel, at the flange, in side axes (which are those of the track there).
struct Placement
{
  Case of;
  RailDeflection deflection;      ///< of the left rail's head, at its reference point
  double roll;                    ///< of the balanced wheelset [rad]
  Figures balanced;               ///< of the left wheel, wheelset balanced
  std::vector<PlanePoint> rail;   ///< profile
  std::vector<PlanePoint> wheel;  ///< outline, lowered to first touch
  PlanePoint initial_contact;
  std::vector<PatchResult> patches;  ///< of the left wheel
};

/// Solves a case with the options of `config` (config/paper.yaml): its compliance table is used for "own_rail" only.
/// @throw std::runtime_error if there is no answer.
Placement solveCase(const ContactModelConfig& config, const Case& of);
}  // namespace wheel_rail_contact::core::paper
