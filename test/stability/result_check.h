// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/normal/operator/influence_operator.h"
#include "core/normal/operator/operator_cache.h"
#include "core/track/gap.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::stability
{
/// Looks at an answer from outside: does it solve the problem that was set? Nothing of the solution's own bookkeeping
/// is believed. Bodies are placed by the answer's pose and deflections, and its pressures are pushed through exact
/// coefficients again.
class ResultCheck
{
 public:
  /// Refers to `config`, which must outlive it.
  explicit ResultCheck(const ContactModelConfig& config);

  /// What is wrong with an answer; empty if nothing is.
  const std::vector<std::string>& faults(const WheelsetState& state, const WheelsetResult& result);

  /// Largest violation of the contact conditions in the last answer, over its patch's depth of overlap [-]; 0 where it
  /// does not count (methods that meet them only in the mean, refusals).
  double violation() const { return violation_; }

 private:
  void fault(const char* what, double value);
  void checkNumbers(const WheelsetResult& result);
  void checkPatch(const PatchResult& patch);
  void checkLoads(const WheelsetState& state, const WheelsetResult& result);
  void checkDeflection(const WheelsetState& state, const WheelsetResult& result, Side side);
  void checkConditions(const WheelsetResult& result);
  double patchViolation(const WheelsetResult& result, const PatchResult& patch);
  void displace(const PatchResult& patch);

  const ContactModelConfig& config_;
  PlacedRail undeflected_;
  OperatorCache operators_;
  InfluenceOperator::Workspace workspace_;
  std::vector<std::string> faults_;
  Eigen::ArrayXXd gap_, displacement_;
  std::vector<GapColumn> columns_;
  double violation_ = 0;
};
}  // namespace wheel_rail_contact::core::stability
