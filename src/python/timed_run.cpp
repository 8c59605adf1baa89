// SPDX-License-Identifier: BSD-3-Clause
#include "python/timed_run.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <ctime>

#include "python/bindings.h"
#include "python/contact_model.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
/// CPU time of this thread [s].
double threadTime()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// A result has one estimate for each patch, which holds for all of its quantities.
PatchOutcome outcomeOf(const core::PatchResult& patch)
{
  const double error = patch.error_estimate;
  return {{patch.max_pressure, patch.area, patch.normal_force}, patch.approach, {error, error, error}};
}

void addWheels(const std::vector<core::PatchResult>& patches, Outcome& outcome)
{
  for (const core::Side side : core::sides)
  {
    std::vector<PatchOutcome> own;
    for (const core::PatchResult& patch : patches)
    {
      if (patch.side == side)
      {
        const bool finer = patch.grid.nx * patch.grid.ny > outcome.grid.along * outcome.grid.across;
        outcome.grid = finer ? core::GridSize{patch.grid.nx, patch.grid.ny} : outcome.grid;
        own.push_back(outcomeOf(patch));
      }
    }
    outcome.add(static_cast<int>(side), own);
  }
}

/// A wheelset that keeps its solvers from scene to scene: preparing them costs more than many solutions.
using SharedWheelset = std::shared_ptr<core::WheelsetContact>;

core::ContactModelConfig modelOf(const std::vector<ParameterSource>& sources)
{
  return readContactParameters(sources, fileSearch()).model;
}

/// @param y  of the axle centre [m]
/// @param force_z  load on it, up positive [N]
core::WheelsetState stateAt(double y, double force_z)
{
  core::WheelsetState state;
  state.y = y;
  state.force_z = force_z;
  return state;
}

/// Whole calculation. Runs of one wheelset share its last result: only the latest run may be used.
class WheelsetRun : public TimedRun
{
 public:
  WheelsetRun(SharedWheelset wheelset, const std::vector<double>& y, double force_z) : wheelset_(std::move(wheelset))
  {
    for (const double each : y)
    {
      states_.push_back(stateAt(each, force_z));
    }
    wheelset_->reset();
  }

  void solve(std::size_t state) override { result_ = &wheelset_->evaluate(states_.at(state)); }
  void reset() override { wheelset_->reset(); }

  Outcome outcome() const override
  {
    Outcome outcome;
    outcome.usable = isUsable(result_->status);
    outcome.reason = outcome.usable ? "" : result_->reason;
    addWheels(result_->patches, outcome);
    return outcome;
  }

 private:
  SharedWheelset wheelset_;
  std::vector<core::WheelsetState> states_;
  const core::WheelsetResult* result_ = nullptr;
};

/// Reference solution of a wheelset by its balance itself, which accepts finer grids than WheelsetContact.
/// @param tolerance  of height and roll [-]
Outcome wheelsetReference(const std::vector<ParameterSource>& sources, const core::GridLevels& levels, double y,
                          double force_z, double tolerance)
{
  core::ContactModelConfig config = modelOf(sources);
  config.contact.tolerance = tolerance;
  core::WheelsetBalance balance(config, levels);
  Outcome outcome;
  outcome.usable = isUsable(balance.solve(stateAt(y, force_z)));
  outcome.reason = balance.reason();
  std::vector<core::PatchResult> patches;
  for (const core::Side side : core::sides)
  {
    const bool loaded = outcome.usable && balance.wheel(side).loaded();
    for (std::size_t k = 0; loaded && k < balance.islands(side).islands().size(); ++k)
    {
      fillPatch(side, balance, k, patches.emplace_back());
    }
  }
  addWheels(patches, outcome);
  return outcome;
}

void bindRuns(py::module& module)
{
  py::class_<WheelOutcome>(module, "WheelOutcome")
      .def_readonly("index", &WheelOutcome::index)
      .def_readonly("max_pressure", &WheelOutcome::max_pressure)
      .def_readonly("area", &WheelOutcome::area)
      .def_readonly("approach", &WheelOutcome::approach);
  py::class_<Outcome>(module, "Outcome")
      .def_readonly("usable", &Outcome::usable)
      .def_readonly("reason", &Outcome::reason)
      .def_property_readonly(
          "grid", [](const Outcome& outcome) { return std::make_pair(outcome.grid.along, outcome.grid.across); })
      .def_readonly("wheels", &Outcome::wheels)
      .def_readonly("estimate", &Outcome::estimate);
  py::class_<TimedRun>(module, "TimedRun")
      .def("solve", &TimedRun::solve)
      .def("reset", &TimedRun::reset)
      .def("outcome", &TimedRun::outcome)
      .def("time", &TimedRun::time, py::arg("states"), py::arg("cold") = false);
}

void bindTimedWheelsets(py::module& module)
{
  py::class_<core::WheelsetContact, SharedWheelset>(module, "TimedWheelset")
      .def(py::init([](const std::vector<ParameterSource>& sources)
                    { return std::make_shared<core::WheelsetContact>(modelOf(sources)); }));
  py::class_<WheelsetRun, TimedRun>(module, "WheelsetRun")
      .def(py::init<SharedWheelset, const std::vector<double>&, double>());
  module.def("wheelset_reference", &wheelsetReference);
}
}  // namespace

WheelOutcome combined(int index, const std::vector<PatchOutcome>& patches)
{
  core::ContactMeasures all;
  for (const PatchOutcome& patch : patches)
  {
    all.add(patch.measures);
  }
  WheelOutcome wheel{index, all.max_pressure, all.area, 0, 0};
  core::WheelError error(all);
  for (const PatchOutcome& patch : patches)
  {
    wheel.approach += patch.approach * patch.measures.force / all.force;
    error.add(patch.measures, patch.error);
  }
  wheel.estimate = error.largest();
  return wheel;
}

void Outcome::add(int index, const std::vector<PatchOutcome>& patches)
{
  if (!patches.empty())
  {
    wheels.push_back(combined(index, patches));
    estimate = std::max(estimate, wheels.back().estimate);
  }
}

double TimedRun::time(const std::vector<std::size_t>& states, bool cold)
{
  const double start = threadTime();
  for (const std::size_t state : states)
  {
    if (cold)
    {
      reset();
    }
    solve(state);
  }
  return (threadTime() - start) / static_cast<double>(states.size());
}

void bindTiming(py::module& module)
{
  module.attr("BUILD") = py::dict(py::arg("version") = CHART_VERSION, py::arg("compiler") = CHART_COMPILER,
                                  py::arg("build") = CHART_BUILD_TYPE);
  bindRuns(module);
  bindTimedSolvers(module);
  bindTimedWheelsets(module);
}
}  // namespace wheel_rail_contact
