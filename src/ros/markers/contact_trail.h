// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstddef>
#include <deque>
#include <limits>
#include <optional>

#include "ros/evaluation/contact_evaluator.h"

namespace wheel_rail_contact
{
/// An earlier contact point on a rail, with its highest pressure.
struct TrailPoint
{
  core::Side side = core::Side::left;  ///< side of the rail
  core::PatchPose pose;                ///< patch frame in the track frame; y, z and angle on the rail at rest
  double max_pressure = 0;             ///< [Pa]
  double way = 0;                      ///< along the track since the result before; 0: unknown [m]
};

/// The latest contact points, oldest first. If a stamp decreases, the trail restarts.
class ContactTrail
{
 public:
  /// Adds the patches of an output; none if it is unusable.
  /// @param at_rest rails at rest, to which the points are moved back (carriedByRail()); none: they stay where they are
  void add(const ContactOutput& output, const std::optional<core::Sides<core::PlacedRail>>& at_rest);
  /// Removes the oldest points until at most `count` remain.
  void limit(std::size_t count);
  /// Removes all points.
  void clear() { *this = ContactTrail(); }

  /// Points, oldest first.
  const std::deque<TrailPoint>& points() const { return points_; }

 private:
  ros::Time last_;                                            ///< stamp of the last output
  double last_x_ = std::numeric_limits<double>::quiet_NaN();  ///< of the last result with contacts [m]
  std::deque<TrailPoint> points_;
};
}  // namespace wheel_rail_contact
