// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "config/node_config.h"
#include "core/rail/neighbours.h"
#include "ros/evaluation/result_head.h"

namespace wheel_rail_contact
{
/// Effect of the neighbouring wheelsets on the rails at a stamp.
struct NeighbourEffect
{
  core::Sides<core::RailDeflection> deflection;  ///< of each rail by Side; side axes
  bool complete = true;                          ///< the forces of all neighbours are known
};

/// Rail forces of the neighbouring wheelsets (rail_bending/neighbours), from their results.
///
/// For an input with stamp t, the newest result of each neighbour with a stamp before t is used, never one at t itself.
/// The order in which two wheelsets are evaluated in one time step therefore has no effect. The forces are unknown, and
/// taken as zero, if this result is not usable, is older than `longest_age`, or does not exist. If the stamps of a
/// neighbour go back to t, its results at and after t are discarded. Thread-safe.
class NeighbourForces
{
 public:
  static constexpr double longest_age = 1.0;     ///< largest difference of the stamps at which a result is used [s]
  static constexpr std::size_t capacity = 1000;  ///< largest number of stored results of each neighbour

  /// Keeps no reference to `config`.
  explicit NeighbourForces(const NodeConfig& config);

  /// Adds a result of a neighbour.
  /// @param neighbour index in NodeConfig::neighbours
  void add(std::size_t neighbour, const ResultHead& result);

  /// True if each neighbour has a stored result at least `longest_age` before the stamp. Earlier results then have no
  /// effect at this stamp or a later one.
  bool reachBackFrom(const ros::Time& stamp) const;

  /// Effect of all neighbours at the stamp.
  NeighbourEffect effectAt(const ros::Time& stamp) const;

 private:
  using Forces = core::Sides<core::RailForce>;  ///< by Side
  struct Result
  {
    ros::Time stamp;
    std::optional<Forces> forces;  ///< empty unless the result is usable and the forces are finite
  };
  struct Neighbour
  {
    core::Sides<core::ComplianceTable> influence;
    std::deque<Result> results;  ///< in order of increasing stamps
  };
  static const Forces* forcesAt(const Neighbour& neighbour, const ros::Time& stamp);
  static std::optional<Forces> forcesOf(const ResultHead& result);

  core::Sides<double> inclination_;  ///< of the rails [rad]
  mutable std::mutex mutex_;         ///< guards `neighbours_`
  std::vector<Neighbour> neighbours_;
};
}  // namespace wheel_rail_contact
