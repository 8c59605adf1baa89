# SPDX-License-Identifier: BSD-3-Clause
"""Contact calculation of the closed loop in Python, for the example simulate_wheelset_python."""
import wheel_rail_contact

from ..command import Failure, shipped


CONFIG = "config/simulate_contact.yaml"


def open_contact(path=None):
    """WheelsetContact with the parameters of a YAML file, over config/default.yaml and config/simulate_contact.yaml.

    Raises Failure for parameters that are refused, or that expect another load or another state than the example sends.
    """
    try:
        contact = wheel_rail_contact.WheelsetContact([shipped(CONFIG), *([path] if path else [])])
    except (ImportError, ValueError) as error:
        raise Failure(error) from error
    config = contact.config
    _require(config, "wheelset/balance", "moments", "the load of this program is for it")
    _require(config, "wheelset/free", "[z, roll]", "this program does not integrate height and roll")
    _require(config, "creep/rotation", "free", "this program does not integrate the rotation")
    try:
        contact.evaluate(force_z=0.0, twist={"speed": 1.0})  # raises an error if others are required, or the twist is not
    except TypeError as error:
        raise Failure(f"{path}: this program has only x, y, yaw, twist and load: {error}") from error
    contact.reset()
    return contact


def _require(config, name, value, reason):
    if config[name] != value:
        raise Failure(f"{name} = {config[name]} must be {value}: {reason}")
