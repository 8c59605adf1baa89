// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/contact_geometry.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "core/state_check.h"
#include "python/bindings.h"
#include "python/contact_model.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using core::ContactGeometry;
using core::GeometryPoint;
using core::TouchPoint;

/// One row per position; NaN where there is no result.
using GeometryTable = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double no_result = std::numeric_limits<double>::quiet_NaN();

/// Numbers of a touch, in the order of touchTable().
constexpr Eigen::Index touch_numbers = 6;

GeometryTable pointTable(const ContactGeometry& geometry)
{
  GeometryTable table = GeometryTable::Constant(static_cast<Eigen::Index>(geometry.points.size()), 4, no_result);
  Eigen::Index row = 0;
  for (const GeometryPoint& point : geometry.points)
  {
    table(row, 0) = point.y;
    if (point.status == core::GeometryStatus::ok)
    {
      table.row(row).tail(3) << point.z, point.roll, point.radiusDifference();
    }
    ++row;
  }
  return table;
}

GeometryTable touchTable(const ContactGeometry& geometry, core::Side side)
{
  GeometryTable table =
      GeometryTable::Constant(static_cast<Eigen::Index>(geometry.points.size()), touch_numbers, no_result);
  Eigen::Index row = 0;
  for (const GeometryPoint& point : geometry.points)
  {
    if (point.status == core::GeometryStatus::ok)
    {
      const TouchPoint& touch = point.touch[side];
      table.row(row) << touch.y, touch.z, touch.wheel_y, touch.rail_y, touch.angle, touch.radius;
    }
    ++row;
  }
  return table;
}

/// Reasons of missing results of the positions; empty where there is a result.
std::vector<std::string> reasonsOf(const ContactGeometry& geometry)
{
  std::vector<std::string> reasons;
  for (const GeometryPoint& point : geometry.points)
  {
    reasons.emplace_back(point.status == core::GeometryStatus::ok ? "" : toString(point.status));
  }
  return reasons;
}

ContactGeometry geometryOf(const ContactModel& model, const core::ContactGeometryOptions& options)
{
  return core::contactGeometry(model.config().model, options);
}

/// Points of the rolling radius difference over the lateral displacement [m].
GeometryTable curveTable(const ContactGeometry& geometry)
{
  GeometryTable table(static_cast<Eigen::Index>(geometry.curve.size()), 2);
  Eigen::Index row = 0;
  for (const core::RadiusDifference& point : geometry.curve)
  {
    table.row(row++) << point.y, point.value;
  }
  return table;
}

/// Distance of the running circles [m], and the mean of both rolling radii [m].
std::tuple<double, double> runningCirclesOf(const core::WheelsetConfig& wheelset)
{
  return {2 * wheelset.halfBase(), wheelset.meanRadius()};
}
}  // namespace

void bindGeometry(py::module& module)
{
  using Released = py::call_guard<py::gil_scoped_release>;
  py::class_<ContactGeometry>(module, "ContactGeometry",
                              "Contact geometry over the lateral displacement. NaN: no result.")
      .def_property_readonly("points", &pointTable, "(n, 4) y, z [m], roll [rad], rolling radius difference [m]")
      .def(
          "touch",
          [](const ContactGeometry& geometry, const std::string& side) { return touchTable(geometry, sideOf(side)); },
          "(n, 6) of a side: y, z, y on the wheel, y on the rail [m], contact angle [rad], rolling radius [m]")
      .def_property_readonly("reasons", &reasonsOf, "list of n reasons of missing results, else empty")
      .def_property_readonly("curve", &curveTable,
                             "(m, 2) y and rolling radius difference [m], over the longest range with a result");
  module.def(
      "running_circles", [](const ContactModel& model) { return runningCirclesOf(model.config().model.wheelset); },
      "distance of the running circles, mean rolling radius [m]");
  module.def(
      "running_circles",
      [](const std::vector<ParameterSource>& sources)
      { return runningCirclesOf(readContactParameters(sources, fileSearch()).model.wheelset); },
      "as of a model, without the preparation of a contact");
  module.def(
      "load_doubt",
      [](const std::vector<ParameterSource>& sources, double mean)
      { return core::loadDoubt(mean, readContactParameters(sources, fileSearch()).model.wheelset); },
      "reason to doubt the unit or sign of loads with this mean wheel load, down positive [N]");
  module.def(
      "contact_geometry",
      [](const ContactModel& model, double y_first, double y_last, double y_step, bool roll, double distance) {
        return geometryOf(model, {y_first, y_last, y_step, roll, distance});
      },
      Released());
}
}  // namespace wheel_rail_contact
