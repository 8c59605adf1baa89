// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "python/timed_run.h"
#include "wheel_rail_contact/core/creep.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
/// A creep method on an ellipse with the pressure of Hertz. Its states are creepages. Every solution starts cold; the
/// tables of the grid are kept.
class CreepRun : public TimedRun
{
 public:
  /// @param creepages  x, y [-] and spin [1/m] of each state
  CreepRun(const std::string& method, const std::array<double, 3>& semi_axes_and_force, const std::array<int, 2>& cells,
           const std::vector<std::array<double, 3>>& creepages)
      : solver_(makeCreepSolver(core::creepMethodNamed(method)))
  {
    const auto& [a, b, force] = semi_axes_and_force;
    for (const auto& [x, y, spin] : creepages)
    {
      problems_.push_back(core::ellipseProblem({a, b, force, cells[0], cells[1]}, {x, y, spin}));
    }
  }

  void solve(std::size_t state) override
  {
    grid_ = {problems_.at(state).grid.nx, problems_.at(state).grid.ny};
    solver_->solve(problems_[state], false, solution_);
  }
  void reset() override {}

  /// There are no wheels.
  Outcome outcome() const override
  {
    const bool usable = isUsable(solution_.status);
    return {usable, usable ? "" : toString(solution_.status), grid_, solution_.error_estimate, {}};
  }

  /// Fx, Fy [N] and Mz [N m] on the wheel in the last solution.
  std::array<double, 3> force() const { return {solution_.force.x, solution_.force.y, solution_.force.moment}; }

 private:
  std::unique_ptr<core::CreepSolver> solver_;
  std::vector<core::CreepProblem> problems_;
  core::CreepSolution solution_;
  core::GridSize grid_;
};
}  // namespace

void bindTimedCreep(py::module& module)
{
  py::class_<CreepRun, TimedRun>(module, "CreepRun")
      .def(py::init<const std::string&, const std::array<double, 3>&, const std::array<int, 2>&,
                    const std::vector<std::array<double, 3>>&>())
      .def("force", &CreepRun::force);
}
}  // namespace wheel_rail_contact
