// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "paper/forces.h"
#include "paper/stress_maxima.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core::paper
{
/// Assumed yield stress of the rail in tension [Pa]. The paper does not state the steel. EN 13674-1 requires a tensile
/// strength (880 MPa for R260), but no yield stress. 0.2 % proof stresses of R260 are about 480 to 500 MPa.
constexpr double assumed_yield = 480e6;

/// Stress in the rail beneath the left wheel, at the position of the case.
struct StressRow
{
  std::string rail;              ///< name of a Case, or of a compliance table
  double lateral_force;          ///< outward, the same on both rails [N]; 0 for a Case
  bool in_range;                 ///< the force is in the range of the table; true for a Case
  PatchResult patch;             ///< the only patch of the left wheel
  StressMaxima highest;          ///< in the rail
  std::array<double, 3> strain;  ///< principal strains at the highest von Mises stress [-], lengthening positive
  double load_factor;            ///< as PatchStress::load_factor, with assumed_yield
  double shakedown_limit;        ///< as PatchStress::shakedown_limit
};

/// The patch of a wheel that has one. The stress beneath several patches would include the pressure of each other one.
/// @param what  name of the case, for the message
/// @throw std::runtime_error if there is another number of patches
const PatchResult& onlyPatch(const std::vector<PatchResult>& left, const std::string& what);

/// Stress for the cases with a given displacement of the rails: "without", "shifted" and "turned".
/// @throw std::runtime_error if there is no solution, or the left wheel has several patches
std::vector<StressRow> stressOfCases(const ContactModelConfig& config);

/// Stress on rails that bend by a table, coupled, under each lateral force.
/// @throw as stressOfCases()
std::vector<StressRow> stressUnderForces(const ContactModelConfig& config, const NamedTable& table,
                                         const std::vector<double>& forces);
}  // namespace wheel_rail_contact::core::paper
