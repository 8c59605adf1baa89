// SPDX-License-Identifier: BSD-3-Clause
#include "../core/balance/wheelset_scene.h"
#include "scene.h"
#include "stability_map.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
/// Contacts whose pressures and creepages are the same for all methods.
struct FrictionCase
{
  std::string name;
  std::vector<CreepProblem> contacts;
};

double frictionLimit(const CreepProblem& contact)
{
  return contact.friction.coefficient * contact.normal_force;
}

/// Contacts of a rolling wheelset that carry at least a tenth of the load of a wheel.
FrictionCase rollingWheelset(const std::string& name, double y, double yaw)
{
  constexpr double load = 1e5;
  ContactModelConfig config = standard();
  config.creep.method = CreepMethod::exact;
  config.contact.cells_along = 24;
  config.contact.cells_across = 64;
  WheelsetState state = stateAt(y, load, yaw);
  state.motion.speed = 20;
  FrictionCase one{name, {}};
  for (const PatchResult& patch : WheelsetContact(config).evaluate(state).patches)
  {
    if (patch.normal_force > 0.1 * load)
    {
      CreepProblem problem;
      problem.creepage = patch.creep.creepage;
      problem.speed = state.motion.speed;
      problem.normal_force = patch.normal_force;
      problem.semi_axis_along = patch.semi_axis_along;
      problem.semi_axis_across = patch.semi_axis_across;
      problem.grid = patch.grid;
      problem.pressure = patch.pressure;
      one.contacts.push_back(problem);
    }
  }
  return one;
}

/// Ellipses with the pressure of Hertz. The unit of each creepage is that at which its linear force is the limit.
FrictionCase rollingEllipses(double ratio, const std::vector<Creepage>& creepages, const char* words)
{
  constexpr double axis = 6e-3;
  FrictionCase one{"a/b = " + digits(ratio) + ", " + words, {}};
  CreepProblem problem = ellipseProblem({axis * std::sqrt(ratio), axis / std::sqrt(ratio), 1e5, 48, 48}, {});
  const KalkerCoefficients c = kalkerCoefficients(ratio, problem.elasticity.poisson);
  const double unit = frictionLimit(problem) / (problem.elasticity.modulus * axis * axis);
  for (const Creepage& each : creepages)
  {
    problem.creepage = {each.x * unit / c.c11, each.y * unit / c.c22, each.spin * unit / (c.c23 * axis)};
    one.contacts.push_back(problem);
  }
  return one;
}

std::vector<FrictionCase> frictionCases()
{
  std::vector<FrictionCase> list{rollingWheelset("centred", 0, 0),
                                 rollingWheelset("yaw 2 mrad, y = 3 mm", 3e-3, 2e-3),
                                 rollingWheelset("sliding, yaw 5 mrad", 0, 5e-3),
                                 rollingWheelset("two points, yaw 2 mrad, y = 5 mm", 5e-3, 2e-3),
                                 rollingWheelset("flange, y = 7 mm", 7e-3, 0),
                                 rollingWheelset("flange, yaw -5 mrad, y = 7 mm", 7e-3, -5e-3)};
  for (const double ratio : {0.1, 1.0, 10.0})
  {
    list.push_back(
        rollingEllipses(ratio, {{0.3, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 0.3, 0}, {0, 1, 0}, {0, 3, 0}}, "no spin"));
    list.push_back(rollingEllipses(ratio, {{0, 0, 0.3}, {0, 1, 0.3}, {0, -1, 0.3}}, "spin"));
    list.push_back(rollingEllipses(ratio, {{0, 0, 3}, {1, 0, 3}, {0, 1, 3}, {0, -1, 3}}, "large spin"));
  }
  return list;
}

/// Largest errors of all contacts over the friction limit, in percent.
Verdict worstError(const FrictionCase& one, CreepMethod method)
{
  const std::unique_ptr<CreepSolver> solver = makeCreepSolver(method), exact = makeCreepSolver(CreepMethod::exact);
  CreepSolution found, truth;
  double force = 0, moment = 0;
  for (const CreepProblem& contact : one.contacts)
  {
    solver->solve(contact, false, found);
    exact->solve(contact, false, truth);
    const double percent = 1e-2 * frictionLimit(contact);
    const double arm = std::sqrt(contact.semi_axis_along * contact.semi_axis_across);
    force = std::max(force, std::hypot(found.force.x - truth.force.x, found.force.y - truth.force.y) / percent);
    moment = std::max(moment, std::abs(found.force.moment - truth.force.moment) / (arm * percent));
  }
  return Verdict("force")
      .with(Verdict::rounded(force, 1), " ")
      .with("%, moment", " ")
      .with(Verdict::rounded(moment, 1), " ")
      .with("%", " ");
}
}  // namespace

MapTable frictionMap()
{
  MapTable table{
      "Friction",
      "Largest errors of both friction forces, and of the moment over √(ab), over the friction limit. The "
      "reference is `exact` on the same pressures and creepages, with the friction coefficient 0.3. Wheelsets: as "
      "above at 20 m/s, with free rotation and 24 × 64 cells; patches with less than 10 kN are left out. Ellipses: "
      "pressure of Hertz on 48 × 48 cells; creepages up to three times that at which the linear force is the "
      "limit. The spin is 0.3 times the one at which the linear lateral force is the limit, large spin three times.",
      {toString(CreepMethod::linear), toString(CreepMethod::fastsim)},
      {}};
  for (const FrictionCase& one : frictionCases())
  {
    table.rows.push_back({one.name, {worstError(one, CreepMethod::linear), worstError(one, CreepMethod::fastsim)}});
  }
  return table;
}
}  // namespace wheel_rail_contact::core::stability
