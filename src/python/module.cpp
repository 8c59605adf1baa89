// SPDX-License-Identifier: BSD-3-Clause
// Python module wheel_rail_contact._core.
#include "python/bindings.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace
{
/// Classes that Python cannot construct get no empty object by `__new__` either. Base classes would pass this on.
void refuseEmptyObjects(const pybind11::module& module)
{
  const pybind11::cpp_function refuse([](const pybind11::args& /*any*/, const pybind11::kwargs& /*any*/)
                                      { throw pybind11::type_error("objects of this class are results"); });
  for (const auto& [name, value] : module.attr("__dict__").cast<pybind11::dict>())
  {
    const bool is_class = PyType_Check(value.ptr()) != 0 && PyObject_IsSubclass(value.ptr(), PyExc_Exception) == 0;
    if (is_class && Py_TYPE(value.attr("__init__").ptr()) == &PyWrapperDescr_Type &&
        pybind11::len(value.attr("__subclasses__")()) == 0)
    {
      pybind11::setattr(value, "__new__", pybind11::staticmethod(refuse));
    }
  }
}
}  // namespace

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
  refuseEmptyObjects(module);
}
