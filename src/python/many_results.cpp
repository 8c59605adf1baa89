// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <string>

#include "python/bindings.h"
#include "python/many_states.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
void bindMany(py::module& module)
{
  py::class_<ManyResults>(module, "ManyResults",
                          "Numbers of the results of n states. Arrays of both sides are (n, 2), left first; all are "
                          "read-only, and NaN where a result is not usable.")
      .def("__len__", [](const ManyResults& many) { return many.status.size(); })
      .def_property_readonly(
          "status",
          [](const ManyResults& many)
          {
            py::list names;
            for (const core::ContactStatus status : many.status)
            {
              names.append(nameOf(status));
            }
            return py::module::import("numpy").attr("array")(names, "U");
          },
          "(n,) names of the status")
      .def_property_readonly(
          "usable", [](const ManyResults& many) { return many.usable(); }, "(n,) True if the status is OK or LIFT_OFF")
      .def_readonly("status_text", &ManyResults::status_text, "list of n reasons, empty if there is none")
      .def_readonly("above_tolerance", &ManyResults::above_tolerance,
                    "(n,) the estimated error of a wheel is above contact/tolerance")
      .def_readonly("implausible_force", &ManyResults::implausible_force,
                    "(n,) the contact force of a wheel is above 1 MN")
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
