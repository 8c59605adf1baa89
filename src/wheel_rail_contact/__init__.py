# SPDX-License-Identifier: BSD-3-Clause
"""Contact of wheels and rails.

For Python programs: WheelsetContact, read_profile, read_compliance_table, plot_pressure, plot_stress, to_array, functions of
stresses, ellipse_creep_force and kalker_coefficients; see doc/python.md. The subpackages belong to the commands.
"""
# Names and their modules. They are imported when they are used: commands start without numpy.
_MODULES = {
    "WheelsetContact": "contact",
    "ellipse_creep_force": "creep",
    "kalker_coefficients": "creep",
    "named_derivatives": "derivatives",
    "read_compliance_table": "profiles",
    "read_profile": "profiles",
    "plot_pressure": "pressure",
    "to_array": "pressure",
    "plot_stress": "stress_picture",
    "max_shear": "stress",
    "principal_stresses": "stress",
    "strain": "stress",
    "stress_at": "stress",
    "stress_layers": "stress",
    "von_mises": "stress",
}


def __getattr__(name):
    if name not in _MODULES:
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    import importlib
    return getattr(importlib.import_module(f"{__name__}.core.{_MODULES[name]}"), name)


def __dir__():
    return sorted({*globals(), *_MODULES})
