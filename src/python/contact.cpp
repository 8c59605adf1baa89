// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings.h"
#include "python/contact_model.h"
#include "python/many_states.h"
#include "python/read_profile.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using core::WheelsetState;

/// Numbers of states: (n, number of stateFields()), one row per state.
using StateTable = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Number of a state with its name in the tables that Python fills.
struct StateField
{
  const char* name;
  std::function<double&(WheelsetState&)> of;
};

/// Columns of a table of states. Fields of both sides have two columns, left first; a displacement three on each side.
const std::vector<StateField>& stateFields()
{
  static const std::vector<StateField> fields{
      {"y", [](WheelsetState& s) -> double& { return s.y; }},
      {"z", [](WheelsetState& s) -> double& { return s.z; }},
      {"yaw", [](WheelsetState& s) -> double& { return s.yaw; }},
      {"roll", [](WheelsetState& s) -> double& { return s.roll; }},
      {"force_z", [](WheelsetState& s) -> double& { return s.force_z; }},
      {"torque_x", [](WheelsetState& s) -> double& { return s.torque_x; }},
      {"x", [](WheelsetState& s) -> double& { return s.x; }},
      {"distance", [](WheelsetState& s) -> double& { return s.distance; }},
      {"rail_lateral_force", [](WheelsetState& s) -> double& { return s.rail_lateral_force.left; }},
      {"rail_lateral_force", [](WheelsetState& s) -> double& { return s.rail_lateral_force.right; }},
      {"rail_displacement", [](WheelsetState& s) -> double& { return s.rail_displacement.left.lateral; }},
      {"rail_displacement", [](WheelsetState& s) -> double& { return s.rail_displacement.left.vertical; }},
      {"rail_displacement", [](WheelsetState& s) -> double& { return s.rail_displacement.left.roll; }},
      {"rail_displacement", [](WheelsetState& s) -> double& { return s.rail_displacement.right.lateral; }},
      {"rail_displacement", [](WheelsetState& s) -> double& { return s.rail_displacement.right.vertical; }},
      {"rail_displacement", [](WheelsetState& s) -> double& { return s.rail_displacement.right.roll; }},
  };
  return fields;
}

std::vector<std::string> stateColumns()
{
  std::vector<std::string> names;
  for (const StateField& field : stateFields())
  {
    names.emplace_back(field.name);
  }
  return names;
}

std::vector<WheelsetState> statesOf(const StateTable& table)
{
  if (table.cols() != static_cast<Eigen::Index>(stateFields().size()))
  {
    throw std::invalid_argument("states: must have a column for each of STATE_COLUMNS");
  }
  std::vector<WheelsetState> states(static_cast<std::size_t>(table.rows()));
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    Eigen::Index column = 0;
    for (const StateField& field : stateFields())
    {
      field.of(states[i]) = table(static_cast<Eigen::Index>(i), column++);
    }
  }
  return states;
}

core::WheelsetResult evaluate(ContactModel& model, const StateTable& table)
{
  return model.evaluate(statesOf(table).at(0));
}

/// Evaluates many states without the interpreter. Ctrl-C ends the evaluation.
ManyResults evaluateStates(const ContactModel& model, const StateTable& table, int threads, bool keep_results)
{
  bool interrupted = false;
  const auto is_interrupted = [&interrupted]
  {
    const py::gil_scoped_acquire interpreter;
    interrupted = PyErr_CheckSignals() != 0;
    return interrupted;
  };
  ManyResults results(0);
  {
    const py::gil_scoped_release released;
    results = evaluateMany(model.config(), statesOf(table), {threads, keep_results}, is_interrupted);
  }
  if (interrupted)
  {
    throw py::error_already_set();
  }
  return results;
}

/// Profiles of both sides, left first; None for a rail with sections.
py::tuple profilesOf(const core::Sides<std::shared_ptr<const core::Profile>>& profiles)
{
  const auto profile = [](const std::shared_ptr<const core::Profile>& of_side) -> py::object {
    return of_side ? py::cast(ReadProfile{of_side, ""}) : py::none();
  };
  return py::make_tuple(profile(profiles.left), profile(profiles.right));
}

py::dict textsOf(const ParameterTree& parameters)
{
  py::dict texts;
  for (const auto& [name, value] : parameters)
  {
    texts[py::str(name)] = value.IsScalar() ? value.Scalar() : YAML::Dump(value);
  }
  return texts;
}

void bindModel(py::module& module)
{
  using Released = py::call_guard<py::gil_scoped_release>;
  using LateralForce = core::RailBendingConfig::LateralForce;
  py::class_<ParameterSource>(module, "ParameterSource")
      .def(py::init(
          [](bool is_file, std::string value) {
            return ParameterSource{is_file ? ParameterSource::file : ParameterSource::text, std::move(value)};
          }));
  py::class_<ContactModel>(module, "ContactModel")
      .def(py::init<const std::vector<ParameterSource>&>())
      .def("evaluate", &evaluate, Released())
      .def("evaluate_many", &evaluateStates)
      .def(
          "stiffness", [](ContactModel& model, const std::string& side) { return model.stiffness(sideOf(side)); },
          Released())
      .def("reset", &ContactModel::reset, Released())
      .def_property_readonly("parameters", [](const ContactModel& model) { return textsOf(model.parameters()); })
      .def_property_readonly("notes", [](const ContactModel& model) { return model.config().notes; })
      .def_property_readonly("wheel_profiles",
                             [](const ContactModel& model) { return profilesOf(model.config().model.wheel_profile); })
      .def_property_readonly("rail_profiles",
                             [](const ContactModel& model) { return profilesOf(model.config().model.rail_profile); })
      .def_property_readonly("solves_height_and_roll", [](const ContactModel& model)
                             { return model.config().model.wheelset.solve_height_and_roll; })
      .def_property_readonly("takes_lateral_forces",
                             [](const ContactModel& model)
                             {
                               const core::RailBendingConfig& bending = model.config().model.rail_bending;
                               return bending.model == core::RailBendingConfig::Model::compliance &&
                                      bending.lateral_force == LateralForce::topic;
                             })
      .def_property_readonly("requires_displacement",
                             [](const ContactModel& model) { return model.config().displacement_topic; })
      .def_property_readonly("requires_distance",
                             [](const ContactModel& model) { return model.config().distance_topic; })
      .def_property_readonly("has_neighbours",
                             [](const ContactModel& model) { return !model.config().neighbours.empty(); });
}
}  // namespace

core::Side sideOf(const std::string& name)
{
  for (const core::Side side : core::sides)
  {
    if (name == nameOf(side))
    {
      return side;
    }
  }
  throw std::invalid_argument("side = '" + name + "': must be 'left' or 'right'");
}

void bindContact(py::module& module)
{
  module.attr("STATE_COLUMNS") = stateColumns();
  bindModel(module);
}
}  // namespace wheel_rail_contact
