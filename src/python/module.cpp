// SPDX-License-Identifier: BSD-3-Clause
// Python module wheel_rail_contact._core.
#include "python/bindings.h"
#include "wheel_rail_contact/core/profile_reader.h"

PYBIND11_MODULE(_core, module)
{
  module.doc() = "Numerical core of wheel_rail_contact; used through the names of the package wheel_rail_contact.";
  pybind11::register_exception<wheel_rail_contact::core::FileError>(module, "ProfileError", PyExc_ValueError);
  wheel_rail_contact::bindStress(module);
  wheel_rail_contact::bindCreepForces(module);
  wheel_rail_contact::bindResults(module);
  wheel_rail_contact::bindMany(module);
  wheel_rail_contact::bindContact(module);
  wheel_rail_contact::bindProfiles(module);
  wheel_rail_contact::bindGeometry(module);
  wheel_rail_contact::bindTiming(module);
  wheel_rail_contact::bindOneWheel(module);
}
