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
  no_partner,  ///< no sample of another channel had a stamp near enough
  duplicate,   ///< its channel had a sample of that stamp already
  time_jump,   ///< it waited for its partner when time went back
  queue_full   ///< newer samples of its channel pushed it out while it waited
};

/// Where the samples went. At any time: received = paired + sum of dropped + waiting.
struct PairingCounts
{
  static constexpr std::size_t reasons = 4;

  std::uint64_t received = 0;
  std::uint64_t paired = 0;
  std::array<std::uint64_t, reasons> dropped{};  ///< by DropReason
  std::uint64_t waiting = 0;
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
/// Within a channel stamps must rise. A stamp going back means that time has been set back (a bag loop, a simulation
/// restarted): what waits in that channel, and in those that have not gone back themselves since the last set, is
/// dropped.
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
      goBack(channel);
    }
    own.last = time;
    if (own.waiting.size() == capacity_)
    {
      dropOldest(own, DropReason::queue_full);
    }
    own.waiting.emplace_back(time, std::move(sample));
    ++counts_.waiting;
    return merge();
  }

  /// Drops what still waits: at the end of a recording its partners will not come.
  void finish()
  {
    for (Channel& channel : channels_)
    {
      dropAll(channel, DropReason::no_partner);
    }
  }

  const PairingCounts& counts() const { return counts_; }

 private:
  struct Channel
  {
    std::deque<std::pair<std::int64_t, Sample>> waiting;  ///< stamps [ns], rising
    std::optional<std::int64_t> last;                     ///< newest stamp [ns]
    bool went_back = false;                               ///< since the last set
  };

  std::uint64_t& dropped(DropReason reason) { return counts_.dropped[static_cast<std::size_t>(reason)]; }

  void dropOldest(Channel& channel, DropReason reason)
  {
    channel.waiting.pop_front();
    --counts_.waiting;
    ++dropped(reason);
  }

  void dropAll(Channel& channel, DropReason reason)
  {
    while (!channel.waiting.empty())
    {
      dropOldest(channel, reason);
    }
  }

  void goBack(std::size_t channel)
  {
    const bool again = channels_[channel].went_back;
    for (Channel& other : channels_)
    {
      if (again)
      {
        other.went_back = false;
      }
      if (!other.went_back)
      {
        dropAll(other, DropReason::time_jump);
      }
    }
    dropAll(channels_[channel], DropReason::time_jump);
    channels_[channel].went_back = true;
  }

  /// Only the channel just added to can have been empty before, so at most one set comes of it.
  std::optional<std::vector<Sample>> merge()
  {
    const auto earlier = [](const Channel& a, const Channel& b)
    { return a.waiting.front().first < b.waiting.front().first; };
    const auto is_empty = [](const Channel& channel) { return channel.waiting.empty(); };
    while (std::none_of(channels_.begin(), channels_.end(), is_empty))
    {
      const auto ends = std::minmax_element(channels_.begin(), channels_.end(), earlier);
      if (ends.second->waiting.front().first - ends.first->waiting.front().first <= slop_)
      {
        return takeSet();
      }
      dropOldest(*ends.first, DropReason::no_partner);
    }
    return std::nullopt;
  }

  std::vector<Sample> takeSet()
  {
    std::vector<Sample> set;
    for (Channel& channel : channels_)
    {
      set.push_back(std::move(channel.waiting.front().second));
      channel.waiting.pop_front();
      channel.went_back = false;
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
