// SPDX-License-Identifier: BSD-3-Clause
#include "python/many_states.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <system_error>

#include "python/bindings.h"
#include "python/contact_model.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using core::PatchResult;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::chrono::milliseconds between_checks{50};  ///< of an interruption

/// Patch of a side with the largest normal force, or null.
const PatchResult* mainPatch(const core::WheelsetResult& result, core::Side side)
{
  const PatchResult* found = nullptr;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side && (found == nullptr || patch.normal_force > found->normal_force))
    {
      found = &patch;
    }
  }
  return found;
}

/// Starts threads; fewer if the system has no more.
template <typename Work>
std::vector<std::future<void>> start(std::size_t threads, const Work& work)
{
  std::vector<std::future<void>> workers;
  try
  {
    while (workers.size() < threads)
    {
      workers.push_back(std::async(std::launch::async, work));
    }
  }
  catch (const std::system_error&)
  {
    if (workers.empty())
    {
      throw;
    }
  }
  return workers;
}

/// Names of the status as an array.
py::object namesOf(const ManyResults& many)
{
  py::list names;
  for (const core::ContactStatus status : many.status)
  {
    names.append(nameOf(status));
  }
  return py::module::import("numpy").attr("array")(names, "U");
}
}  // namespace

ManyResults::ManyResults(std::size_t count) : status(count), status_text(count)
{
  const auto rows = static_cast<Eigen::Index>(count);
  above_tolerance.setConstant(rows, 1, false);
  implausible_force.setConstant(rows, 1, false);
  z.setConstant(rows, nan);
  roll.setConstant(rows, nan);
  rotation.setConstant(rows, nan);
  patches.setZero(rows, 2);
  for (SideColumns* columns :
       {&vertical_force, &lateral_force, &friction_vertical_force, &friction_lateral_force, &adhesion_share,
        &friction_power, &max_pressure, &area, &error_estimate, &contact_angle, &rolling_radius, &mean_rolling_radius,
        &wheel_von_mises, &rail_von_mises, &rail_lateral, &rail_vertical, &rail_roll})
  {
    columns->setConstant(rows, 2, nan);
  }
}

Eigen::Array<bool, Eigen::Dynamic, 1> ManyResults::usable() const
{
  Eigen::Array<bool, Eigen::Dynamic, 1> flags(above_tolerance.rows());
  std::transform(status.begin(), status.end(), flags.data(),
                 [](core::ContactStatus each) { return core::isUsable(each); });
  return flags;
}

void ManyResults::set(std::size_t i, const core::WheelsetResult& result, const core::Sides<double>& linear_range)
{
  status[i] = result.status;
  status_text[i] = statusTextOf(result, linear_range);
  if (!results.empty())
  {
    results[i] = std::make_shared<core::WheelsetResult>(result);
    results[i]->reason = status_text[i];
  }
  if (!isUsable(result.status))
  {
    return;
  }
  const auto row = static_cast<Eigen::Index>(i);
  above_tolerance(row) = result.above_tolerance;
  implausible_force(row) = result.implausible_force;
  z(row) = result.z;
  roll(row) = result.roll;
  rotation(row) = result.rotation;
  for (const core::Side side : core::sides)
  {
    setSide(row, side, result);
  }
}

void ManyResults::setSide(Eigen::Index row, core::Side side, const core::WheelsetResult& result)
{
  const Eigen::Index column = side == core::Side::left ? 0 : 1;
  const core::WheelForces& wheel = result.wheel[side];
  const core::RailDeflection& rail = result.rail[side].deflection;
  vertical_force(row, column) = wheel.vertical;
  lateral_force(row, column) = wheel.lateral;
  friction_vertical_force(row, column) = wheel.friction_vertical;
  friction_lateral_force(row, column) = wheel.friction_lateral;
  rail_lateral(row, column) = rail.lateral;
  rail_vertical(row, column) = rail.vertical;
  rail_roll(row, column) = rail.roll;
  max_pressure(row, column) = area(row, column) = error_estimate(row, column) = 0;
  wheel_von_mises(row, column) = rail_von_mises(row, column) = 0;
  adhesion_share(row, column) = friction_power(row, column) = 0;
  double normal_force = 0, radius_moment = 0;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      normal_force += patch.normal_force;
      radius_moment += patch.normal_force * patch.rolling_radius;
      ++patches(row, column);
      max_pressure(row, column) = std::max(max_pressure(row, column), patch.max_pressure);
      area(row, column) += patch.area;
      error_estimate(row, column) = std::max(error_estimate(row, column), patch.error_estimate);
      adhesion_share(row, column) = std::max(adhesion_share(row, column), patch.creep.adhesion_share);
      friction_power(row, column) += patch.creep.power;
      wheel_von_mises(row, column) = std::max(wheel_von_mises(row, column), patch.wheel_stress.von_mises.value);
      rail_von_mises(row, column) = std::max(rail_von_mises(row, column), patch.rail_stress.von_mises.value);
    }
  }
  if (const PatchResult* patch = mainPatch(result, side))
  {
    contact_angle(row, column) = patch->contact_angle;
    rolling_radius(row, column) = patch->rolling_radius;
    mean_rolling_radius(row, column) = radius_moment / normal_force;
  }
}

ManyResults evaluateMany(const NodeConfig& config, const StateSequences& sequences, const ManyOptions& options,
                         const std::function<bool(std::size_t done)>& is_interrupted)
{
  const std::size_t count = sequences.ends.empty() ? 0 : sequences.ends.back();
  ManyResults results(count);  // each row is written by one thread
  results.results.resize(options.keep_results ? count : 0);
  std::atomic<std::size_t> next{0}, done{0};  // first sequence that no thread has taken, states
  std::atomic<bool> ended{false};
  const auto evaluate_sequence = [&](core::WheelsetContact& contact, std::size_t sequence)
  {
    contact.reset();
    for (std::size_t i = sequence == 0 ? 0 : sequences.ends[sequence - 1]; i < sequences.ends[sequence] && !ended; ++i)
    {
      results.set(i, contact.evaluate(sequences.state(i)), config.linear_range);
      ++done;
    }
  };
  const auto work = [&]
  {
    try
    {
      core::WheelsetContact contact(config.model);
      for (std::size_t sequence = next++; sequence < sequences.ends.size() && !ended; sequence = next++)
      {
        evaluate_sequence(contact, sequence);
      }
    }
    catch (...)
    {
      ended = true;
      throw;
    }
  };
  std::vector<std::future<void>> workers =
      start(std::min(static_cast<std::size_t>(options.threads), sequences.ends.size()), work);
  for (std::future<void>& worker : workers)
  {
    while (worker.wait_for(between_checks) != std::future_status::ready)
    {
      ended = ended || is_interrupted(done);
    }
  }
  for (std::future<void>& worker : workers)
  {
    worker.get();
  }
  is_interrupted(done);
  return results;
}

void bindMany(py::module& module)
{
  py::class_<ManyResults>(module, "ManyResults",
                          "Numbers of the results of n states. Arrays of both sides are (n, 2), left first; all are "
                          "read-only, and NaN where a result is not usable.")
      .def("__len__", [](const ManyResults& many) { return many.status.size(); })
      .def_property_readonly("status", &namesOf, "(n,) names of the status")
      .def_property_readonly(
          "usable", [](const ManyResults& many) { return many.usable(); }, "(n,) True if the status is OK or LIFT_OFF")
      .def_readonly("status_text", &ManyResults::status_text, "list of n reasons, empty if there is none")
      .def_readonly("above_tolerance", &ManyResults::above_tolerance,
                    "(n,) the estimated error of a wheel is above contact/tolerance")
      .def_readonly("implausible_force", &ManyResults::implausible_force,
                    "(n,) the contact force of a wheel is above 1 MN, of a model less")
      .def_readonly("z", &ManyResults::z, "(n,) height of the axle centre [m]")
      .def_readonly("roll", &ManyResults::roll, "(n,) roll of the axle, positive if left is raised [rad]")
      .def_readonly("patches", &ManyResults::patches, "(n, 2) number of patches")
      .def_readonly("rotation", &ManyResults::rotation,
                    "(n,) rotation about the axle, given or free [rad/s]; 0 without creep forces")
      .def_readonly("vertical_force", &ManyResults::vertical_force, "(n, 2) whole Q of the wheel, down positive [N]")
      .def_readonly("lateral_force", &ManyResults::lateral_force, "(n, 2) whole Y of the wheel, outward positive [N]")
      .def_readonly("friction_vertical_force", &ManyResults::friction_vertical_force,
                    "(n, 2) part of vertical_force by friction [N]")
      .def_readonly("friction_lateral_force", &ManyResults::friction_lateral_force,
                    "(n, 2) part of lateral_force by friction [N]")
      .def_readonly("adhesion_share", &ManyResults::adhesion_share,
                    "(n, 2) largest one of all patches [-]; 0 without creep forces")
      .def_readonly("friction_power", &ManyResults::friction_power, "(n, 2) power dissipated in all patches [W]")
      .def_readonly("max_pressure", &ManyResults::max_pressure, "(n, 2) highest pressure of all patches [Pa]")
      .def_readonly("area", &ManyResults::area, "(n, 2) contact area of all patches [m²]")
      .def_readonly("error_estimate", &ManyResults::error_estimate, "(n, 2) largest one of all patches [-]")
      .def_readonly("contact_angle", &ManyResults::contact_angle,
                    "(n, 2) of the patch with the largest normal force [rad]; NaN without a patch")
      .def_readonly("rolling_radius", &ManyResults::rolling_radius,
                    "(n, 2) of the patch with the largest normal force [m]; NaN without a patch")
      .def_readonly("mean_rolling_radius", &ManyResults::mean_rolling_radius,
                    "(n, 2) of all patches, weighted by their normal forces [m]; NaN without a patch")
      .def_readonly("wheel_von_mises", &ManyResults::wheel_von_mises,
                    "(n, 2) highest von Mises stress in the wheel [Pa]; 0 unless stress/depths is above 0")
      .def_readonly("rail_von_mises", &ManyResults::rail_von_mises,
                    "(n, 2) highest von Mises stress in the rail [Pa]; 0 unless stress/depths is above 0")
      .def_readonly("rail_lateral", &ManyResults::rail_lateral, "(n, 2) of the rail, outward positive [m]")
      .def_readonly("rail_vertical", &ManyResults::rail_vertical, "(n, 2) of the rail, up positive [m]")
      .def_readonly("rail_roll", &ManyResults::rail_roll, "(n, 2) of the rail, outward positive [rad]")
      .def_readonly("results", &ManyResults::results, "list of n WheelsetResult; empty unless results=True")
      .def("__repr__",
           [](const ManyResults& many)
           {
             const Eigen::Index usable = many.usable().count();
             return "<ManyResults: " + std::to_string(many.status.size()) + " states, " + std::to_string(usable) +
                    " usable>";
           });
}
}  // namespace wheel_rail_contact
