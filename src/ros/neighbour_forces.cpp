// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/ros/neighbour_forces.h"

#include <algorithm>
#include <cmath>

#include "wheel_rail_contact/ros/conversions.h"

namespace wheel_rail_contact
{
namespace
{
/// Of one rail; none if a number of a foreign message is not finite.
RailForce forceOn(const RailDeflectionMsg& rail)
{
  const bool finite =
      std::isfinite(rail.lateral_force) && std::isfinite(rail.vertical_force) && std::isfinite(rail.moment);
  return finite ? RailForce{rail.lateral_force, rail.vertical_force, rail.moment} : RailForce{};
}

std::array<RailForce, 2> forcesOf(const WheelsetContactMsg& answer)
{
  return isUsable(answer.status) ? std::array<RailForce, 2>{forceOn(answer.left_rail), forceOn(answer.right_rail)}
                                 : std::array<RailForce, 2>{};
}
}  // namespace

NeighbourForces::NeighbourForces(const NodeConfig& config) : cant_(config.model.track.cant)
{
  for (const NeighbourConfig& neighbour : config.neighbours)
  {
    neighbours_.push_back({neighbour.influence, {}});
  }
}

void NeighbourForces::add(std::size_t neighbour, const WheelsetContactMsg& answer)
{
  std::deque<Answer>& answers = neighbours_.at(neighbour).answers;
  while (!answers.empty() && answers.back().stamp >= answer.header.stamp)
  {
    answers.pop_back();
  }
  if (answers.size() == most_kept)
  {
    answers.pop_front();
  }
  answers.push_back({answer.header.stamp, forcesOf(answer)});
}

bool NeighbourForces::reachBackFrom(const ros::Time& stamp) const
{
  return std::all_of(
      neighbours_.begin(), neighbours_.end(),
      [&stamp](const Neighbour& neighbour)
      { return !neighbour.answers.empty() && stamp - neighbour.answers.front().stamp >= ros::Duration(longest_age); });
}

std::array<RailDeflection, 2> NeighbourForces::deflectionAt(const ros::Time& stamp) const
{
  std::array<std::vector<NeighbourForce>, 2> forces;
  for (const Neighbour& neighbour : neighbours_)
  {
    if (const Answer* answer = newestBefore(neighbour, stamp))
    {
      forces[0].push_back({neighbour.influence, answer->force[0]});
      forces[1].push_back({neighbour.influence, answer->force[1]});
    }
  }
  return {neighbourDeflection(forces[0], cant_), neighbourDeflection(forces[1], cant_)};
}

/// Null if there is none, or the newest is too old.
const NeighbourForces::Answer* NeighbourForces::newestBefore(const Neighbour& neighbour, const ros::Time& stamp)
{
  const auto& answers = neighbour.answers;
  const auto after = std::lower_bound(answers.begin(), answers.end(), stamp,
                                      [](const Answer& answer, const ros::Time& t) { return answer.stamp < t; });
  if (after == answers.begin())
  {
    return nullptr;
  }
  const Answer& newest = *(after - 1);
  return stamp - newest.stamp <= ros::Duration(longest_age) ? &newest : nullptr;
}
}  // namespace wheel_rail_contact
