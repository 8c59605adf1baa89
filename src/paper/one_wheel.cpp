// SPDX-License-Identifier: BSD-3-Clause
#include "paper/one_wheel.h"

#include <cmath>
#include <utility>

#include "core/balance/rail_support.h"

namespace wheel_rail_contact::core::paper
{
namespace
{
constexpr int most_passes = 20;
constexpr double remaining_approach = 1e-3;  ///< allowed difference from the height of the gap, over the overlap [-]
constexpr double clear_height = 0.1;         ///< above the rolling radius: the wheel is above the rail there [m]
constexpr int most_roll_steps = 20;
constexpr double height_difference = 1e-9;  ///< allowed difference of the axle heights of both sides [m]

ContactModelConfig checked(ContactModelConfig config)
{
  validate(config);
  return config;
}
}  // namespace

RailDeflection withCrownDisplaced(const RailDeflection& crown, double inclination)
{
  // The crown lies at the reference depth above the reference point, along the axis of the rail (-sin a, cos a) with
  // the inclination a.
  const double depth = ComplianceTable::reference_depth;
  const double turned = inclination - crown.roll;
  return {crown.lateral - depth * (std::sin(inclination) - std::sin(turned)),
          crown.vertical - depth * (std::cos(turned) - std::cos(inclination)), crown.roll};
}

OneWheel::OneWheel(ContactModelConfig config, NormalSolver& solver, const GridSize& size)
    : config_(checked(std::move(config))),
      undeflected_(restingRail(config_, Side::left)),
      contact_(config_, Side::left, undeflected_, solver)
{
  contact_.setGrid(0, size);
  contact_.setRail(undeflected_);
}

void OneWheel::displaceCrown(const RailDeflection& crown)
{
  contact_.setRail(undeflected_.deflected(withCrownDisplaced(crown, config_.track.rail_inclination.left)));
}

bool OneWheel::solve(double y, double roll, double load)
{
  contact_.forget();
  WheelsetPose pose{y, config_.wheelset.rolling_radius.left + clear_height, 0, roll};
  for (int pass = 0; pass < most_passes; ++pass)
  {
    if (contact_.solveLoad(pose, load) != WheelStatus::solved)
    {
      return false;
    }
    pose.z = contact_.height();
    if (std::abs(contact_.remaining()) < remaining_approach * contact_.overlap())
    {
      return true;
    }
  }
  return false;
}

Figures OneWheel::figures() const
{
  Figures sum{0, 0};
  for (const PatchPressure& patch : contact_.solution().patches)
  {
    sum.max_pressure = std::max(sum.max_pressure, patch.max_pressure);
    sum.area += patch.area;
  }
  return sum;
}

double OneWheel::countedArea() const
{
  double area = 0;
  for (const PatchPressure& patch : contact_.solution().patches)
  {
    area += static_cast<double>((patch.pressure > 0).count()) * patch.grid.cellArea();
  }
  return area;
}

double OneWheel::heightPerRoll()
{
  const MotionMatrix stiffness = contact_.stiffness();
  return -stiffness(wheel_up, wheel_roll) / stiffness(wheel_up, wheel_up);
}

bool rollToBalance(OneWheel& first, OneWheel& second, double y, double load, double& roll)
{
  roll = 0;
  for (int step = 0; step < most_roll_steps; ++step)
  {
    if (!first.solve(y, roll, load) || !second.solve(-y, -roll, load))
    {
      return false;
    }
    const double difference = first.height() - second.height();
    if (std::abs(difference) < height_difference)
    {
      return true;
    }
    roll -= difference / (first.heightPerRoll() + second.heightPerRoll());  // Newton step
  }
  return false;
}
}  // namespace wheel_rail_contact::core::paper
