// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/transform_store.h"

#include <exception>

#include "config/text.h"

namespace wheel_rail_contact
{
constexpr std::size_t most_frames = 10000;  ///< of which the last stamp is known

void TransformStore::add(const geometry_msgs::TransformStamped& transform, bool is_static)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_static)
  {
    insert(transform, true);
    return;
  }
  if (frames_.size() == most_frames && frames_.count(transform.child_frame_id) == 0)
  {
    frames_.clear();
  }
  Frame& frame = frames_[transform.child_frame_id];
  const auto stamp = static_cast<std::int64_t>(transform.header.stamp.toNSec());
  if (frame.held)
  {
    const auto held = static_cast<std::int64_t>(frame.held->header.stamp.toNSec());
    if (stamp + far < held)
    {
      refuse(*frame.held, "its stamp is far ahead of those before and after it");
    }
    else
    {
      insert(*frame.held, false);
      frame.last = held;
    }
    frame.held.reset();
  }
  else if (frame.is_first && stamp + far < frame.last)  // that was the wrong one, and tf2 would prefer it
  {
    refuse(transform, "it is the second one of its frame, and the first one is far ahead");
    buffer_.clear();
  }
  frame.is_first = frame.last == 0;
  if (frame.last != 0 && stamp - frame.last > far)
  {
    frame.held = transform;
    return;
  }
  insert(transform, false);
  frame.last = stamp;
}

void TransformStore::clear()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  frames_.clear();
  buffer_.clear();
}

std::string TransformStore::refused() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return refused_ == 0 ? "" : std::to_string(refused_) + " transforms not used, the first one: " + first_refused_;
}

void TransformStore::insert(const geometry_msgs::TransformStamped& transform, bool is_static)
{
  try
  {
    buffer_.note(transform, is_static);
    buffer_.setTransform(transform, "wheel_rail_contact", is_static);
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
}  // namespace wheel_rail_contact
