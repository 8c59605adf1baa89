# SPDX-License-Identifier: BSD-3-Clause
"""States for the core, from the arguments of evaluate() and evaluate_many()."""
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from .array_arguments import numbers_of
from .extension import core

ONE, MANY = False, True
# of one state; all others are numbers
SHAPES = {"rail_lateral_force": (2,), "rail_displacement": (2, 3), "rail_velocity": (2, 3)}
VELOCITIES = ("speed", "lateral_velocity", "vertical_velocity", "yaw_rate", "roll_rate", "rotation")  # of a twist
COLUMNS = {name: [i for i, column in enumerate(core.STATE_COLUMNS) if column == name] for name in core.STATE_COLUMNS}


class States(NamedTuple):
    """Numbers of n states."""
    count: int            # n
    common: np.ndarray    # (len(STATE_COLUMNS),) of all states
    columns: dict         # index in STATE_COLUMNS -> (n,) numbers that differ


def states_of(model, arguments, many):
    """States, from the arguments of an evaluation.

    model: ContactModel, whose parameters state which arguments are required
    arguments: name -> value as given; None: not given
    many: ONE permits only the values of one state, MANY also arrays with a first dimension n

    Raises TypeError, ValueError: see WheelsetContact.evaluate().
    """
    _check_given(model, arguments)
    if arguments["distance"] is None:
        arguments["distance"] = arguments["x"]
    arguments.update(_velocities(model, arguments.pop("twist")))
    plain = {name: value for name, value in arguments.items() if isinstance(value, float) and name not in SHAPES}
    arrays = {name: _array(name, value, many) for name, value in arguments.items() if value is not None and name not in plain}
    lengths = {name: len(array) for name, array in arrays.items() if array.ndim > len(SHAPES.get(name, ()))}
    states = States(_common(lengths), np.zeros(len(core.STATE_COLUMNS)), {})
    for name, array in arrays.items():
        columns = array.reshape(lengths.get(name, 1), len(COLUMNS[name])).T
        if name in lengths:
            states.columns.update(zip(COLUMNS[name], columns))
        else:
            states.common[COLUMNS[name]] = columns[:, 0]
    for name, value in plain.items():  # most arguments of most states: without arrays, which take longer
        states.common[COLUMNS[name][0]] = value
    return states


def ends_of(sequences, count):
    """Index after the last state of each sequence: an array of unsigned integers.

    sequences: see WheelsetContact.evaluate_many(). count: number of states
    Raises TypeError, ValueError.
    """
    lengths = np.asarray(1 if sequences is None else sequences)
    if lengths.dtype.kind not in "iu":
        raise TypeError(f"sequences = {sequences!r}: must be the length of each sequence, or an array of lengths")
    if lengths.ndim == 0 and lengths > 0 and count % lengths == 0:
        lengths = np.full(count // lengths, lengths)
    if lengths.ndim != 1 or np.any(lengths < 1) or lengths.sum() != count:
        raise ValueError(f"sequences = {sequences!r}: must be one length that divides the number of states, {count}, or "
                         "lengths above 0 with this sum")
    return np.cumsum(lengths, dtype=np.uintp)


def _check_given(model, arguments):
    needed = [("rail_displacement", model.requires_displacement, "track/displacement is topic"),
              ("distance", model.requires_distance, "track/distance is topic"),
              ("rail_lateral_force", model.takes_lateral_forces, "rail_bending/lateral_force is topic"),
              ("twist", model.takes_twist, "creep/method is not none")]
    needed += [("force_z", True, "height and roll are solved from the load: wheelset/free is [z, roll]")
               if model.solves_height_and_roll else ("z", True, "height and roll are given: wheelset/free is []")]
    for name, required, reason in needed:
        if required and arguments[name] is None:
            raise TypeError(f"{name} is missing: it is required, because {reason}")
    for name, remedy in unused(model).items():
        if arguments[name] is not None:
            raise ValueError(f"{name}: {remedy}")


def unused(model):
    """Arguments that the parameters do not permit: name -> what to do."""
    omit = "must be omitted, because it would not be used; set"
    remedies = {"rail_lateral_force": (model.takes_lateral_forces, "rail_bending/lateral_force to topic, and "
                                       "rail_bending/model to compliance"),
                "distance": (model.takes_distance, "track/line, sections of a rail, or track/distance to topic"),
                "twist": (model.takes_twist, "creep/method"), "rail_velocity": (model.takes_twist, "creep/method")}
    return {name: f"{omit} {remedy}" for name, (is_used, remedy) in remedies.items() if not is_used}


def _velocities(model, twist):
    """Velocities of a twist by name; empty without it."""
    if twist is None:
        return {}
    names = ", ".join(VELOCITIES)
    if not isinstance(twist, Mapping):
        raise TypeError(f"twist = {twist!r}: must be a dict of velocities, with some of the names {names}")
    given = {name: value for name, value in twist.items() if value is not None}
    for name in given:
        if name not in VELOCITIES:
            raise TypeError(f"twist: {name!r} is unknown; valid names are {names}")
    for name, required, reason in (("speed", True, "creep/method is not none"),
                                   ("rotation", model.requires_rotation, "creep/rotation is topic")):
        if required and name not in given:
            raise TypeError(f"twist: {name} is missing: it is required, because {reason}")
    return given


def _array(name, value, many):
    """Array of float with the shape of one state, or with n before it."""
    array = numbers_of(name, value, "a number" + (" or an array of numbers" if name in SHAPES else ""))
    shape = SHAPES.get(name, ())
    if array.shape != shape and not (many and array.shape[1:] == shape and array.ndim == len(shape) + 1):
        expected = "a number" if not shape else f"an array {shape}"
        raise ValueError(f"{name}: has the shape {array.shape}, but must be {expected}"
                         + (f" or an array {('n', *shape)}".replace("'n'", "n") if many else ""))
    return array


def _common(lengths):
    """The common length of all arrays; 1 without any."""
    found = sorted(set(lengths.values()))
    if len(found) > 1:
        texts = ", ".join(f"{name} has {length}" for name, length in lengths.items())
        raise ValueError(f"arrays must have the same length: {texts}")
    return found[0] if found else 1
