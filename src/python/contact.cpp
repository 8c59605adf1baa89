// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <ros/package.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "config/compliance_table_file.h"
#include "config/text.h"
#include "python/bindings.h"
#include "python/contact_model.h"
#include "python/many_states.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using core::WheelsetState;

/// Numbers of a state with the names of their columns in the tables that Python fills. Fields of both sides have two
/// columns, left first; a displacement and its velocity three on each side.
std::vector<std::pair<std::string, double*>> stateFields(WheelsetState& s)
{
  auto& [left, right] = s.rail_displacement;
  auto& [left_velocity, right_velocity] = s.rail_velocity;
  return {
      {"y", &s.y},
      {"z", &s.z},
      {"yaw", &s.yaw},
      {"roll", &s.roll},
      {"pitch", &s.pitch},
      {"force_z", &s.force_z},
      {"torque_x", &s.torque_x},
      {"x", &s.x},
      {"distance", &s.distance},
      {"rail_lateral_force", &s.rail_lateral_force.left},
      {"rail_lateral_force", &s.rail_lateral_force.right},
      {"rail_displacement", &left.lateral},
      {"rail_displacement", &left.vertical},
      {"rail_displacement", &left.roll},
      {"rail_displacement", &right.lateral},
      {"rail_displacement", &right.vertical},
      {"rail_displacement", &right.roll},
      {"rail_velocity", &left_velocity.lateral},
      {"rail_velocity", &left_velocity.vertical},
      {"rail_velocity", &left_velocity.roll},
      {"rail_velocity", &right_velocity.lateral},
      {"rail_velocity", &right_velocity.vertical},
      {"rail_velocity", &right_velocity.roll},
      {"speed", &s.motion.speed},
      {"lateral_velocity", &s.motion.lateral_velocity},
      {"vertical_velocity", &s.motion.vertical_velocity},
      {"yaw_rate", &s.motion.yaw_rate},
      {"roll_rate", &s.motion.roll_rate},
      {"rotation", &s.motion.rotation},
  };
}

std::vector<std::string> stateColumns()
{
  std::vector<std::string> names;
  WheelsetState any;
  for (const auto& [name, number] : stateFields(any))
  {
    names.push_back(name);
  }
  return names;
}

/// Numbers of a state, one for each of stateColumns(), and of many states the columns that differ, by their index.
struct StateTable
{
  Eigen::ArrayXd common;
  std::map<std::size_t, Eigen::ArrayXd> columns;
};

WheelsetState stateOf(const StateTable& table, std::size_t row)
{
  WheelsetState state;
  const auto fields = stateFields(state);
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    *fields[i].second = table.common(static_cast<Eigen::Index>(i));
  }
  for (const auto& [i, column] : table.columns)
  {
    *fields[i].second = column(static_cast<Eigen::Index>(row));
  }
  return state;
}

core::WheelsetResult evaluate(ContactModel& model, const Eigen::ArrayXd& numbers)
{
  return model.evaluate(stateOf({numbers, {}}, 0));
}

/// Evaluates sequences of states, with their ends, without the interpreter. Ctrl-C ends the evaluation, and an
/// exception of `progress(done, count)`, which may be None.
ManyResults evaluateStates(const ContactModel& model, const Eigen::ArrayXd& common,
                           std::map<std::size_t, Eigen::ArrayXd> columns,
                           const Eigen::Array<std::size_t, Eigen::Dynamic, 1>& ends, int threads, bool keep_results,
                           const py::object& progress)
{
  bool interrupted = false;
  const std::size_t count = ends.size() == 0 ? 0 : ends.tail<1>()(0);
  const auto is_interrupted = [&](std::size_t done)
  {
    const py::gil_scoped_acquire interpreter;
    try
    {
      if (!interrupted && PyErr_CheckSignals() == 0 && !progress.is_none())
      {
        progress(done, count);
      }
    }
    catch (py::error_already_set& error)
    {
      error.restore();
    }
    interrupted = PyErr_Occurred() != nullptr;
    return interrupted;
  };
  ManyResults results(0);
  {
    const py::gil_scoped_release released;
    const StateTable table{common, std::move(columns)};
    const StateSequences sequences{[&table](std::size_t i) { return stateOf(table, i); },
                                   {ends.data(), ends.data() + ends.size()}};
    results = evaluateMany(model.config(), sequences, {threads, keep_results}, is_interrupted);
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
      .def_property_readonly("notes", [](const ContactModel& model) { return model.config().remarks(); })
      .def_property_readonly("has_design",
                             [](const ContactModel& model)
                             {
                               const core::TrackLine* line = model.config().model.track.line.get();
                               return line != nullptr && line->hasDesign();
                             })
      .def_property_readonly("warnings", [](const ContactModel& model) { return model.config().warnings; })
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
      .def_property_readonly("takes_distance",
                             [](const ContactModel& model)
                             {
                               const core::ContactModelConfig& config = model.config().model;
                               return model.config().distance_topic || config.track.line || config.rail_sections.left ||
                                      config.rail_sections.right;
                             })
      .def_property_readonly("takes_twist", [](const ContactModel& model)
                             { return model.config().model.creep.method != core::CreepMethod::none; })
      .def_property_readonly("requires_rotation", [](const ContactModel& model)
                             { return model.config().model.creep.rotation == core::CreepConfig::Rotation::given; })
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

FileSearch fileSearch()
{
  return {".", ros::package::getPath};
}

std::string statusTextOf(const core::WheelsetResult& result, const core::Sides<double>& linear_range)
{
  return isUsable(result.status) ? sentences(result.reason, linearRangeWarning(result, linear_range)) : result.reason;
}

ContactModel::ContactModel(const std::vector<ParameterSource>& sources)
    : parameters_(readParameters(sources, fileSearch())),
      config_(readNodeConfig(parameters_, "", fileSearch())),
      contact_(config_.model)
{
}

core::WheelsetResult ContactModel::evaluate(const core::WheelsetState& state)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  core::WheelsetResult result = contact_.evaluate(state);
  result.reason = statusTextOf(result, config_.linear_range);
  return result;
}

Eigen::Matrix3d ContactModel::stiffness(core::Side side)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return contact_.stiffness(side);
}

void ContactModel::reset()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  contact_.reset();
}

void bindContact(py::module& module)
{
  module.attr("STATE_COLUMNS") = stateColumns();
  bindModel(module);
}
}  // namespace wheel_rail_contact
