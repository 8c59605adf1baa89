// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Measures of a patch, or of all patches of a wheel together.
struct ContactMeasures
{
  double max_pressure = 0;  ///< highest pressure [Pa]
  double area = 0;          ///< sum of the areas [m²]
  double force = 0;         ///< sum of the normal forces [N]

  /// Adds a patch to those of a wheel.
  void add(const ContactMeasures& patch)
  {
    max_pressure = std::max(max_pressure, patch.max_pressure);
    area += patch.area;
    force += patch.force;
  }
};

/// Relative error of a wheel [-], >= 0: the largest of those of its highest pressure, its area and its approach. The
/// area counts as a sum, and the approach as a mean weighted with the forces. A lower peak counts by what it may rise
/// above the highest one.
class WheelError
{
 public:
  explicit WheelError(const ContactMeasures& wheel) : wheel_(wheel) {}

  /// Adds a patch.
  void add(const ContactMeasures& patch, const ErrorEstimate& error);
  double largest() const;

 private:
  ContactMeasures wheel_;
  double pressure_ = 0, area_ = 0, approach_ = 0;
};
}  // namespace wheel_rail_contact::core
