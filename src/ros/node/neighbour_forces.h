// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "core/rail/neighbours.h"
#include "ros/node/neighbour_result.h"
#include "ros/parameters/parameters.h"

namespace wheel_rail_contact
{
/// What the neighbouring wheelsets cause at an input's stamp.
struct NeighbourEffect
{
  std::array<core::RailDeflection, 2> deflection;  ///< of each rail by Side, track axes of its side
  bool complete = true;                            ///< the forces of every neighbour are known
};

/// Rail forces of the neighbouring wheelsets (rail_bending/neighbours), from their answers.
///
/// For an input of stamp t counts each neighbour's newest answer of a stamp before t, never of t itself: which of two
/// wheelsets is answered first in a step does not matter then. An answer that is not usable counts as no force, as does
/// one older than `longest_age` or none at all; effectAt() tells. Where a neighbour's stamps go back, its answers
/// from there on are forgotten. Not thread-safe.
class NeighbourForces
{
 public:
  static constexpr double longest_age = 1.0;      ///< [s] of the stamps
  static constexpr std::size_t most_kept = 1000;  ///< answers of each neighbour

  /// Copies what it needs.
  explicit NeighbourForces(const NodeConfig& config);

  /// Takes an answer of the neighbour of this number in NodeConfig::neighbours.
  void add(std::size_t neighbour, const NeighbourResult& result);

  /// True if answers of every neighbour reach back so far that those before them do not count at the stamp, nor later.
  bool reachBackFrom(const ros::Time& stamp) const;

  /// What the neighbours cause here at the stamp.
  NeighbourEffect effectAt(const ros::Time& stamp) const;

 private:
  using Forces = std::array<core::RailForce, 2>;  ///< by Side
  struct Result
  {
    ros::Time stamp;
    std::optional<Forces> forces;  ///< none unless usable and finite
  };
  struct Neighbour
  {
    core::ComplianceTable influence;
    std::deque<Result> results;  ///< stamps rising
  };
  static const Forces* forcesAt(const Neighbour& neighbour, const ros::Time& stamp);
  static std::optional<Forces> forcesOf(const NeighbourResult& result);

  double inclination_;
  std::vector<Neighbour> neighbours_;
};
}  // namespace wheel_rail_contact
