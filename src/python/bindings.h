// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "config/result_fields.h"
#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact
{
/// Visitor of the fields of a result that adds each as a read-only property.
/// @param of gives the object of the core from that of Python
template <typename Class, typename Of>
auto propertiesOf(Class& bound, const Of& of)
{
  return [&bound, of](const ResultField& field, auto core, auto /*message*/)
  {
    const std::string unit = *field.unit == 0 ? "" : std::string(" [") + field.unit + "]";
    bound.def_property_readonly(
        field.name, [of, core](const typename Class::type& object) { return core(of(object)); },
        (field.text + unit).c_str());
  };
}

/// The same for an object of the core.
template <typename Class>
auto propertiesOf(Class& bound)
{
  return propertiesOf(
      bound, [](const typename Class::type& object) -> const auto& { return object; });
}

/// Profile for Python.
struct ReadProfile
{
  std::shared_ptr<const core::Profile> profile;  ///< not null
  std::string report;                            ///< what was understood of its file, in one line; may be empty
};

// Parts of the Python module. Its names are described for users in the Python package, which wraps them.

/// Adds the stress beneath a patch, and functions of stresses.
void bindStress(pybind11::module& module);
/// Adds creep forces of ellipses.
void bindCreepForces(pybind11::module& module);
/// Adds the classes of a result. The stress is added before.
void bindResults(pybind11::module& module);
/// Adds the results of many states.
void bindMany(pybind11::module& module);
/// Adds the class that evaluates states.
void bindContact(pybind11::module& module);
/// Adds profiles, compliance tables, tables of cells, and what the command check_profile requires.
void bindProfiles(pybind11::module& module);
/// Adds the contact geometry of rigid wheels and rails. The class that evaluates states is added before.
void bindGeometry(pybind11::module& module);
/// Adds what the command contact_chart times. The class that names parameters is added before.
void bindTiming(pybind11::module& module);
/// Adds one wheel on its rail, for the studies. The contact is added before.
void bindOneWheel(pybind11::module& module);
}  // namespace wheel_rail_contact
