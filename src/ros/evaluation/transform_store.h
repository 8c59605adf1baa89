// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "ros/evaluation/timed_transforms.h"

namespace wheel_rail_contact
{
/// Transforms of /tf and /tf_static, as tf2 keeps them, for the live node and the replay. No transform stops the
/// program or displaces the others: a stamp that is `far` ahead of the one before it in its frame waits for the next
/// one of this frame, and tf2 ignores what is older than its memory. Thread-safe.
class TransformStore
{
 public:
  static constexpr std::int64_t far = 3'600'000'000'000;  ///< [ns]

  /// Adds a transform, or refuses it.
  void add(const geometry_msgs::TransformStamped& transform, bool is_static);
  /// Forgets the transforms that are not static: time went back.
  void clear();

  /// Number of refused transforms, and the first one with the reason; empty if there are none.
  std::string refused() const;
  /// The transforms.
  const TimedTransforms& buffer() const { return buffer_; }

 private:
  struct Frame
  {
    std::int64_t last = 0;                                ///< stamp of the last transform that was added [ns]
    bool is_first = false;                                ///< only one was added
    std::optional<geometry_msgs::TransformStamped> held;  ///< waits for the next one
  };

  void insert(const geometry_msgs::TransformStamped& transform, bool is_static);
  void refuse(const geometry_msgs::TransformStamped& transform, const std::string& reason);

  TimedTransforms buffer_;
  mutable std::mutex mutex_;             ///< guards the following
  std::map<std::string, Frame> frames_;  ///< by child frame
  std::uint64_t refused_ = 0;
  std::string first_refused_;
};
}  // namespace wheel_rail_contact
