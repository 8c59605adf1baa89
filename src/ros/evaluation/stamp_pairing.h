// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "ros/evaluation/stamp_queues.h"

namespace wheel_rail_contact
{
/// Combines samples of several channels by their stamps into sets: one sample of each channel, all stamps within
/// `slop`.
///
/// *Matching.* The channels are merged like sorted lists. Whenever every channel has a waiting sample, the oldest
/// sample of each channel is compared. They form a set if their stamps are within the slop and their repetitions are
/// equal. Otherwise the oldest of them is dropped as unmatched. The sets therefore depend only on the sequence of each
/// channel, not on the order in which the channels arrive, nor on a clock. A live node and a replay of its bag form the
/// same sets. A slop below half the sampling interval is unambiguous.
///
/// *Repeated stamps.* A channel may have several samples with one stamp. The first ones of all channels form a set, the
/// second ones another one, and so on. A repeated sample without a match in another channel is dropped as unmatched;
/// it does not shift the sets of later stamps.
///
/// *Enclosing.* If the last channel encloses the others, it is not matched. A set then contains two of its samples: the
/// last one up to the stamp of the first channel, and the next one, or twice the same one if its stamp is equal. Their
/// stamps differ by at most the longest gap. A set waits for the next sample of this channel; one without both samples
/// is dropped as not enclosed. These sets, too, depend only on the sequence of each channel. The enclosing channel is a
/// function of time: of several samples with one stamp, only the first one is used, also for repeated samples of the
/// other channels. The others are dropped as duplicates.
///
/// *Time that goes back.* See StampQueues.
///
/// message_filters is not suitable: it works only with subscribers and callbacks, its approximate policy depends on the
/// order of arrival, none of its policies reports dropped messages, and none encloses.
///
/// @tparam Sample a type that is cheap to copy, such as a pointer to a message
template <typename Sample>
class StampPairing
{
 public:
  using Set = std::vector<Sample>;  ///< by channel; of an enclosing channel two samples

  /// @param channels number of channels, >= 1
  /// @param slop largest difference of the stamps of the matched samples of a set [s], >= 0
  /// @param capacity largest number of waiting samples of a channel, >= 1; if it is exceeded, the oldest is dropped
  /// @param longest_gap the last channel encloses the others, with at most this difference of its stamps [s]; there are
  /// then at least two channels. Empty: all channels are matched
  StampPairing(std::size_t channels, double slop, std::size_t capacity, std::optional<double> longest_gap = {})
      : queues_(channels, capacity, longest_gap.has_value()),
        slop_(nanoseconds(slop)),
        matched_(static_cast<std::ptrdiff_t>(channels) - (longest_gap ? 1 : 0)),
        longest_gap_(nanoseconds(longest_gap.value_or(0)))
  {
  }

  /// Adds a sample. @return the sets that it completes, in order; without an enclosing channel at most one.
  std::vector<Set> add(std::size_t channel, const ros::Time& stamp, Sample sample)
  {
    queues_.add(channel, stamp, std::move(sample));
    return merge(false);
  }

  /// Drops all waiting samples, at the end of a recording.
  void finish()
  {
    merge(true);
    for (std::size_t i = 0; i < queues_.channels().size(); ++i)
    {
      queues_.dropAll(queues_.channels()[i],
                      static_cast<std::ptrdiff_t>(i) < matched_ ? DropReason::unmatched : DropReason::unneeded);
    }
  }

  /// Numbers of samples received, paired, dropped and waiting.
  const PairingCounts& counts() const { return queues_.counts(); }
  /// Number of samples of a channel that were dropped.
  std::uint64_t dropped(std::size_t channel) const { return queues_.channels()[channel].dropped; }

  /// True if the following sets depend only on the following samples and, with an enclosing channel, on the samples of
  /// the last set: no sample waits for a match, and no channel has gone back in time before the others.
  bool isSettled() const
  {
    const auto& channels = queues_.channels();
    return std::none_of(channels.begin(), channels.end(), [](const Channel& channel) { return channel.gone_back; }) &&
           std::all_of(channels.begin(), channels.begin() + matched_, isEmpty) &&
           (!isEnclosing() || (!isEmpty(channels.back()) && channels.back().waiting.front().used));
  }

 private:
  using Channel = typename StampQueues<Sample>::Channel;
  using Queue = typename StampQueues<Sample>::Queue;

  static std::int64_t nanoseconds(double seconds) { return std::llround(seconds * 1e9); }
  static bool isEmpty(const Channel& channel) { return channel.waiting.empty(); }
  bool isEnclosing() const { return static_cast<std::size_t>(matched_) < queues_.channels().size(); }

  /// True if the oldest sample of a channel is older than that of the other one.
  static bool isOlder(const Channel& channel, const Channel& other)
  {
    const auto &a = channel.waiting.front(), &b = other.waiting.front();
    return std::tie(a.stamp, a.repetition) < std::tie(b.stamp, b.repetition);
  }
  /// True if the oldest samples of both channels may be in one set.
  /// @param oldest channel whose sample is not newer than that of the other one
  bool match(const Channel& oldest, const Channel& other) const
  {
    const auto &a = oldest.waiting.front(), &b = other.waiting.front();
    return a.repetition == b.repetition && b.stamp - a.stamp <= slop_;
  }

  /// @param ended true: no further samples follow
  std::vector<Set> merge(bool ended)
  {
    const auto first = queues_.channels().begin(), end = first + matched_;
    std::vector<Set> sets;
    while (std::none_of(first, end, isEmpty))
    {
      const auto oldest = std::min_element(first, end, isOlder);
      if (!std::all_of(first, end, [this, &oldest](const Channel& other) { return match(*oldest, other); }))
      {
        queues_.drop(*oldest, DropReason::unmatched);
        continue;
      }
      if (isEnclosing() && !ended && !reaches(first->waiting.front().stamp))
      {
        break;
      }
      if (!isEnclosing() || encloses(first->waiting.front().stamp))
      {
        sets.push_back(takeSet());
      }
      else
      {
        std::for_each(first, end, [this](Channel& channel) { queues_.drop(channel, DropReason::not_enclosed); });
      }
    }
    return sets;
  }

  /// True if the enclosing channel has a sample at or after a stamp [ns].
  bool reaches(std::int64_t stamp) const
  {
    const Queue& queue = queues_.channels().back().waiting;
    return !queue.empty() && queue.back().stamp >= stamp;
  }

  /// Drops the samples of the enclosing channel before the last one up to a stamp [ns].
  /// @return true if this one and the next one enclose the stamp
  bool encloses(std::int64_t stamp)
  {
    Channel& channel = queues_.channels().back();
    const Queue& queue = channel.waiting;
    while (queue.size() > 1 && queue[1].stamp <= stamp)
    {
      queues_.drop(channel, DropReason::unneeded);
    }
    return reaches(stamp) &&
           (queue[0].stamp == stamp || (queue[0].stamp < stamp && queue[1].stamp - queue[0].stamp <= longest_gap_));
  }

  Set takeSet()
  {
    Set set;
    std::vector<Channel>& channels = queues_.channels();
    const std::int64_t stamp = channels.front().waiting.front().stamp;
    std::for_each(channels.begin(), channels.begin() + matched_,
                  [&](Channel& channel) { set.push_back(queues_.take(channel)); });
    if (isEnclosing())
    {
      Queue& queue = channels.back().waiting;
      for (auto* const entry : {&queue[0], &queue[queue[0].stamp == stamp ? 0 : 1]})
      {
        entry->used = true;
        set.push_back(entry->sample);
      }
    }
    return set;
  }

  StampQueues<Sample> queues_;
  std::int64_t slop_;         ///< [ns]
  std::ptrdiff_t matched_;    ///< number of the channels that are matched; these are the first ones
  std::int64_t longest_gap_;  ///< [ns]
};
}  // namespace wheel_rail_contact
