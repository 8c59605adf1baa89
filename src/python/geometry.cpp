// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/contact_geometry.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

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

/// One row per position or amplitude; NaN where there is no result.
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

/// Equivalent conicity, wavelength and centre of the wave for each amplitude [m], and the reasons of missing results.
std::tuple<GeometryTable, std::vector<std::string>> conicityOf(const ContactGeometry& geometry,
                                                               const ContactModel& model,
                                                               const std::vector<double>& amplitudes)
{
  const core::WheelsetConfig& wheelset = model.config().model.wheelset;
  GeometryTable table = GeometryTable::Constant(static_cast<Eigen::Index>(amplitudes.size()), 3, no_result);
  std::vector<std::string> reasons(amplitudes.size());
  for (std::size_t i = 0; i < amplitudes.size(); ++i)
  {
    const core::EquivalentConicity conicity = equivalentConicity(geometry.curve, amplitudes[i]);
    if (conicity.status != core::ConicityStatus::ok)
    {
      reasons[i] = toString(conicity.status);
      continue;
    }
    const double wavelength = core::kinematicWavelength(conicity.value, 2 * wheelset.halfBase(), wheelset.meanRadius());
    table.row(static_cast<Eigen::Index>(i)) << conicity.value, wavelength, conicity.centre;
  }
  return {table, reasons};
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
      .def("conicity", &conicityOf,
           "for each amplitude [m] (equivalent conicity [-], wavelength [m], centre [m]), and the reasons", Released());
  module.def(
      "contact_geometry",
      [](const ContactModel& model, double y_first, double y_last, double y_step, bool roll, double distance) {
        return geometryOf(model, {y_first, y_last, y_step, roll, distance});
      },
      Released());
}
}  // namespace wheel_rail_contact
