// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Reason why a state is rejected, apart from its place on the track; empty if it is valid.
std::string_view faultOf(const WheelsetState& state, bool height_and_roll_given);

/// Reason to doubt the unit or the sign of loads; empty if there is none.
/// @param mean  mean wheel load, down positive [N]
std::string loadDoubt(double mean, const WheelsetConfig& wheelset);

/// Loads of many states.
class LoadTally
{
 public:
  /// @param lifts  a wheel carries no load
  void add(const WheelsetState& state, bool lifts);
  /// loadDoubt(), also if a wheel lifts in all states; empty for fewer than ten states, and if height and roll are
  /// given
  std::string doubt(const WheelsetConfig& wheelset) const;

 private:
  std::uint64_t count_ = 0, lifting_ = 0;
  double sum_ = 0;  ///< of force_z [N]
};

/// Reason why a height [m] is rejected that is `depth` [m] below that of first touch.
std::string tooDeep(double height, double depth);
}  // namespace wheel_rail_contact::core
