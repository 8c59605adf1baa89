// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/stress_conversions.h"

#include <stdexcept>
#include <string>

namespace wheel_rail_contact
{
namespace
{
StressPeak toMessage(const core::StressPeak& peak)
{
  StressPeak message;
  message.value = peak.value;
  message.x = peak.x;
  message.y = peak.y;
  message.depth = peak.depth;
  return message;
}

core::StressPeak fromMessage(const StressPeak& message)
{
  return {message.value, message.x, message.y, message.depth};
}

void addField(const std::vector<core::StressLayer>& field, PatchStress& message)
{
  for (const core::StressLayer& layer : field)
  {
    message.depths.push_back(layer.depth);
    for (const Eigen::ArrayXXd& component : layer.components)
    {
      const std::size_t begin = message.stress.size();
      message.stress.resize(begin + static_cast<std::size_t>(component.size()));
      Eigen::Map<Eigen::ArrayXXf>(message.stress.data() + begin, component.rows(), component.cols()) =
          component.cast<float>();
    }
  }
}
}  // namespace

PatchStress toMessage(const core::PatchStress& stress, bool with_field)
{
  PatchStress message;
  message.von_mises = toMessage(stress.von_mises);
  message.shear = toMessage(stress.shear);
  message.load_factor = stress.load_factor;
  message.shakedown_limit = stress.shakedown_limit;
  if (with_field)
  {
    addField(stress.field, message);
  }
  return message;
}

core::PatchStress fromMessage(const PatchStress& message, const core::PatchGrid& grid)
{
  core::PatchStress stress;
  stress.von_mises = fromMessage(message.von_mises);
  stress.shear = fromMessage(message.shear);
  stress.load_factor = message.load_factor;
  stress.shakedown_limit = message.shakedown_limit;
  const std::size_t components = std::tuple_size<decltype(core::StressLayer::components)>::value;
  const std::size_t cells = static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny);
  if (message.stress.size() != message.depths.size() * components * cells)
  {
    throw std::invalid_argument("stress field: " + std::to_string(message.stress.size()) + " values for " +
                                std::to_string(message.depths.size()) + " depths and a grid of " +
                                std::to_string(grid.nx) + " x " + std::to_string(grid.ny));
  }
  const float* values = message.stress.data();
  for (const double depth : message.depths)
  {
    core::StressLayer& layer = stress.field.emplace_back();
    layer.depth = depth;
    for (Eigen::ArrayXXd& component : layer.components)
    {
      component = Eigen::Map<const Eigen::ArrayXXf>(values, grid.nx, grid.ny).cast<double>();
      values += cells;
    }
  }
  return stress;
}
}  // namespace wheel_rail_contact
