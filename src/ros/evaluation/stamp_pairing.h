// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace wheel_rail_contact
{
/// Reason why a sample was dropped.
enum class DropReason
{
  unmatched,  ///< another channel has no sample with a stamp within the slop
  duplicate,  ///< the previous sample of the channel has the same stamp
  time_jump,  ///< time went back while the sample waited for a match, or the sample was out of order
  queue_full  ///< newer samples of the channel filled the queue while the sample waited
};

/// Numbers of samples. At any time: received = paired + sum of dropped + waiting.
struct PairingCounts
{
  static constexpr std::size_t reasons = 4;  ///< number of constants of DropReason

  std::uint64_t received = 0;                    ///< all samples
  std::uint64_t paired = 0;                      ///< samples in complete sets
  std::array<std::uint64_t, reasons> dropped{};  ///< by DropReason
  std::uint64_t waiting = 0;                     ///< samples that wait for a match
};

/// Combines samples of several channels by their stamps into sets: one sample of each channel, all stamps within
/// `slop`.
///
/// *Matching.* The channels are merged like sorted lists. Whenever every channel has a waiting sample, the oldest
/// sample of each channel is compared. They form a set if their stamps are within the slop. Otherwise the oldest of
/// them is dropped as unmatched. The sets therefore depend only on the sequence of each channel, not on the order in
/// which the channels arrive, nor on a clock. A live node and a replay of its bag form the same sets. A slop below half
/// the sampling interval is unambiguous.
///
/// *Time that goes back.* The stamps of a channel must increase. If a stamp decreases, time has been set back: a bag
/// loops, or a simulation restarts. The channels do so one after the other.
/// - The new samples of a channel that has gone back are kept apart until all other channels have gone back, too.
///   Meanwhile the samples of the other channels are still matched with the old samples of this channel. No set is lost
///   at the end of a loop, and no set combines samples from before and after the jump.
/// - A channel whose stamps have not passed the stamp to which another channel went back is treated as gone back, too.
/// - If a channel passes the stamp at which it went back before all others have followed, it only had a sample out of
///   order.
///
/// message_filters is not suitable: it works only with subscribers and callbacks, its approximate policy depends on the
/// order of arrival, and none of its policies reports dropped messages.
///
/// @tparam Sample a type that is cheap to move, such as a pointer to a message
template <typename Sample>
class StampPairing
{
 public:
  /// @param channels number of channels, >= 1
  /// @param slop largest difference of the stamps of one set [s], >= 0
  /// @param capacity largest number of waiting samples of a channel, >= 1; if it is exceeded, the oldest is dropped
  StampPairing(std::size_t channels, double slop, std::size_t capacity)
      : channels_(channels), slop_(std::llround(slop * 1e9)), capacity_(capacity)
  {
  }

  /// Adds a sample. @return the set that it completes, ordered by channel, if any.
  std::optional<std::vector<Sample>> add(std::size_t channel, const ros::Time& stamp, Sample sample)
  {
    ++counts_.received;
    const auto time = static_cast<std::int64_t>(stamp.toNSec());
    Channel& own = channels_[channel];
    if (own.last && time == *own.last)
    {
      ++dropped(DropReason::duplicate);
      return std::nullopt;
    }
    if (own.last && time < *own.last)
    {
      goBack(own, time);
    }
    else if (own.gone_back && time > own.left_at)
    {
      rejoin(own);
    }
    own.last = time;
    Queue& queue = own.gone_back ? own.after : own.waiting;
    if (queue.size() == capacity_)
    {
      dropOldest(queue, DropReason::queue_full);
    }
    queue.push_back({time, counts_.received, std::move(sample)});
    ++counts_.waiting;
    return merge();
  }

  /// Drops all waiting samples as unmatched, at the end of a recording.
  void finish()
  {
    for (Channel& channel : channels_)
    {
      dropAll(channel.waiting, DropReason::unmatched);
      dropAll(channel.after, DropReason::unmatched);
    }
  }

  /// Numbers of samples received, paired, dropped and waiting.
  const PairingCounts& counts() const { return counts_; }

  /// True if no sample waits, and no channel has gone back in time before the others.
  bool isSettled() const
  {
    return counts_.waiting == 0 &&
           std::none_of(channels_.begin(), channels_.end(), [](const Channel& channel) { return channel.gone_back; });
  }

 private:
  struct Entry
  {
    std::int64_t stamp;     ///< [ns]
    std::uint64_t arrival;  ///< number among all samples received
    Sample sample;
  };
  using Queue = std::deque<Entry>;  ///< in order of increasing stamps

  struct Channel
  {
    Queue waiting;                     ///< samples that can be matched
    Queue after;                       ///< samples since it went back, until all other channels have gone back
    std::optional<std::int64_t> last;  ///< stamp of the last sample [ns]
    bool gone_back = false;            ///< it has gone back, and other channels have not
    std::int64_t left_at = 0;          ///< stamp before it went back [ns]
    std::uint64_t went_at = 0;         ///< arrival number of the sample with which it went back
  };

  std::uint64_t& dropped(DropReason reason) { return counts_.dropped[static_cast<std::size_t>(reason)]; }

  void dropOldest(Queue& queue, DropReason reason)
  {
    queue.pop_front();
    --counts_.waiting;
    ++dropped(reason);
  }

  void dropAll(Queue& queue, DropReason reason)
  {
    while (!queue.empty())
    {
      dropOldest(queue, reason);
    }
  }

  /// Handles a channel that goes back to a stamp [ns]. When all channels have gone back, the old samples are dropped.
  void goBack(Channel& own, std::int64_t stamp)
  {
    dropAll(own.after, DropReason::time_jump);
    const std::int64_t left_at = own.gone_back ? own.left_at : *own.last;
    for (Channel& channel : channels_)
    {
      if (!channel.gone_back && (&channel == &own || !channel.last || *channel.last <= stamp))
      {
        channel.gone_back = true;
        channel.left_at = left_at;
        channel.went_at = counts_.received;
      }
    }
    if (std::all_of(channels_.begin(), channels_.end(), [](const Channel& channel) { return channel.gone_back; }))
    {
      restart();
    }
  }

  /// Continues with the samples since the jump.
  void restart()
  {
    for (Channel& channel : channels_)
    {
      dropAll(channel.waiting, DropReason::time_jump);
      std::swap(channel.waiting, channel.after);
      channel.gone_back = false;
    }
  }

  /// Ends the separation of a channel that only had a sample out of order. Drops the samples of the other channels that
  /// arrived before that sample: if time was set back nevertheless, they belong to the time before.
  void rejoin(Channel& own)
  {
    dropAll(own.after, DropReason::time_jump);
    own.gone_back = false;
    for (Channel& other : channels_)
    {
      while (&other != &own && !other.waiting.empty() && other.waiting.front().arrival < own.went_at)
      {
        dropOldest(other.waiting, DropReason::time_jump);
      }
    }
  }

  /// Forms at most one set, because only the channel of the new sample can have been empty before.
  std::optional<std::vector<Sample>> merge()
  {
    const auto earlier = [](const Channel& a, const Channel& b)
    { return a.waiting.front().stamp < b.waiting.front().stamp; };
    const auto is_empty = [](const Channel& channel) { return channel.waiting.empty(); };
    while (std::none_of(channels_.begin(), channels_.end(), is_empty))
    {
      const auto ends = std::minmax_element(channels_.begin(), channels_.end(), earlier);
      if (ends.second->waiting.front().stamp - ends.first->waiting.front().stamp <= slop_)
      {
        return takeSet();
      }
      dropOldest(ends.first->waiting, DropReason::unmatched);
    }
    return std::nullopt;
  }

  std::vector<Sample> takeSet()
  {
    std::vector<Sample> set;
    for (Channel& channel : channels_)
    {
      set.push_back(std::move(channel.waiting.front().sample));
      channel.waiting.pop_front();
    }
    counts_.waiting -= channels_.size();
    counts_.paired += channels_.size();
    return set;
  }

  std::vector<Channel> channels_;
  std::int64_t slop_;  ///< [ns]
  std::size_t capacity_;
  PairingCounts counts_;
};
}  // namespace wheel_rail_contact
