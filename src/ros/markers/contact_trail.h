// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstddef>
#include <deque>

#include "ros/node/contact_evaluator.h"

namespace wheel_rail_contact
{
/// Where the contact points were on the rails, and how much they carried.
struct TrailPoint
{
  core::Side side = core::Side::left;  ///< of the rail
  core::PatchPose pose;                ///< x of the track frame; the rest on the rail at rest (see carriedByRail())
  double max_pressure = 0;             ///< [Pa]
};

/// The latest contact points, oldest first. A stamp before the last one starts a new trail.
class ContactTrail
{
 public:
  /// Adds the patches of a usable answer. `at_rest` tells how the rail's deflection is taken off; without it the
  /// points are kept where they are.
  void add(const ContactOutput& output, const core::PlacedRail* at_rest);
  /// Keeps at most so many points.
  void limit(std::size_t count);
  /// Forgets all points.
  void clear() { points_.clear(); }

  /// Oldest first.
  const std::deque<TrailPoint>& points() const { return points_; }

 private:
  ros::Time last_;
  std::deque<TrailPoint> points_;
};
}  // namespace wheel_rail_contact
