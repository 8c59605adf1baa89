// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/transform_store.h"

#include <tf2/exceptions.h>

#include <Eigen/Geometry>
#include <array>
#include <exception>
#include <vector>

#include "config/text.h"

namespace wheel_rail_contact
{
namespace
{
constexpr std::size_t most_frames = 10000;  ///< of which the last stamp is known
constexpr std::size_t deepest = 100;        ///< frames from one to the root

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

/// Adds a time, and forgets those that tf2 does not keep beside it.
void addTime(const ros::Time& stamp, std::set<ros::Time>& times)
{
  const ros::Duration kept(static_cast<double>(tf2::BufferCore::DEFAULT_CACHE_TIME));
  const bool has_gone_back = !times.empty() && stamp + kept < *times.rbegin();
  times.erase(times.begin(), has_gone_back                  ? times.end()
                             : stamp.toSec() > kept.toSec() ? times.lower_bound(stamp - kept)
                                                            : times.begin());
  times.insert(stamp);
}
}  // namespace

void TransformStore::add(const geometry_msgs::TransformStamped& transform, bool is_static)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (frames_.size() == most_frames && frames_.count(transform.child_frame_id) == 0)
  {
    frames_.clear();
  }
  Frame& frame = frames_[transform.child_frame_id];
  const auto stamp = static_cast<std::int64_t>(transform.header.stamp.toNSec());
  if (is_static)
  {
    insert(transform, true, frame);
    return;
  }
  if (frame.held)
  {
    const auto held = static_cast<std::int64_t>(frame.held->header.stamp.toNSec());
    if (stamp + far < held)
    {
      refuse(*frame.held, "its stamp is far ahead of those before and after it");
    }
    else
    {
      insert(*frame.held, false, frame);
      frame.last = held;
    }
    frame.held.reset();
  }
  else if (frame.is_first && stamp + far < frame.last)  // that was the wrong one, and tf2 would prefer it
  {
    refuse(transform, "it is the second one of its frame, and the first one is far ahead");
    tf2::BufferCore::clear();
  }
  frame.is_first = frame.last == 0;
  if (frame.last != 0 && stamp - frame.last > far)
  {
    frame.held = transform;
    return;
  }
  insert(transform, false, frame);
  frame.last = stamp;
}

void TransformStore::clear()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto& entry : frames_)
  {
    entry.second = Frame{entry.second.parent, {}, 0, false, {}};
  }
  tf2::BufferCore::clear();
}

std::string TransformStore::refused() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return refused_ == 0 ? "" : std::to_string(refused_) + " transforms not used, the first one: " + first_refused_;
}

void TransformStore::insert(const geometry_msgs::TransformStamped& transform, bool is_static, Frame& frame)
{
  try
  {
    frame.parent = transform.header.frame_id;
    is_static ? frame.times.clear() : addTime(transform.header.stamp, frame.times);
    setTransform(transform, "wheel_rail_contact", is_static);
  }
  catch (const std::exception& error)  // of tf2 and of ros::Time
  {
    refuse(transform, error.what());
  }
}

void TransformStore::refuse(const geometry_msgs::TransformStamped& transform, const std::string& reason)
{
  if (refused_++ == 0)
  {
    first_refused_ = formatted("transform to '%.60s' with the stamp %u.%09u: %.200s", transform.child_frame_id.c_str(),
                               transform.header.stamp.sec, transform.header.stamp.nsec, reason.c_str());
  }
}

double TransformStore::interpolationError(const std::string& to, const std::string& from, const ros::Time& stamp,
                                          const geometry_msgs::Point& point) const
{
  std::vector<std::array<ros::Time, 3>> neighbours;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const std::string& end : {from, to})
    {
      auto frame = frames_.find(end);
      for (std::size_t depth = 0; frame != frames_.end() && depth < deepest; ++depth)
      {
        const std::set<ros::Time>& times = frame->second.times;
        const auto next = times.lower_bound(stamp);
        if (next != times.end() && *next != stamp && next != times.begin() && std::prev(next) != times.begin())
        {
          neighbours.push_back({*std::prev(next, 2), *std::prev(next), *next});
        }
        frame = frames_.find(frame->second.parent);
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
