// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../manchester_scene.h"
#include "../../usual_headers.h"

namespace wheel_rail_contact::core
{
constexpr double wheel_load = 1e5;  ///< usual load of a wheel [N]

/// The model with a tolerance [-].
inline ContactModelConfig fineScene(double tolerance = 0.003)
{
  ContactModelConfig config = manchesterScene();
  config.contact.tolerance = tolerance;
  return config;
}

/// State at `y` [m] with the same load on each wheel [N], or with a torque [N m].
inline WheelsetState stateAt(double y, double load, double yaw = 0, double torque = 0)
{
  WheelsetState state;
  state.y = y;
  state.yaw = yaw;
  state.force_z = -2 * load;
  state.torque_x = torque;
  return state;
}

/// State with a given height and roll.
inline WheelsetState heldAt(double y, double z, double roll = 0)
{
  WheelsetState state;
  state.y = y;
  state.z = z;
  state.roll = roll;
  return state;
}

/// Result of a state. Any status but `ok` ends the test.
inline const WheelsetResult& okResult(WheelsetContact& contact, const WheelsetState& state)
{
  const WheelsetResult& result = contact.evaluate(state);
  if (result.status != ContactStatus::ok)
  {
    throw std::runtime_error(std::string(nameOf(result.status)) + " at y = " + std::to_string(state.y) + " m, yaw " +
                             std::to_string(state.yaw) + " rad: " + result.reason);
  }
  return result;
}

/// Largest relative difference of highest pressure, area and approach [-].
template <typename Contact>
double difference(const PatchResult& found, const Contact& exact)
{
  return std::max({std::abs(found.max_pressure / exact.max_pressure - 1), std::abs(found.area / exact.area - 1),
                   std::abs(found.approach / exact.approach - 1)});
}

/// Patches of a wheel.
inline std::vector<const PatchResult*> patchesOf(const WheelsetResult& result, Side side)
{
  std::vector<const PatchResult*> found;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      found.push_back(&patch);
    }
  }
  return found;
}

/// The patch with the highest pressure.
inline const PatchResult& highestOf(const std::vector<const PatchResult*>& patches)
{
  return **std::max_element(patches.begin(), patches.end(),
                            [](const PatchResult* a, const PatchResult* b)
                            { return a->max_pressure < b->max_pressure; });
}

/// Sums over the patches of a wheel.
struct WheelTotal
{
  int patches = 0;
  double vertical = 0;      ///< [N]
  double max_pressure = 0;  ///< largest [Pa]
  double area = 0;          ///< [m²]
};

inline WheelTotal wheelTotal(const WheelsetResult& result, Side side)
{
  WheelTotal total;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      ++total.patches;
      total.vertical += patch.normal_force * std::cos(patch.contact_angle);
      total.max_pressure = std::max(total.max_pressure, patch.max_pressure);
      total.area += patch.area;
    }
  }
  return total;
}
}  // namespace wheel_rail_contact::core
