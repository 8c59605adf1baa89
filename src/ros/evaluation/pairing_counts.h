// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace wheel_rail_contact
{
/// Reason why a sample was dropped.
enum class DropReason
{
  unmatched,     ///< another channel has no sample with a stamp within the slop
  duplicate,     ///< of the enclosing channel: the previous sample has the same stamp
  time_jump,     ///< time went back while the sample waited for a match, or the sample was out of order
  queue_full,    ///< newer samples of the channel filled the queue while the sample waited
  unstamped,     ///< the stamp is 0, which in ROS means that it is unknown
  not_enclosed,  ///< the enclosing channel has no samples before and after it within the longest gap
  unneeded       ///< of the enclosing channel: no sample of the other channels is next to it. Not a loss
};

/// Numbers of samples. At any time: received = paired + sum of dropped + waiting.
struct PairingCounts
{
  static constexpr std::size_t reasons = 7;  ///< number of constants of DropReason

  std::uint64_t received = 0;                    ///< all samples
  std::uint64_t paired = 0;                      ///< samples in complete sets
  std::array<std::uint64_t, reasons> dropped{};  ///< by DropReason
  std::uint64_t waiting = 0;                     ///< samples that wait for a match

  /// Number of samples dropped for a reason.
  std::uint64_t& operator[](DropReason reason) { return dropped[static_cast<std::size_t>(reason)]; }
  /// Number of samples dropped for a reason.
  std::uint64_t operator[](DropReason reason) const { return dropped[static_cast<std::size_t>(reason)]; }
};
}  // namespace wheel_rail_contact
