// SPDX-License-Identifier: BSD-3-Clause
#include "python/contact_model.h"

#include <ros/package.h>

#include <filesystem>

#include "ros/evaluation/contact_evaluator.h"
#include "ros/evaluation/text.h"

namespace wheel_rail_contact
{
std::string statusTextOf(const core::WheelsetResult& result, const core::Sides<double>& linear_range)
{
  return isUsable(result.status) ? sentences(result.reason, linearRangeWarning(result, linear_range)) : result.reason;
}

ContactModel::ContactModel(const std::vector<ParameterSource>& sources)
    : parameters_(readParameters(sources, {".", ros::package::getPath})),
      config_(readNodeConfig(parameters_, "", {std::filesystem::current_path().string(), ros::package::getPath})),
      contact_(config_.model)
{
}

core::WheelsetResult ContactModel::evaluate(const core::WheelsetState& state)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  core::WheelsetResult result = contact_.evaluate(state);
  result.reason = statusTextOf(result, config_.linear_range);
  return result;
}

Eigen::Matrix3d ContactModel::stiffness(core::Side side)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return contact_.stiffness(side);
}

void ContactModel::reset()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  contact_.reset();
}
}  // namespace wheel_rail_contact
