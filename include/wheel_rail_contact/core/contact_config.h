// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// How the pressure is solved, and how finely.
struct ContactConfig
{
  NormalMethod method = NormalMethod::automatic;  ///< `auto`: the cheapest that meets the tolerance
  double tolerance = 0.01;  ///< wanted relative error of max pressure, area and approach [-]; in (0, 1)
  int cells_along = 0;      ///< grid given by hand; 0: from the tolerance
  int cells_across = 0;     ///< both or none
};

/// Checks every option against its rule.
/// @throw std::invalid_argument with the option, its value and the broken rule.
void validate(const ContactConfig& contact);
}  // namespace wheel_rail_contact::core
