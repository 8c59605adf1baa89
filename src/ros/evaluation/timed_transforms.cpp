// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/timed_transforms.h"

#include <tf2/exceptions.h>

#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace wheel_rail_contact
{
namespace
{
constexpr std::size_t deepest = 100;  ///< frames from one to the root

/// Place of a point across a frame (y, z) at a time [m].
Eigen::Vector2d placeAt(const tf2::BufferCore& transforms, const std::string& to, const std::string& from,
                        const ros::Time& time, const geometry_msgs::Point& point)
{
  const auto transform = transforms.lookupTransform(to, from, time).transform;
  const auto& t = transform.translation;
  const auto& r = transform.rotation;
  const Eigen::Vector3d turned = Eigen::Quaterniond(r.w, r.x, r.y, r.z) * Eigen::Vector3d(point.x, point.y, point.z);
  return {t.y + turned.y(), t.z + turned.z()};
}
}  // namespace

void TimedTransforms::note(const geometry_msgs::TransformStamped& transform, bool is_static)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  Link& link = links_[transform.child_frame_id];
  link.parent = transform.header.frame_id;
  if (is_static)
  {
    link.times.clear();
    return;
  }
  const ros::Duration kept(static_cast<double>(tf2::BufferCore::DEFAULT_CACHE_TIME));
  const ros::Time& stamp = transform.header.stamp;
  const bool has_gone_back = !link.times.empty() && stamp + kept < *link.times.rbegin();
  link.times.erase(link.times.begin(), has_gone_back                  ? link.times.end()
                                       : stamp.toSec() > kept.toSec() ? link.times.lower_bound(stamp - kept)
                                                                      : link.times.begin());
  link.times.insert(stamp);
}

double TimedTransforms::interpolationError(const std::string& to, const std::string& from, const ros::Time& stamp,
                                           const geometry_msgs::Point& point) const
{
  std::vector<std::array<ros::Time, 3>> neighbours;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const std::string& end : {from, to})
    {
      auto link = links_.find(end);
      for (std::size_t depth = 0; link != links_.end() && depth < deepest; ++depth)
      {
        const std::set<ros::Time>& times = link->second.times;
        const auto next = times.lower_bound(stamp);
        if (next != times.end() && *next != stamp && std::distance(times.begin(), next) > 1)
        {
          neighbours.push_back({*std::prev(next, 2), *std::prev(next), *next});
        }
        link = links_.find(link->second.parent);
      }
    }
  }
  double error = 0;
  for (const auto& [first, before, next] : neighbours)
  {
    try
    {
      const auto place = [&](const ros::Time& time) { return placeAt(*this, to, from, time, point); };
      const Eigen::Vector2d middle = place(before);
      const Eigen::Vector2d change =
          (place(next) - middle) / (next - before).toSec() - (middle - place(first)) / (before - first).toSec();
      error += change.norm() / (next - first).toSec() * (stamp - before).toSec() * (next - stamp).toSec();
    }
    catch (const tf2::TransformException&)  // another transform is not known there
    {
    }
  }
  return error;
}
}  // namespace wheel_rail_contact
