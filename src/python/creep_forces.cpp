// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <array>
#include <string>
#include <utility>

#include "core/option_check.h"
#include "python/bindings.h"
#include "wheel_rail_contact/core/creep.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using Numbers3 = std::array<double, 3>;

/// Of two bodies of one material.
core::ShearElasticity shearOf(double young, double poisson)
{
  core::requirePositive("young", young);
  core::require(poisson >= 0 && poisson <= 0.5, "poisson", poisson, "must be from 0 to 0.5");
  return shearElasticity(core::Material{young, poisson}, core::Material{young, poisson});
}

Numbers3 ellipseForce(const std::array<double, 2>& semi_axes, double normal_force, const Numbers3& creepage,
                      double friction, const std::string& method, double young, double poisson,
                      const std::array<int, 2>& cells)
{
  core::FrictionLaw law;
  law.coefficient = friction;
  const core::CreepForce force = ellipseCreepForce({semi_axes[0], semi_axes[1], normal_force, cells[0], cells[1]},
                                                   {creepage[0], creepage[1], creepage[2]},
                                                   core::creepMethodNamed(method), law, shearOf(young, poisson));
  return {force.x, force.y, force.moment};
}

/// C11, C22, C23, C33 in the rows, a column for each ratio.
Eigen::Array4Xd coefficientsOf(const Eigen::ArrayXd& ratios, double poisson)
{
  Eigen::Array4Xd table(4, ratios.size());
  for (Eigen::Index i = 0; i < ratios.size(); ++i)
  {
    const core::KalkerCoefficients c = core::kalkerCoefficients(ratios(i), poisson);
    table.col(i) << c.c11, c.c22, c.c23, c.c33;
  }
  return table;
}
}  // namespace

void bindCreepForces(py::module& module)
{
  py::list names;
  for (const core::CreepMethod method : core::all_creep_methods)
  {
    names.append(toString(method));
  }
  module.attr("CREEP_METHODS") = py::tuple(names);
  module.attr("DEFAULT_YOUNG") = core::Material{}.young;
  module.attr("DEFAULT_FRICTION") = core::FrictionLaw{}.coefficient;
  module.attr("ELLIPSE_CELLS") = std::make_pair(core::CreepEllipse{}.nx, core::CreepEllipse{}.ny);
  module.def("ellipse_creep_force", &ellipseForce, py::call_guard<py::gil_scoped_release>());
  module.def("kalker_coefficients", &coefficientsOf);
}
}  // namespace wheel_rail_contact
