// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
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
  /// Smallest difference of the stamps of an unmatched sample and of another channel, above the slop [ns].
  std::int64_t smallest_miss = std::numeric_limits<std::int64_t>::max();

  /// Number of samples dropped for a reason.
  std::uint64_t& operator[](DropReason reason) { return dropped[static_cast<std::size_t>(reason)]; }
  /// Number of samples dropped for a reason.
  std::uint64_t operator[](DropReason reason) const { return dropped[static_cast<std::size_t>(reason)]; }
};

/// Stamps over which a channel went back: from `high` to `low` [ns]. They are equal if a stamp is repeated.
struct StepBack
{
  std::int64_t low, high;
  std::uint64_t arrival;  ///< of the sample at `low`
  std::int64_t interval;  ///< sampling interval before it [ns]

  /// True if two channels may have gone back at the same time: the ends differ by less than a sampling interval.
  bool agreesWith(const StepBack& other, std::int64_t slop) const
  {
    const std::int64_t largest = std::max(interval, other.interval) + slop;
    return std::abs(low - other.low) < largest && std::abs(high - other.high) < largest;
  }
  bool covers(std::int64_t stamp, std::int64_t slop = 0) const { return low - slop <= stamp && stamp <= high; }
};

/// Samples of one channel that wait for a match, in the order of arrival, and its steps back in time.
template <typename Sample>
struct StampChannel
{
  /// A sample that waits.
  struct Entry
  {
    std::int64_t stamp;     ///< [ns]
    std::int64_t previous;  ///< stamp of the sample before it [ns], or `none`
    std::uint64_t arrival;  ///< number among all samples received
    std::int64_t interval;  ///< last increase of the stamps of the channel [ns]
    Sample sample;
    bool used;  ///< it is in a set, but may be needed for another one

    bool goesBack() const { return stamp <= previous; }
    StepBack step() const { return {stamp, previous, arrival, interval}; }
  };
  using Queue = std::deque<Entry>;
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::min();

  Queue waiting;                ///< the first one is the next to be matched
  std::vector<StepBack> steps;  ///< since the last set, up to the first waiting sample
  std::int64_t last = none;     ///< stamp of the last sample [ns]
  std::int64_t interval = 0;    ///< last increase of the stamps [ns]
  bool begins = true;           ///< no sample yet, or none while the queue of another channel overflowed
  std::uint64_t dropped = 0;    ///< samples dropped for any reason

  /// Number of visits of a stamp before the present one: how often the channel went back to it or over it.
  std::ptrdiff_t visits(std::int64_t stamp) const
  {
    return std::count_if(steps.begin(), steps.end(), [stamp](const StepBack& step) { return step.covers(stamp); });
  }
  /// Last step over a stamp since the last set; null if there is none.
  const StepBack* lastStepOver(std::int64_t stamp) const
  {
    const auto found =
        std::find_if(steps.rbegin(), steps.rend(), [stamp](const StepBack& step) { return step.covers(stamp); });
    return found == steps.rend() ? nullptr : &*found;
  }
  /// First sample behind the next one with which the channel goes back over a stamp, or the end.
  typename Queue::const_iterator nextStepOver(std::int64_t stamp, std::int64_t slop = 0) const
  {
    return std::find_if(waiting.begin() + 1, waiting.end(),
                        [=](const Entry& entry) { return entry.goesBack() && entry.step().covers(stamp, slop); });
  }
  /// First sample from `begin` on with at least this stamp, or the end.
  typename Queue::const_iterator firstFrom(typename Queue::const_iterator begin, std::int64_t stamp) const
  {
    return std::find_if(begin, waiting.end(), [stamp](const Entry& entry) { return entry.stamp >= stamp; });
  }
};

/// Channels with their waiting samples, and the numbers of samples. The rules are those of StampPairing.
///
/// @tparam Sample a type that is cheap to copy, such as a pointer to a message
template <typename Sample>
class StampQueues
{
 public:
  using Channel = StampChannel<Sample>;
  using Queue = typename Channel::Queue;

  /// @param channels number of channels, >= 1
  /// @param capacity largest number of waiting samples of a channel, >= 1; if it is exceeded, the oldest is dropped
  /// @param encloses true: the last channel has one sample for each stamp; further ones are dropped as duplicates. A
  /// repeated stamp of another channel is then no step back
  StampQueues(std::size_t channels, std::size_t capacity, bool encloses)
      : channels_(channels), capacity_(capacity), encloses_(encloses)
  {
  }

  /// Adds a sample, or drops it.
  void add(std::size_t channel, const ros::Time& stamp, Sample sample)
  {
    ++counts_.received;
    const auto time = static_cast<std::int64_t>(stamp.toNSec());
    Channel& own = channels_[channel];
    const bool is_duplicate = encloses_ && &own == &channels_.back() && time == own.last;
    if (stamp.isZero() || is_duplicate)
    {
      ++own.dropped;
      ++counts_[is_duplicate ? DropReason::duplicate : DropReason::unstamped];
      return;
    }
    const std::int64_t previous = own.begins ? begin(own, time) : own.last;
    own.interval = previous != Channel::none && time > previous ? time - previous : own.interval;
    own.last = time;
    if (own.waiting.size() == capacity_)
    {
      for (Channel& other : channels_)
      {
        other.begins = other.begins || other.waiting.empty();
      }
      drop(own, DropReason::queue_full);
    }
    const bool is_repeated = encloses_ && time == previous;
    own.waiting.push_back(
        {time, is_repeated ? previous - 1 : previous, counts_.received, own.interval, std::move(sample), false});
    ++counts_.waiting;
    if (own.waiting.size() == 1)
    {
      noteStep(own);
    }
  }

  /// Removes the next sample of a channel as part of a set.
  Sample take(Channel& channel)
  {
    Sample sample = std::move(channel.waiting.front().sample);
    ++counts_.paired;
    removeFirst(channel);
    return sample;
  }

  /// Drops the next sample of a channel. A sample that is in a set is counted as paired instead.
  void drop(Channel& channel, DropReason reason)
  {
    const bool used = channel.waiting.front().used;
    ++(used ? counts_.paired : counts_[reason]);
    channel.dropped += used ? 0U : 1U;
    removeFirst(channel);
  }

  /// Notes the difference of the stamps of two samples that do not match [ns].
  void noteMiss(std::int64_t difference) { counts_.smallest_miss = std::min(counts_.smallest_miss, difference); }

  /// Begins to count the visits again.
  void forgetSteps()
  {
    for (Channel& channel : channels_)
    {
      channel.steps.clear();
    }
  }

  /// Channels in their order.
  std::vector<Channel>& channels() { return channels_; }
  /// Channels in their order.
  const std::vector<Channel>& channels() const { return channels_; }
  /// Numbers of samples received, paired, dropped and waiting.
  const PairingCounts& counts() const { return counts_; }

 private:
  void removeFirst(Channel& channel)
  {
    channel.waiting.pop_front();
    --counts_.waiting;
    noteStep(channel);
  }

  void noteStep(Channel& channel)
  {
    if (!channel.waiting.empty() && channel.waiting.front().goesBack())
    {
      if (channel.steps.size() == capacity_)
      {
        channel.steps.erase(channel.steps.begin());
      }
      channel.steps.push_back(channel.waiting.front().step());
    }
  }

  /// A channel begins with the other ones, if these still have their first sample, or during their last visit of its
  /// first stamp.
  /// @return stamp before the first one [ns]
  std::int64_t begin(Channel& own, std::int64_t stamp)
  {
    own.begins = false;
    std::int64_t previous = Channel::none;
    for (Channel& other : channels_)
    {
      if (!other.waiting.empty() && other.waiting.front().previous == Channel::none &&
          other.waiting.front().stamp <= stamp)
      {
        continue;
      }
      while (!other.waiting.empty() && other.nextStepOver(stamp) != other.waiting.end())
      {
        drop(other, DropReason::time_jump);
      }
      if (const StepBack* last = other.lastStepOver(stamp))
      {
        previous = std::max(previous, last->high);
        other.steps = {*last};
      }
    }
    return previous;
  }

  std::vector<Channel> channels_;
  std::size_t capacity_;
  bool encloses_;
  PairingCounts counts_;
};
}  // namespace wheel_rail_contact
