// SPDX-License-Identifier: BSD-3-Clause
#include "paper/one_wheel.h"

#include <cmath>
#include <utility>

namespace wheel_rail_contact::core::paper
{
namespace
{
constexpr int most_passes = 20;
constexpr double plane_error = 1e-4;        ///< allowed angle between plane and pressure-weighted normal [rad]
constexpr double penetration_error = 1e-3;  ///< allowed difference from the penetration of the gap [-]
constexpr double least_fill = 0.8;          ///< smallest size of a pressure over its expected size [-]
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
      size_(size),
      undeflected_(config_.rail_profile, config_.track),
      contact_(config_, solver)
{
  contact_.setRail(undeflected_);
}

void OneWheel::displaceCrown(const RailDeflection& crown)
{
  contact_.setRail(undeflected_.deflected(withCrownDisplaced(crown, config_.track.rail_inclination)));
}

bool OneWheel::solve(double y, double roll, double load)
{
  contact_.reset();
  touch_ = contact_.touch({y, 0, 0, roll});
  for (int pass = 0; touch_.found && pass < most_passes; ++pass)
  {
    if (contact_.solveLoad(touch_, load, size_) != WheelStatus::solved)
    {
      return false;
    }
    if (contact_.planeError() < plane_error && std::abs(contact_.penetrationError()) < penetration_error &&
        (contact_.boxFill() > least_fill || contact_.widened()))
    {
      return true;
    }
    contact_.learn();
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

double OneWheel::height() const
{
  return touch_.axle_height - contact_.penetration();
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
    roll += difference / (first.contact().lever() + second.contact().lever());  // Newton step
  }
  return false;
}
}  // namespace wheel_rail_contact::core::paper
