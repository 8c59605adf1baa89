// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "ros/evaluation/contact_evaluator.h"

namespace wheel_rail_contact
{
/// Completes results that are not usable with the last usable result of the same wheelset.
///
/// - Height and roll, if they are solved, are those of the last usable result, unless the input was rejected before the
///   evaluation and has no pose.
/// - Forces, displacements of the rails and patches are those of the last usable result as well, for at most a given
///   number of results in a row (contact/hold_last). Such a result is held: its status is still that of the refusal.
///   The patches move along the track with the wheelset. A held result without a pose of its own has the whole pose and
///   the place on the line of the last usable result, and its patches do not move.
///
/// A simulation that adds up the patches does then not fall freely at a single refused state. The last usable result is
/// discarded after `memory` results, and where a stamp decreases. Up to then it is kept across resets of the warm start
/// (ResetRule). A result therefore depends only on the results since then, and node and replay agree.
class HoldLast
{
 public:
  /// Largest number of results in a row, none of them usable, that are completed.
  static constexpr int memory = longest_hold;

  /// Keeps no reference to `config`.
  explicit HoldLast(const NodeConfig& config)
      : longest_(config.hold_last), solves_height_(config.model.wheelset.solve_height_and_roll)
  {
  }

  /// Adds the next result of the wheelset. Changes it if it is not usable. A usable one needs its `result` only if
  /// results are held.
  void apply(ContactOutput& output);
  /// Discards the last usable result.
  void restart() { last_.reset(); }

 private:
  void hold(ContactOutput& output) const;

  int longest_;                        ///< see NodeConfig::hold_last
  bool solves_height_;                 ///< height and roll are solved, not given
  std::optional<ContactOutput> last_;  ///< last usable result; empty if there is none
  int since_ = 0;                      ///< number of results since the last usable one
  ros::Time stamp_;                    ///< of the last result
};
}  // namespace wheel_rail_contact
