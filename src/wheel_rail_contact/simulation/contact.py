# SPDX-License-Identifier: BSD-3-Clause
"""Contact calculation of the closed loop in Python, for the example simulate_wheelset_python."""
import wheel_rail_contact

from ..command import Failure


def open_contact(path=None):
    """WheelsetContact with the parameters of a YAML file, over config/default.yaml.

    Raises Failure for parameters that are refused, or that expect another load or another state than the example sends.
    """
    try:
        contact = wheel_rail_contact.WheelsetContact(path or ())
    except (ImportError, ValueError) as error:
        raise Failure(error) from error
    config = contact.config
    if config["wheelset/balance"] != "wheel_loads":
        raise Failure(f"wheelset/balance = {config['wheelset/balance']} must be wheel_loads: the load of this program is for "
                      "it")
    if "z" not in config["wheelset/free"]:
        raise Failure(f"wheelset/free = {config['wheelset/free']} must be [z, roll]: this program does not integrate height "
                      "and roll")
    try:
        contact.evaluate(force_z=0.0)  # raises an error if further arguments are required
    except TypeError as error:
        raise Failure(f"{path}: this program has only x, y, yaw and load: {error}") from error
    contact.reset()
    return contact


def rolling_radius(contact):
    """Nominal rolling radius of a WheelsetContact, the mean of both wheels [m]."""
    config = contact.config
    return 0.5 * sum(float(config.get(f"wheel/{side}/rolling_radius", config["wheelset/rolling_radius"]))
                     for side in ("left", "right"))
