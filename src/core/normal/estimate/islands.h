// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "core/normal/measures/pressure_measures.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Columns of a grid that are loaded without a gap.
struct Island
{
  std::size_t patch = 0;                ///< patch of the problem
  Eigen::Index first = 0, last = 0;     ///< first and last loaded column
  Eigen::Index begin = 0, columns = 0;  ///< columns that belong to it: half of the empty ones on either side
};

/// Separate areas of the contact of a wheel. Several of them may lie on one grid; each is then a patch of its own in
/// problem() and solution(), whose grid is a part of the whole grid.
class Islands
{
 public:
  /// Finds the islands of a solution and measures their pressure.
  void find(const CurvedProblem& problem, const NormalSolution& solution);

  /// Removes the islands.
  void clear() { islands_.clear(); }

  const std::vector<Island>& islands() const { return islands_; }
  /// Problem and solution with a patch for each island.
  const NormalProblem& problem() const { return separate_ ? problem_ : *whole_problem_; }
  const NormalSolution& solution() const { return separate_ ? solution_ : *whole_solution_; }

 private:
  void cut(const Island& island, PatchGap& gap, PatchPressure& pressure);

  const CurvedProblem* whole_problem_ = nullptr;
  const NormalSolution* whole_solution_ = nullptr;
  bool separate_ = false;
  std::vector<Island> islands_;
  NormalProblem problem_;
  NormalSolution solution_;
  PressureMeasures measures_;
};

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
  double largest() const { return std::max({pressure_, area_, approach_}); }

 private:
  ContactMeasures wheel_;
  double pressure_ = 0, area_ = 0, approach_ = 0;
};
}  // namespace wheel_rail_contact::core
