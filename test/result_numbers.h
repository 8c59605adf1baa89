// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "config/result_fields.h"
#include "standard_headers.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

/// All numbers of a result with their names, for comparisons.
namespace wheel_rail_contact
{
using Number = std::function<void(const char* name, double value)>;

/// Visits the numbers among the fields of an object.
template <typename Object>
auto fieldsOf(const Object& object, const Number& number)
{
  return [&](const ResultField& field, const auto& member, const auto&)
  {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(member(object))>>)
    {
      number(field.name, static_cast<double>(member(object)));
    }
  };
}

inline void visitNumbers(const Eigen::ArrayXXd& array, const char* name, const Number& number)
{
  for (Eigen::Index i = 0; i < array.size(); ++i)
  {
    number(name, array(i));
  }
}

inline void visitNumbers(const core::PatchStress& stress, const Number& number)
{
  visitPeak(fieldsOf(stress.von_mises, number));
  visitPeak(fieldsOf(stress.shear, number));
  visitStress(fieldsOf(stress, number));
  for (const core::StressLayer& layer : stress.field)
  {
    number("layer", layer.depth);
    for (const Eigen::ArrayXXd& component : layer.components)
    {
      visitNumbers(component, "stress", number);
    }
  }
}

inline void visitNumbers(const core::PatchResult& patch, const Number& number)
{
  number("side", static_cast<double>(patch.side));
  for (const double coordinate : {patch.pose.x, patch.pose.y, patch.pose.z, patch.pose.angle, patch.pose.pitch})
  {
    number("pose", coordinate);
  }
  visitPatch(fieldsOf(patch, number));
  visitCreep(fieldsOf(patch.creep, number));
  visitNumbers(patch.wheel_stress, number);
  visitNumbers(patch.rail_stress, number);
  visitGrid(fieldsOf(patch.grid, number));
  visitNumbers(patch.pressure, "pressure", number);
}

inline void visitNumbers(const core::WheelsetResult& result, const Number& number)
{
  number("status", static_cast<double>(result.status));
  for (const bool flag : {result.above_tolerance, result.points_missing, result.implausible_force})
  {
    number("above_tolerance, points_missing, implausible_force", flag ? 1 : 0);
  }
  for (const double coordinate : {result.y, result.z, result.yaw, result.roll})
  {
    number("pose", coordinate);
  }
  visitNumbers(result.rail_wrench.force, "wrench: force", number);
  visitNumbers(result.rail_wrench.moment, "wrench: moment", number);
  for (const core::Side side : core::sides)
  {
    visitRail(fieldsOf(result.rail[side], number));
    visitWheel(fieldsOf(result.wheel[side], number));
  }
  visitNumbers(result.derivatives.forces.array(), "derivatives: forces", number);
  visitNumbers(result.derivatives.solution.array(), "derivatives: solution", number);
  for (const core::PatchResult& patch : result.patches)
  {
    visitNumbers(patch, number);
  }
}
}  // namespace wheel_rail_contact
