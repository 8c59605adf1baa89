// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/creep/creep_strips.h"
#include "wheel_rail_contact/core/creep.h"

namespace wheel_rail_contact::core
{
/// Direction of travel: 1 forward, -1 backward. A patch that rolls backward is one that rolls forward in axes turned by
/// half a turn about z.
inline double directionOf(const CreepProblem& problem)
{
  return problem.speed < 0 ? -1 : 1;
}

/// True if grid and pressure fit, and the pressure is finite, nowhere negative and not zero everywhere.
bool hasPressure(const CreepProblem& problem);

/// Spin over that which just saturates a patch, phi 1.5 c³ G / (mu N) [-]: large above about 1.
/// @param spin  over the coefficient of friction: phi / mu [1/m]
double reducedSpin(const CreepProblem& problem, double spin);

/// Linear theory with saturation: Fx = -c² G C11 x, Fy = -c² G C22 y - c³ G C23 spin, Mz = c³ G C23 y - c⁴ G C33 spin
/// with c² = a b (Kalker 1967; 1990, eq. 2.28). When the wheel rolls backward, C23 has the other sign. Shen, Hedrick
/// and Elkins (1983): force and moment are scaled so that the resultant of Fx and Fy becomes mu N (e - e²/3 + e³/27),
/// where e mu N is its linear value, and mu N for e >= 3 (Vermeulen and Johnson 1964).
class LinearLaw : public CreepSolver
{
  CreepStatus fill(const CreepProblem& problem, bool warm, CreepSolution& solution) override;
};

/// FASTSIM (Kalker 1982) on the columns of the patch: each is a strip whose bound is a parabola along the track with
/// the normal force of the strip. Length, place and compliance of a strip are those of CreepStrips.
class Fastsim : public CreepSolver
{
  CreepStatus fill(const CreepProblem& problem, bool warm, CreepSolution& solution) override;

  CreepStrips strips_;
};
}  // namespace wheel_rail_contact::core
