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
/// Why a sample never became part of an answer.
enum class DropReason
{
  unmatched,  ///< no sample of another channel had a stamp near enough
  duplicate,  ///< its channel had a sample of that stamp already
  time_jump,  ///< time went back while it waited for its partner, or it came out of order
  queue_full  ///< newer samples of its channel pushed it out while it waited
};

/// Where the samples went. At any time: received = paired + sum of dropped + waiting.
struct PairingCounts
{
  static constexpr std::size_t reasons = 4;  ///< number of them

  std::uint64_t received = 0;                    ///< samples
  std::uint64_t paired = 0;                      ///< samples in sets
  std::array<std::uint64_t, reasons> dropped{};  ///< by DropReason
  std::uint64_t waiting = 0;                     ///< for their partners
};

/// Puts samples of several channels together by their stamps: one of each channel, all stamps within `slop`.
///
/// The channels are merged like sorted lists. Whenever every channel has a sample waiting, the oldest of each are
/// compared: they form a set if their stamps lie within the slop, otherwise the oldest of them has no partner. So the
/// sets depend on the sequence of each channel only, not on how the channels interleave on their way here, no clock is
/// asked, and a live node and a replay of its bag form the same sets. A slop below half the sampling interval is
/// unambiguous.
///
/// message_filters cannot be used for this: it works on subscribers and callbacks only, its approximate policy depends
/// on the order of arrival, and neither policy tells what it dropped.
///
/// Within a channel stamps must rise. A stamp going back means that time has been set back (a bag loops, a simulation
/// is restarted). Channels learn of that one after the other: what comes from one that has gone back waits apart until
/// all others have, while the others go on to be paired with what it left waiting. So no set is lost at the seam of a
/// loop, and none is made of samples before and after it. A channel that has not been beyond the stamp to which another
/// went back counts as gone with it. A channel that gets beyond where it went back from before the others followed had
/// only a sample out of order.
///
/// @tparam Sample cheap to move, such as a pointer to a message
template <typename Sample>
class StampPairing
{
 public:
  /// @param channels number of channels, >= 1
  /// @param slop largest distance of the stamps of one set [s], >= 0
  /// @param capacity greatest number of samples that wait in one channel, >= 1; the oldest make room
  StampPairing(std::size_t channels, double slop, std::size_t capacity)
      : channels_(channels), slop_(std::llround(slop * 1e9)), capacity_(capacity)
  {
  }

  /// Takes a sample. @return the set it completes, by channel, if any.
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

  /// Drops what still waits: at the end of a recording its partners will not come.
  void finish()
  {
    for (Channel& channel : channels_)
    {
      dropAll(channel.waiting, DropReason::unmatched);
      dropAll(channel.after, DropReason::unmatched);
    }
  }

  /// Where the samples went so far.
  const PairingCounts& counts() const { return counts_; }

  /// True if nothing waits for a partner, nor for a channel to follow another back in time.
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
  using Queue = std::deque<Entry>;  ///< stamps rising

  struct Channel
  {
    Queue waiting;
    Queue after;                       ///< what came since it went back, as long as others have not followed
    std::optional<std::int64_t> last;  ///< newest stamp [ns]
    bool gone_back = false;            ///< while others have not followed
    std::int64_t left_at = 0;          ///< the stamp from which it went back [ns]
    std::uint64_t went_at = 0;         ///< the arrival with which it went back
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

  /// A channel goes back to a stamp [ns]. With the last one the new time begins for all.
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
      beginAnew();
    }
  }

  void beginAnew()
  {
    for (Channel& channel : channels_)
    {
      dropAll(channel.waiting, DropReason::time_jump);
      std::swap(channel.waiting, channel.after);
      channel.gone_back = false;
    }
  }

  /// Time has not been set back after all. What waited in other channels when it seemed so is not trusted.
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

  /// Only the channel just added to can have been empty before, so at most one set comes of it.
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
