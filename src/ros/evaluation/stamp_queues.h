// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <array>
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

/// Samples of several channels that wait for a match, in the order of their stamps.
///
/// *Repeated stamps.* A channel may have several samples with one stamp, for example the evaluations of one time step
/// by a predictor-corrector method. They are numbered from 0: see Entry::repetition.
///
/// *Time that goes back.* If a stamp decreases, time has been set back: a bag loops, or a simulation restarts. The
/// channels do so one after the other.
/// - The new samples of a channel that has gone back are kept apart until all other channels have gone back, too.
///   Meanwhile the samples of the other channels are still matched with the old samples of this channel. No set is lost
///   at the end of a loop, and no set combines samples from before and after the jump.
/// - A channel whose stamps have not passed the stamp to which another channel went back is treated as gone back, too.
/// - If a channel passes the stamp at which it went back before all others have followed, it only had a sample out of
///   order.
///
/// @tparam Sample a type that is cheap to copy, such as a pointer to a message
template <typename Sample>
class StampQueues
{
 public:
  /// A sample that waits.
  struct Entry
  {
    std::int64_t stamp;        ///< [ns]
    std::uint64_t repetition;  ///< number of earlier samples of the channel with this stamp, since time went back
    std::uint64_t arrival;     ///< number among all samples received
    Sample sample;
    bool used;  ///< it is in a set, but may be needed for another one
  };
  using Queue = std::deque<Entry>;  ///< in order of stamps, and of repetitions

  /// A channel.
  struct Channel
  {
    Queue waiting;                     ///< samples that can be matched
    Queue after;                       ///< samples since it went back, until all other channels have gone back
    std::optional<std::int64_t> last;  ///< stamp of the last sample [ns]
    std::uint64_t repetitions = 0;     ///< number of samples with this stamp, since the channel went back
    bool gone_back = false;            ///< it has gone back, and other channels have not
    std::int64_t left_at = 0;          ///< stamp before it went back [ns]
    std::uint64_t went_at = 0;         ///< arrival number of the sample with which it went back
    std::uint64_t dropped = 0;         ///< samples dropped for any reason
  };

  /// @param channels number of channels, >= 1
  /// @param capacity largest number of waiting samples of a channel, >= 1; if it is exceeded, the oldest is dropped
  /// @param last_is_unique true: the last channel has one sample for each stamp; further ones are dropped as duplicates
  StampQueues(std::size_t channels, std::size_t capacity, bool last_is_unique)
      : channels_(channels), capacity_(capacity), last_is_unique_(last_is_unique)
  {
  }

  /// Adds a sample, or drops it.
  void add(std::size_t channel, const ros::Time& stamp, Sample sample)
  {
    ++counts_.received;
    const auto time = static_cast<std::int64_t>(stamp.toNSec());
    Channel& own = channels_[channel];
    const std::uint64_t repetition = own.last && time == *own.last ? own.repetitions : 0;
    const bool is_duplicate = last_is_unique_ && &own == &channels_.back() && repetition > 0;
    if (stamp.isZero() || is_duplicate)
    {
      ++own.dropped;
      ++counts_[is_duplicate ? DropReason::duplicate : DropReason::unstamped];
      return;
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
    own.repetitions = repetition + 1;
    Queue& queue = own.gone_back ? own.after : own.waiting;
    if (queue.size() == capacity_)
    {
      dropOldest(own, queue, DropReason::queue_full);
    }
    queue.push_back({time, repetition, counts_.received, std::move(sample), false});
    ++counts_.waiting;
  }

  /// Removes the oldest waiting sample of a channel as part of a set.
  Sample take(Channel& channel)
  {
    Sample sample = std::move(channel.waiting.front().sample);
    channel.waiting.pop_front();
    --counts_.waiting;
    ++counts_.paired;
    return sample;
  }

  /// Drops the oldest waiting sample of a channel. A sample that is in a set is counted as paired instead.
  void drop(Channel& channel, DropReason reason) { dropOldest(channel, channel.waiting, reason); }

  /// Drops all samples of a channel, in the same way.
  void dropAll(Channel& channel, DropReason reason)
  {
    dropAll(channel, channel.waiting, reason);
    dropAll(channel, channel.after, reason);
  }

  /// Channels in their order.
  std::vector<Channel>& channels() { return channels_; }
  /// Channels in their order.
  const std::vector<Channel>& channels() const { return channels_; }
  /// Numbers of samples received, paired, dropped and waiting.
  const PairingCounts& counts() const { return counts_; }

 private:
  void dropOldest(Channel& channel, Queue& queue, DropReason reason)
  {
    const bool used = queue.front().used;
    queue.pop_front();
    --counts_.waiting;
    ++(used ? counts_.paired : counts_[reason]);
    channel.dropped += used ? 0U : 1U;
  }

  void dropAll(Channel& channel, Queue& queue, DropReason reason)
  {
    while (!queue.empty())
    {
      dropOldest(channel, queue, reason);
    }
  }

  /// Handles a channel that goes back to a stamp [ns]. When all channels have gone back, the old samples are dropped.
  void goBack(Channel& own, std::int64_t stamp)
  {
    dropAll(own, own.after, DropReason::time_jump);
    const std::int64_t left_at = own.gone_back ? own.left_at : *own.last;
    for (Channel& channel : channels_)
    {
      if (!channel.gone_back && (&channel == &own || !channel.last || *channel.last <= stamp))
      {
        channel.gone_back = true;
        channel.repetitions = 0;
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
      dropAll(channel, channel.waiting, DropReason::time_jump);
      std::swap(channel.waiting, channel.after);
      channel.gone_back = false;
    }
  }

  /// Ends the separation of a channel that only had a sample out of order. Drops the samples of the other channels that
  /// arrived before that sample: if time was set back nevertheless, they belong to the time before.
  void rejoin(Channel& own)
  {
    dropAll(own, own.after, DropReason::time_jump);
    own.gone_back = false;
    for (Channel& other : channels_)
    {
      while (&other != &own && !other.waiting.empty() && other.waiting.front().arrival < own.went_at)
      {
        dropOldest(other, other.waiting, DropReason::time_jump);
      }
    }
  }

  std::vector<Channel> channels_;
  std::size_t capacity_;
  bool last_is_unique_;
  PairingCounts counts_;
};
}  // namespace wheel_rail_contact
