// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numeric>

#include "../usual_headers.h"
#include "ros/evaluation/stamp_pairing.h"

namespace wheel_rail_contact
{
using Sets = std::vector<std::vector<int>>;
using Stamps = std::vector<int>;  ///< [ms]

constexpr std::size_t large_capacity = 1000;

inline ros::Time at(int milliseconds)
{
  return ros::Time().fromNSec(static_cast<std::uint64_t>(milliseconds) * 1000000);
}

/// Pairing in which each sample is its own stamp [ms]. At its end, each received sample must be paired, waiting or
/// counted as dropped.
class Pairing : public StampPairing<int>
{
 public:
  explicit Pairing(std::size_t channels, double slop = 0, std::size_t capacity = large_capacity,
                   std::optional<double> longest_gap = {})
      : StampPairing<int>(channels, slop, capacity, longest_gap)
  {
  }
  ~Pairing()
  {
    EXPECT_EQ(counts().received,
              counts().paired + counts().waiting +
                  std::accumulate(counts().dropped.begin(), counts().dropped.end(), std::uint64_t{0}));
  }

  using StampPairing<int>::add;
  using StampPairing<int>::dropped;

  /// Adds samples of one channel. @return the sets that they complete; `sets` collects those of all calls
  Sets add(std::size_t channel, const Stamps& stamps)
  {
    const auto before = static_cast<std::ptrdiff_t>(sets.size());
    for (const int stamp : stamps)
    {
      for (const auto& set : StampPairing<int>::add(channel, at(stamp), stamp))
      {
        sets.push_back(set);
      }
    }
    return {sets.begin() + before, sets.end()};
  }
  /// Adds each stamp to the channels 0 and 1, before the next stamp.
  void addToBoth(const Stamps& stamps)
  {
    for (const int stamp : stamps)
    {
      add(0, {stamp});
      add(1, {stamp});
    }
  }

  std::uint64_t dropped(DropReason reason) const { return counts()[reason]; }
  Sets sets;
};
}  // namespace wheel_rail_contact
