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
/// Checks a result independently of the solver: the bodies are placed by the pose and the rail deflections of the
/// result, and the displacement is computed again from its pressures with exact influence coefficients.
class ResultCheck
{
 public:
  /// Keeps a reference to `config`, which must outlive this object.
  explicit ResultCheck(const ContactModelConfig& config);

  /// Faults of a result; empty if there are none. Valid until the next call.
  const std::vector<std::string>& faults(const WheelsetState& state, const WheelsetResult& result);

  /// Largest violation of the contact conditions in the last result, over the depth of overlap of its patch [-]; 0 for
  /// hertz and kik_piotrowski, which do not meet them in each cell, and for refusals.
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
