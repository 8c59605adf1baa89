// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "ros/evaluation/contact_evaluator.h"
#include "ros/evaluation/contact_input.h"
#include "ros/evaluation/hold_last.h"

namespace wheel_rail_contact
{
/// Evaluates the inputs of one wheelset in the live node, in their order. Its stages are InputPreparation,
/// ContactEvaluator and HoldLast. The replay distributes the same stages over threads (EvaluationPool). Not
/// thread-safe.
class EvaluationChain
{
 public:
  /// Keeps no reference to `config`.
  /// @param transforms,neighbours must outlive the chain
  EvaluationChain(const NodeConfig& config, const TransformStore& transforms, const NeighbourForces& neighbours);

  /// Waits until tf has the transform of the input, or until InputPreparation::transform_timeout after its arrival, and
  /// evaluates it. Because the deadline counts from the arrival, a transform that never arrives delays the results but
  /// does not reduce their rate.
  /// @param ended true: the wait ends at once
  ContactOutput evaluate(const ContactInput& input, const std::function<bool()>& ended);
  /// The next input is evaluated as the first one.
  void restart();

 private:
  void waitForTransform(const ContactInput& input, const std::function<bool()>& ended) const;

  InputPreparation preparation_;
  ContactEvaluator evaluator_;
  HoldLast hold_;
};
}  // namespace wheel_rail_contact
