// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "ros/evaluation/stamp_queues.h"

namespace wheel_rail_contact
{
/// Combines samples of several channels by their stamps into sets: one sample of each channel, all stamps within
/// `slop`.
///
/// *Matching.* The samples of each channel are matched in their order. Where the stamps of a channel go back, to a
/// stamp or over it, it visits this stamp again, and samples form a set only if their channels have gone back over
/// their stamps equally often since the last set. The channels may arrive in any order, one up to `capacity` samples
/// behind the other, and a slower channel need not go back if none of its samples lies in the stamps that are visited
/// again. A sample of a visit that the other channels do not make (a late one, a repetition in one channel only) has no
/// set, and is dropped and counted when they have passed it.
///
/// The sets therefore depend on the sequence of each channel, not on the order in which the channels arrive, nor on a
/// clock. A live node and a replay of its bag form the same sets. That every set is found holds for one or two rates,
/// if the stamps of the slower channels are among those of the faster ones. The order of arrival can matter only if
/// samples are lost or late where time goes back, or with more rates. A slop below half the sampling interval is
/// unambiguous.
///
/// *Begin.* A channel whose first sample comes after another channel has already gone back over it begins in the last
/// visit. The same holds for the next one after so long a silence that the queue of another channel overflowed.
///
/// *Far stamps.* A sample that is `far` ahead of the one before it in its channel displaces no other samples until the
/// next one of its channel has confirmed it.
///
/// *Enclosing.* If the last channel encloses the others, it is not matched. A set then contains two of its samples: the
/// last one up to the stamp of the first channel, and the next one, or twice the same one if its stamp is equal. Their
/// stamps differ by at most the longest gap. A set waits for the next sample of this channel; one without both samples
/// is dropped as not enclosed. The enclosing channel is a function of time: of several samples with one stamp, only the
/// first one is used, also for repeated samples of the other channels, and the others are dropped as duplicates. Where
/// the other channels go back and it does not, its samples hold for both visits; those that wait for its next sample
/// are dropped if they are visited again.
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

  /// A stamp that is so far ahead of the one before it in its channel waits for the next one [ns].
  static constexpr std::int64_t far = 60'000'000'000;

  /// @param channels number of channels, >= 1
  /// @param slop largest difference of the stamps of the matched samples of a set [s], >= 0
  /// @param capacity largest number of waiting samples of a channel, >= 1; if it is exceeded, the oldest is dropped
  /// @param longest_gap the last channel encloses the others, with at most this difference of its stamps [s]; there are
  /// then at least two channels. Empty: all channels are matched
  StampPairing(std::size_t channels, double slop, std::size_t capacity, std::optional<double> longest_gap = {})
      : queues_(channels, capacity, longest_gap.has_value()),
        slop_(nanoseconds(slop)),
        matched_(channels - (longest_gap ? 1 : 0)),
        longest_gap_(nanoseconds(longest_gap.value_or(0)))
  {
  }

  /// Adds a sample. @return the sets that it completes, in order.
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
      while (!isEmpty(queues_.channels()[i]))
      {
        queues_.drop(queues_.channels()[i], i < matched_ ? DropReason::unmatched : DropReason::unneeded);
      }
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
    return std::all_of(channels.begin(), channels.end(),
                       [](const Channel& channel) { return channel.steps.empty(); }) &&
           std::all_of(channels.begin(), channels.begin() + static_cast<std::ptrdiff_t>(matched_), isEmpty) &&
           (!isEnclosing() || (!isEmpty(channels.back()) && channels.back().waiting.front().used));
  }

 private:
  using Channel = typename StampQueues<Sample>::Channel;
  using Queue = typename StampQueues<Sample>::Queue;

  /// What is to be done with the next samples of two channels.
  struct Verdict
  {
    Channel* dropped = nullptr;  ///< channel whose next sample cannot be matched
    DropReason reason = DropReason::unmatched;
    bool waits = false;         ///< further samples are required to decide
    bool is_displaced = false;  ///< the dropped sample was ahead of the others; the next one is no step back
  };

  static constexpr std::ptrdiff_t any_number = std::numeric_limits<std::ptrdiff_t>::max();

  static std::int64_t nanoseconds(double seconds) { return std::llround(seconds * 1e9); }
  static bool isEmpty(const Channel& channel) { return channel.waiting.empty(); }
  bool isEnclosing() const { return matched_ < queues_.channels().size(); }

  /// @param ended true: no further samples follow
  std::vector<Set> merge(bool ended)
  {
    std::vector<Set> sets;
    const auto first = queues_.channels().begin(), end = first + static_cast<std::ptrdiff_t>(matched_);
    while (std::none_of(first, end, isEmpty))
    {
      const Verdict verdict = compareAll();
      if (verdict.dropped != nullptr)
      {
        Queue& queue = verdict.dropped->waiting;
        if (verdict.is_displaced)
        {
          queue[1].previous = queue[0].previous;
        }
        queues_.drop(*verdict.dropped, verdict.reason);
      }
      else if (verdict.waits || !mayTakeSet(ended, sets))
      {
        break;
      }
    }
    return sets;
  }

  Verdict compareAll()
  {
    Verdict all;
    std::vector<Channel>& channels = queues_.channels();
    for (std::size_t i = 0; i < matched_; ++i)
    {
      for (std::size_t k = 0; k < i; ++k)
      {
        const bool in_order = channels[k].waiting.front().stamp <= channels[i].waiting.front().stamp;
        const Verdict verdict = compare(channels[in_order ? k : i], channels[in_order ? i : k]);
        if (verdict.dropped != nullptr)
        {
          const std::int64_t difference =
              std::abs(channels[i].waiting.front().stamp - channels[k].waiting.front().stamp);
          if (verdict.reason == DropReason::unmatched && difference > slop_)
          {
            queues_.noteMiss(difference);
          }
          return verdict;
        }
        all.waits = all.waits || verdict.waits;
      }
    }
    return all;
  }

  /// @param lower channel whose next sample has no later stamp than that of the other one
  Verdict compare(Channel& lower, Channel& upper) const
  {
    const std::int64_t low = lower.waiting.front().stamp, high = upper.waiting.front().stamp;
    if (high - low <= slop_ && lower.visits(low) == upper.visits(high))
    {
      return {};
    }
    if (lower.visits(high) > upper.visits(high))
    {
      return {&upper, DropReason::time_jump};
    }
    return lower.visits(low) > upper.visits(low) ? afterStep(lower, upper) : beforeHigher(lower, upper);
  }

  /// The lower channel has gone back over its stamp, the upper one has not: it will still do so, or it has passed.
  Verdict afterStep(Channel& lower, Channel& upper) const
  {
    const auto &low = lower.waiting.front(), &high = upper.waiting.front();
    const StepBack& step = *lower.lastStepOver(low.stamp);
    const auto end = lower.waiting.cend(), next = lower.waiting.cbegin() + 1;
    const bool is_decrease = step.high > step.low, is_above = high.stamp > step.high;
    const DropReason reason = is_decrease ? DropReason::time_jump : DropReason::unmatched;
    if (is_above && is_decrease && low.arrival == step.arrival && next != end && next->stamp > step.high)
    {
      return {&lower, reason};  // a single late sample
    }
    const auto reached = lower.firstFrom(next, high.stamp - slop_);
    const bool reaches = reached != end && reached->stamp <= high.stamp + slop_;
    const bool returns = std::any_of(next, reached, [](const auto& entry) { return entry.goesBack(); });
    const std::ptrdiff_t one_more = reached == end && !returns ? 1 : any_number;
    if (bothGoBack(lower, upper, step, reaches ? reached - next + 1 : one_more))
    {
      return {&upper, DropReason::time_jump};
    }
    if (reached == end)
    {
      return {nullptr, {}, true};
    }
    const bool is_doubtful =
        is_above && is_decrease && high.arrival < step.arrival && step.covers(high.previous) &&
        std::none_of(upper.steps.begin(), upper.steps.end(),
                     [&step](const StepBack& other) { return other.low <= step.high && other.high >= step.low; });
    return reaches && !is_doubtful ? Verdict{&lower, reason}
                                   : Verdict{&upper, reaches ? reason : DropReason::unmatched};
  }

  /// True if the upper channel goes back later, too, and comes to a stamp of the lower one below its own next one.
  /// @param step of the lower channel. If that of the upper one does not agree with it, the channels must meet there
  /// after at most `otherwise` samples
  bool bothGoBack(const Channel& lower, const Channel& upper, const StepBack& step, std::ptrdiff_t otherwise) const
  {
    const std::int64_t high = upper.waiting.front().stamp;
    auto one = lower.waiting.begin();
    const auto back = upper.nextStepOver(one->stamp, slop_);
    auto other = back;
    while (one != lower.waiting.end() && other != upper.waiting.end() && one->stamp < high - slop_)
    {
      if (std::abs(one->stamp - other->stamp) <= slop_)
      {
        return step.agreesWith(back->step(), slop_) ||
               one - lower.waiting.begin() + (other - upper.waiting.begin()) <= otherwise;
      }
      ++(one->stamp < other->stamp ? one : other);
    }
    return false;
  }

  /// The lower sample has no match, unless the upper one is out of order: see far.
  Verdict beforeHigher(Channel& lower, Channel& upper) const
  {
    const auto &low = lower.waiting.front(), &high = upper.waiting.front();
    if (high.previous == Channel::none || high.previous >= low.stamp || high.stamp - high.previous <= far)
    {
      return {&lower};
    }
    const auto step = upper.nextStepOver(low.stamp);
    const auto end = upper.waiting.end();
    const auto reached = upper.firstFrom(step, low.stamp - slop_);
    if (step == end ? upper.waiting.size() > 1 : reached != end && reached->stamp > low.stamp + slop_)
    {
      return {&lower};
    }
    return {reached == end ? nullptr : &upper, DropReason::time_jump, true, true};
  }

  /// Takes the set of the next samples, or drops them if they are not enclosed. @return false if they must wait
  bool mayTakeSet(bool ended, std::vector<Set>& sets)
  {
    const std::optional<DropReason> fault = isEnclosing() ? enclose(ended) : std::nullopt;
    if (!fault)
    {
      sets.push_back(takeSet());
      return true;
    }
    for (std::size_t i = 0; i < matched_ && fault != DropReason::unneeded; ++i)
    {
      queues_.drop(queues_.channels()[i], *fault);
    }
    return fault != DropReason::unneeded;
  }

  /// Moves the enclosing channel to the samples around the stamp of the first channel.
  /// @return reason why they do not enclose it; `unneeded`: further samples are required
  std::optional<DropReason> enclose(bool ended)
  {
    const Channel& first = queues_.channels().front();
    Channel& channel = queues_.channels().back();
    const Queue& queue = channel.waiting;
    const std::int64_t stamp = first.waiting.front().stamp;
    const auto again = first.nextStepOver(stamp);
    while (!queue.empty())
    {
      const auto visits = channel.visits(stamp), wanted = first.visits(stamp);
      const bool is_last = queue.size() == 1 || queue[1].goesBack();
      if (visits > wanted)
      {
        return DropReason::time_jump;
      }
      const bool goes_back = channel.nextStepOver(stamp) != queue.end();
      if (visits == wanted || (!goes_back && channel.last > first.lastStepOver(stamp)->high))
      {
        if (queue[0].stamp >= stamp || (!is_last && queue[1].stamp > stamp))
        {
          return faultOf(queue, stamp, again != first.waiting.end() ? &*again : nullptr);
        }
        if (is_last && queue.size() > 1 && again != first.waiting.end())
        {
          return DropReason::time_jump;
        }
        if (is_last && (queue.size() == 1 || channel.last < stamp))
        {
          break;
        }
      }
      else if (!goes_back)
      {
        break;
      }
      queues_.drop(channel, DropReason::unneeded);
    }
    return ended ? DropReason::not_enclosed : DropReason::unneeded;
  }

  /// Reason why the first samples of the enclosing channel do not enclose a stamp [ns]. Empty if they do.
  /// @param again sample with which the first channel goes back over the stamp later; null: it does not
  std::optional<DropReason> faultOf(const Queue& queue, std::int64_t stamp, const typename Channel::Entry* again) const
  {
    if (queue[0].stamp == stamp)
    {
      return std::nullopt;
    }
    if (queue[0].stamp > stamp || queue[1].stamp - queue[0].stamp > longest_gap_)
    {
      return DropReason::not_enclosed;
    }
    const bool is_redone = again != nullptr && again->stamp > queue[0].stamp && again->previous < queue[1].stamp;
    return is_redone ? std::optional(DropReason::time_jump) : std::nullopt;
  }

  Set takeSet()
  {
    Set set;
    std::vector<Channel>& channels = queues_.channels();
    const std::int64_t stamp = channels.front().waiting.front().stamp;
    queues_.forgetSteps();
    for (std::size_t i = 0; i < matched_; ++i)
    {
      set.push_back(queues_.take(channels[i]));
    }
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
  std::size_t matched_;       ///< number of the channels that are matched; these are the first ones
  std::int64_t longest_gap_;  ///< [ns]
};
}  // namespace wheel_rail_contact
