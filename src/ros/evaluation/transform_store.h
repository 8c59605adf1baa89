// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>

namespace wheel_rail_contact
{
/// Transforms of /tf and /tf_static, as tf2 keeps them, for the live node and the replay. No transform stops the
/// program or displaces the others: a stamp that is `far` ahead of the one before it in its frame waits for the next
/// one of this frame, and tf2 ignores what is older than its memory. Between the times of a transform, tf2
/// interpolates: linearly, also in curves. Thread-safe.
class TransformStore : public tf2::BufferCore
{
 public:
  static constexpr std::int64_t far = 3'600'000'000'000;  ///< [ns]

  /// Adds a transform, or refuses it.
  void add(const geometry_msgs::TransformStamped& transform, bool is_static);
  /// Forgets the transforms that are not static: time went back.
  void clear();

  /// Number of refused transforms, and the first one with the reason; empty if there are none.
  std::string refused() const;
  /// Estimated error of the interpolation at a stamp: how far a point of one frame is misplaced across the other [m].
  /// It is that of a parabola through three known places, two before the stamp and one after it; 0 without these.
  double interpolationError(const std::string& to, const std::string& from, const ros::Time& stamp,
                            const geometry_msgs::Point& point) const;

 private:
  struct Frame
  {
    std::string parent;
    std::set<ros::Time> times;                            ///< of as long as tf2 keeps transforms; none if static
    std::int64_t last = 0;                                ///< stamp of the last transform that was added [ns]
    bool is_first = false;                                ///< only one was added
    std::optional<geometry_msgs::TransformStamped> held;  ///< waits for the next one
  };

  void insert(const geometry_msgs::TransformStamped& transform, bool is_static, Frame& frame);
  void refuse(const geometry_msgs::TransformStamped& transform, const std::string& reason);

  mutable std::mutex mutex_;             ///< guards the following
  std::map<std::string, Frame> frames_;  ///< by child frame
  std::uint64_t refused_ = 0;
  std::string first_refused_;
};
}  // namespace wheel_rail_contact
