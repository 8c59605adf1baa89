// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>

#include <map>
#include <mutex>
#include <set>
#include <string>

namespace wheel_rail_contact
{
/// Transforms of tf, with the times at which each is known. Between these tf interpolates: linearly, also in curves.
/// Thread-safe.
class TimedTransforms : public tf2::BufferCore
{
 public:
  /// Notes the time of a transform; it must be noted before it is set.
  void note(const geometry_msgs::TransformStamped& transform, bool is_static);

  /// Estimated error of the interpolation at a stamp: how far a point of one frame is misplaced across the other [m].
  /// It is that of a parabola through three known places, two before the stamp and one after it; 0 without these.
  double interpolationError(const std::string& to, const std::string& from, const ros::Time& stamp,
                            const geometry_msgs::Point& point) const;

 private:
  struct Link
  {
    std::string parent;
    std::set<ros::Time> times;  ///< of as long as tf keeps transforms; none if static
  };

  mutable std::mutex mutex_;
  std::map<std::string, Link> links_;  ///< by child
};
}  // namespace wheel_rail_contact
