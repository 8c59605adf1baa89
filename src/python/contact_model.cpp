// SPDX-License-Identifier: BSD-3-Clause
#include "python/contact_model.h"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "ros/evaluation/contact_evaluator.h"
#include "ros/evaluation/text.h"
#include "ros/parameters/file_names.h"

namespace wheel_rail_contact
{
ParameterTree readParameters(const std::vector<ParameterSource>& sources)
{
  ParameterTree tree;
  for (const ParameterSource& source : sources)
  {
    tree = overlay(tree, source.is_file ? readParameterFile(resolveFile(source.value, "."))
                                        : parameterTree(YAML::Load(source.value)));
  }
  return tree;
}

std::string statusTextOf(const core::WheelsetResult& result, const core::Sides<double>& linear_range)
{
  return isUsable(result.status) ? sentences(result.reason, linearRangeWarning(result, linear_range)) : result.reason;
}

ContactModel::ContactModel(ParameterTree parameters)
    : parameters_(std::move(parameters)),
      config_(readNodeConfig(parameters_, "", std::filesystem::current_path().string())),
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
