// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/neighbour_forces.h"

#include <algorithm>
#include <cmath>

#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
namespace
{
constexpr auto longest_age_ns = static_cast<std::int64_t>(1e9 * NeighbourForces::longest_age);

/// Time from `earlier` to `stamp` [ns]. Stamps may have any value, and ros::Duration throws above 68 years.
std::int64_t ageAt(const ros::Time& stamp, const ros::Time& earlier)
{
  return static_cast<std::int64_t>(stamp.toNSec()) - static_cast<std::int64_t>(earlier.toNSec());
}

core::RailForce forceOn(const RailDeflection& rail)
{
  return {rail.lateral_force, rail.vertical_force, rail.moment};
}

/// False for values from an invalid message.
bool isFinite(const core::RailForce& force)
{
  return std::isfinite(force.lateral) && std::isfinite(force.vertical) && std::isfinite(force.moment);
}
}  // namespace

NeighbourForces::NeighbourForces(const NodeConfig& config) : inclination_(config.model.track.rail_inclination)
{
  for (const NeighbourConfig& neighbour : config.neighbours)
  {
    neighbours_.push_back({neighbour.influence, {}});
  }
}

void NeighbourForces::add(std::size_t neighbour, const ResultHead& result)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  std::deque<Result>& results = neighbours_.at(neighbour).results;
  while (!results.empty() && results.back().stamp >= result.stamp)
  {
    results.pop_back();
  }
  if (results.size() == capacity)
  {
    results.pop_front();
  }
  results.push_back({result.stamp, forcesOf(result)});
}

std::optional<NeighbourForces::Forces> NeighbourForces::forcesOf(const ResultHead& result)
{
  const Forces forces{forceOn(result.left_rail), forceOn(result.right_rail)};
  return isUsable(result.status) && isFinite(forces.left) && isFinite(forces.right) ? std::optional(forces)
                                                                                    : std::nullopt;
}

bool NeighbourForces::reachBackFrom(const ros::Time& stamp) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::all_of(
      neighbours_.begin(), neighbours_.end(),
      [&stamp](const Neighbour& neighbour)
      { return !neighbour.results.empty() && ageAt(stamp, neighbour.results.front().stamp) >= longest_age_ns; });
}

NeighbourEffect NeighbourForces::effectAt(const ros::Time& stamp) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  NeighbourEffect effect;
  core::Sides<std::vector<core::NeighbourForce>> forces;
  for (const Neighbour& neighbour : neighbours_)
  {
    const Forces* known = forcesAt(neighbour, stamp);
    effect.complete = effect.complete && known != nullptr;
    if (known != nullptr)
    {
      forces.left.push_back({neighbour.influence.left, known->left});
      forces.right.push_back({neighbour.influence.right, known->right});
    }
  }
  effect.deflection = {neighbourDeflection(forces.left, inclination_.left),
                       neighbourDeflection(forces.right, inclination_.right)};
  return effect;
}

/// Forces of the newest result before the stamp; null if there is none, or if it is too old or not usable.
const NeighbourForces::Forces* NeighbourForces::forcesAt(const Neighbour& neighbour, const ros::Time& stamp)
{
  const auto& results = neighbour.results;
  const auto after = std::lower_bound(results.begin(), results.end(), stamp,
                                      [](const Result& result, const ros::Time& t) { return result.stamp < t; });
  if (after == results.begin())
  {
    return nullptr;
  }
  const Result& newest = *(after - 1);
  return newest.forces && ageAt(stamp, newest.stamp) <= longest_age_ns ? &*newest.forces : nullptr;
}
}  // namespace wheel_rail_contact
