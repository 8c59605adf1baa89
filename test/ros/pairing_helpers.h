// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "ros/evaluation/stamp_pairing.h"

namespace wheel_rail_contact
{
/// Each sample is its own stamp [ms].
using Pairing = StampPairing<int>;
using Sets = std::vector<std::vector<int>>;

constexpr std::size_t large_capacity = 1000;

inline ros::Time at(int milliseconds)
{
  return ros::Time().fromNSec(static_cast<std::uint64_t>(milliseconds) * 1000000);
}

inline void add(Pairing& pairing, std::size_t channel, int milliseconds, Sets& sets)
{
  for (const auto& set : pairing.add(channel, at(milliseconds), milliseconds))
  {
    sets.push_back(set);
  }
}

inline std::uint64_t dropped(const Pairing& pairing, DropReason reason)
{
  return pairing.counts()[reason];
}

inline void expectNothingLost(const Pairing& pairing)
{
  const PairingCounts& counts = pairing.counts();
  EXPECT_EQ(counts.received, counts.paired + counts.waiting +
                                 std::accumulate(counts.dropped.begin(), counts.dropped.end(), std::uint64_t{0}));
}
}  // namespace wheel_rail_contact
