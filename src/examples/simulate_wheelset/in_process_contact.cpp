// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/in_process_contact.h"

#include <ros/package.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "wheel_rail_contact/config_file.h"

namespace simulate_wheelset
{
namespace core = wheel_rail_contact::core;

namespace
{
ContactPoint pointOf(const core::PatchResult& patch, const core::WheelsetResult& result)
{
  ContactPoint point;
  point.is_left = patch.side == core::Side::left;
  point.position = {patch.pose.x, patch.pose.y - result.y, patch.pose.z - result.z};
  point.angle = patch.pose.angle;
  copySizes(patch, point);
  return point;
}

void requireSuitable(const wheel_rail_contact::ContactParameters& parameters)
{
  const core::WheelsetConfig& wheelset = parameters.model.wheelset;
  const core::RailBendingConfig& bending = parameters.model.rail_bending;
  const auto require = [](bool is_suitable, const char* text)
  {
    if (!is_suitable)
    {
      throw std::invalid_argument(text);
    }
  };
  require(wheelset.balance == core::WheelsetConfig::Balance::wheel_loads,
          "wheelset/balance = moments must be wheel_loads: the load of this program is for it");
  require(wheelset.solve_height_and_roll,
          "wheelset/free = [] must be [z, roll]: this program does not integrate height and roll");
  require(!parameters.displacement_topic,
          "track/displacement = topic must be none: this program does not move the rails");
  require(bending.model != core::RailBendingConfig::Model::compliance ||
              bending.lateral_force != core::RailBendingConfig::LateralForce::topic,
          "rail_bending/lateral_force = topic must be contact or a number: this program has no lateral forces");
  require(parameters.neighbours.empty(), "rail_bending/neighbours must be []: this program has one wheelset");
}
}  // namespace

InProcessContact::InProcessContact(core::ContactModelConfig config)
    : rolling_radius_(config.wheelset.meanRadius()), contact_(std::move(config))
{
}

ContactReply InProcessContact::evaluate(const ContactRequest& request)
{
  core::WheelsetState state;
  state.y = request.y;
  state.yaw = request.yaw;
  state.force_z = request.force_z;
  state.torque_x = request.torque_x;
  state.distance = request.distance;
  const core::WheelsetResult& result = contact_.evaluate(state);
  ContactReply reply;
  reply.is_usable = core::isUsable(result.status);
  reply.status = statusText(nameOf(result.status), result.reason);
  reply.z = result.z;
  reply.roll = result.roll;
  for (const core::PatchResult& patch : result.patches)
  {
    reply.points.push_back(pointOf(patch, result));
  }
  return reply;
}

core::ContactModelConfig readContact(const std::string& file)
{
  using wheel_rail_contact::ParameterSource;
  std::vector<ParameterSource> sources{{ParameterSource::file, wheel_rail_contact::default_parameters}};
  if (!file.empty())
  {
    sources.push_back({ParameterSource::file, file});
  }
  wheel_rail_contact::ContactParameters parameters =
      wheel_rail_contact::readContactParameters(sources, {".", ros::package::getPath});
  requireSuitable(parameters);
  return std::move(parameters.model);
}
}  // namespace simulate_wheelset
