// SPDX-License-Identifier: BSD-3-Clause
#include "paper/forces.h"

#include <cmath>

#include "core/balance/rail_support.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "paper/one_wheel.h"
#include "paper/placement.h"

namespace wheel_rail_contact::core::paper
{
namespace
{
constexpr GridSize force_grid{32, 64};

/// Deflection in the track, from the table of the upright rail, for a lateral force at the height of the crown and the
/// wheel load. For DeflectionShare::shift_only, the lateral displacement by the lateral force only.
RailDeflection givenDeflection(const ComplianceTable& table, DeflectionShare share, double force, double inclination)
{
  const double moment = force * ComplianceTable::reference_depth;
  RailDeflection moved = deflectionInTrack(table, {force, printed_wheel_load, moment}, inclination);
  if (share == DeflectionShare::shift_only)
  {
    moved = deflectionInTrack(table, {force, 0, moment}, inclination);
    moved.vertical = 0;
    moved.roll = 0;
  }
  return moved;
}

/// Whole table: coupled balance of the wheelset.
std::vector<ForceRow> coupled(const ContactModelConfig& config, const NamedTable& table,
                              const std::vector<double>& positions, const std::vector<double>& forces)
{
  WheelsetContact contact(onTable(config, table));
  std::vector<ForceRow> rows;
  for (const double y : positions)
  {
    for (const double force : forces)
    {
      contact.reset();
      const WheelsetResult& result = contact.evaluate(stateUnder(y, force));
      rows.push_back(
          {table.name, DeflectionShare::whole, y, force, false, result.rail.left.deflection, leftFigures(result)});
    }
  }
  return rows;
}

/// A part of the deflection: known before the solution.
std::vector<ForceRow> given(const ContactModelConfig& config, const NamedTable& table, DeflectionShare share,
                            const std::vector<double>& positions, const std::vector<double>& forces)
{
  ConjugateGradients solver;
  OneWheel left(config, solver, force_grid);
  OneWheel right(config, solver, force_grid);
  const PlacedRail undeflected = restingRail(config, Side::left);
  std::vector<ForceRow> rows;
  for (const double y : positions)
  {
    for (const double force : forces)
    {
      const RailDeflection moved = givenDeflection(table.table, share, force, config.track.rail_inclination.left);
      left.setRail(undeflected.deflected(moved));
      right.setRail(undeflected.deflected(moved));
      double roll = 0;
      const bool solved = rollToBalance(left, right, y, printed_wheel_load, roll);
      rows.push_back({table.name, share, y, force, false, moved, solved ? left.figures() : Figures{0, 0}});
    }
  }
  return rows;
}
}  // namespace

bool isInRange(const NamedTable& table, double force)
{
  return std::abs(force) <= table.linear_range * printed_wheel_load;
}

ContactModelConfig onTable(const ContactModelConfig& config, const NamedTable& table)
{
  ContactModelConfig bending = config;
  bending.rail_bending.model = RailBendingConfig::Model::compliance;
  bending.rail_bending.table = table.table;
  bending.rail_bending.lateral_force = RailBendingConfig::LateralForce::topic;
  bending.contact = {NormalMethod::conjugate_gradient, config.contact.tolerance, force_grid.along, force_grid.across};
  return bending;
}

WheelsetState stateUnder(double y, double force)
{
  WheelsetState state;
  state.y = y;
  state.force_z = -2 * printed_wheel_load;
  state.rail_lateral_force = {force, force};
  return state;
}

const char* toString(DeflectionShare share)
{
  switch (share)
  {
    case DeflectionShare::whole:
      return "whole";
    case DeflectionShare::without_moment:
      return "without_moment";
    default:
      return "shift_only";
  }
}

std::vector<ForceRow> underForces(const ContactModelConfig& config, const NamedTable& table, DeflectionShare share,
                                  const std::vector<double>& positions, const std::vector<double>& forces)
{
  std::vector<ForceRow> rows = share == DeflectionShare::whole ? coupled(config, table, positions, forces)
                                                               : given(config, table, share, positions, forces);
  for (ForceRow& row : rows)
  {
    row.in_range = isInRange(table, row.lateral_force);
  }
  return rows;
}
}  // namespace wheel_rail_contact::core::paper
