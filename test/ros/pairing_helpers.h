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

/// Arrivals, the sets that they form, and the samples that are in none, all as texts. Arrivals: letters of channels and
/// their stamps [ms], "a1,2 b1,2 ab3,4"; with two letters each stamp is added to both channels before the next one.
struct PairingCase
{
  const char* what;
  std::size_t channels;
  std::string arrivals, sets, lost = "";
  double slop = 0;  ///< [s]
  std::size_t capacity = large_capacity;
};

inline void expectPaired(const PairingCase& one, std::optional<double> longest_gap = {})
{
  SCOPED_TRACE(one.what);
  Pairing pairing(one.channels, one.slop, one.capacity, longest_gap);
  std::istringstream arrivals(one.arrivals);
  for (std::string word; arrivals >> word;)
  {
    const std::size_t letters = word.find_first_of("0123456789");
    std::istringstream stamps(word.substr(letters));
    for (std::string stamp; std::getline(stamps, stamp, ',');)
    {
      for (const char channel : word.substr(0, letters))
      {
        pairing.add(static_cast<std::size_t>(channel - 'a'), {std::stoi(stamp)});
      }
    }
  }
  std::string sets, lost;
  for (const std::vector<int>& set : pairing.sets)
  {
    sets += sets.empty() ? "" : " ";
    for (std::size_t i = 0; i < set.size(); ++i)
    {
      sets += (i == 0 ? "" : "/") + std::to_string(set[i]);
    }
  }
  constexpr const char* reasons[] = {"unmatched ", "duplicate ", "jump ",    "full ",
                                     "unstamped ", "outside ",   "unneeded "};
  for (std::size_t i = 0; i < PairingCounts::reasons; ++i)
  {
    const std::uint64_t count = pairing.counts().dropped[i];
    lost += count > 0 ? reasons[i] + std::to_string(count) + " " : "";
  }
  lost += pairing.isSettled() ? "" : "waiting " + std::to_string(pairing.counts().waiting) + " ";
  EXPECT_EQ(sets, one.sets);
  EXPECT_EQ(lost, one.lost + (one.lost.empty() ? "" : " "));
  pairing.finish();
  const PairingCounts& counts = pairing.counts();
  EXPECT_EQ(counts.waiting, 0U);
  EXPECT_EQ(counts.received, std::accumulate(counts.dropped.begin(), counts.dropped.end(), counts.paired));
}
}  // namespace wheel_rail_contact
