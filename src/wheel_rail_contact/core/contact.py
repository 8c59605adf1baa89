# SPDX-License-Identifier: BSD-3-Clause
"""Contact of a wheelset with both rails, from its parameters and states."""
import json
import numbers
import os
import warnings
from collections.abc import Mapping

import numpy as np

from ..command import shipped
from ..progress import counted
from .extension import core
from .states import MANY, ONE, ends_of, states_of

MOST_THREADS = 1024
DEEPEST = 16        # nested groups of parameters
NO_STATE = ("self", "sequences", "threads", "results", "progress")  # arguments of evaluate_many()


class WheelsetContact:
    """Contact of one wheelset with both rails.

    All quantities are in SI units and radians. Track frame: x forward, y left, z up; z = 0 at the tops of undeflected rails.
    An object may be used by several threads; their calls wait for each other.
    """

    def __init__(self, config=()):
        """Reads the parameters of the node, which config/default.yaml lists, and checks them as the node does.

        config: name of a YAML file (str or path), dict of groups and values, or list of such. Each is applied over those
            before, and all over config/default.yaml. Files are found as by contact_replay.

        Raises ValueError with the name of the parameter, its value and the broken rule, and TypeError for a config that is
        none of these.
        """
        self._model = core.ContactModel(sources(config))
        for text in self._model.warnings:
            warnings.warn(text, stacklevel=2)
        if self._model.has_neighbours:
            warnings.warn("rail_bending/neighbours is not used: give the displacement by other wheelsets as rail_displacement",
                          stacklevel=2)

    def evaluate(self, *, y=0.0, yaw=0.0, force_z=None, torque_x=0.0, z=None, roll=0.0, x=0.0, distance=None,
                 rail_lateral_force=None, rail_displacement=None, twist=None, rail_velocity=None, pitch=0.0):
        """Evaluates one state. The calculation starts from the previous result, which saves time; see reset().

        y: lateral displacement of the axle centre, to the left positive [m]
        yaw: rotation of the axle about z, positive to the left [rad]
        force_z: vertical force on the axle centre, up positive [N]: that of the vehicle and the weight of the wheelset, both
            negative. Required if height and roll are solved from the load (wheelset/free: [z, roll]), else not used
        torque_x: moment on the axle centre about x [N m]; a positive moment unloads the left wheel. Not used if height and
            roll are given. With creep/method, force_z and torque_x do not contain the friction of the contacts
        z: height of the axle centre [m]. Required if height and roll are given (wheelset/free: []), else not used
        roll: rotation of the axle about x, positive if the left wheel is raised [rad], at most 0.2. Not used if it is solved
        x: position of the axle centre along the track, copied to the result [m]
        distance: place on the line, and on rails with sections [m]; default: x. Required with track/distance: topic, refused
            without this, a line or sections
        rail_lateral_force: (left, right) lateral forces on the rails, outward positive [N]. Required with
            rail_bending/lateral_force: topic and a compliance table, else refused
        rail_displacement: (2, 3) displacement of the rails besides their deflection: rows left, right; columns lateral (outward
            positive) [m], vertical (up positive) [m], roll (positive if the crown moves outward) [rad]. Required with
            track/displacement: topic
        twist: dict of velocities of the axle, track axes: {"speed": 20.0}. Required with creep/method, else refused
            speed: of the axle centre along the track, forward positive [m/s]; required. Below 0.01 m/s of either sign there
                are no creep forces
            lateral_velocity: of the axle centre, to the left [m/s]; default: 0
            vertical_velocity: of the axle centre, up [m/s]; default: zero. Not used if the height is
                solved
            yaw_rate: about z [rad/s]; default: 0
            roll_rate: about x [rad/s]; default: 0. Not used if the roll is solved
            rotation: about the axle, positive when it rolls forward [rad/s]. Required with creep/rotation: topic, else not used
        rail_velocity: (2, 3) velocities of the rails by their vibration; rows and columns as in rail_displacement [m/s, m/s,
            rad/s]; default: 0. Refused without creep/method
        pitch: rotation about the axle, positive as it rolls forward [rad]; used only with wheels that are not round

        Returns a WheelsetResult: a value of its own, which later calls do not change. A state that is out of range, or
        without a solution, is no error: see its status and status_text.

        Raises TypeError if a required argument is missing, or one is not a number; ValueError for a wrong shape, or an
        argument that the parameters do not permit.
        """
        arguments = {name: value for name, value in locals().items() if name != "self"}
        return self._model.evaluate(states_of(self._model, arguments, ONE).common)

    def evaluate_many(self, *, y=0.0, yaw=0.0, force_z=None, torque_x=0.0, z=None, roll=0.0, x=0.0, distance=None,
                      rail_lateral_force=None, rail_displacement=None, twist=None, rail_velocity=None, pitch=0.0,
                      sequences=None, threads=None, results=False, progress=False):
        """Evaluates n states on several threads, without the lock of the interpreter. Ctrl-C ends the evaluation.

        Each state starts cold, as after reset(), or from the one before it in its sequence, as in a loop of evaluate(). A
        result depends neither on other sequences nor on the number of threads. The previous result of evaluate() stays as it is.

        y, yaw, ...: as in evaluate(). Numbers, or arrays (n,), all with the same n; rail_lateral_force (2,) or (n, 2);
            rail_displacement and rail_velocity (2, 3) or (n, 2, 3); in twist numbers or (n,)
        sequences: the length of all sequences of neighbouring states, or an array of their lengths; a sequence runs on one
            thread. Default: each state is one
        threads: number of threads, 1 to 1024; default: that of the processor cores
        results: True keeps the WheelsetResult of each state, with the pressures, in `results`
        progress: True shows the progress on standard error; a function is called with the numbers of states done and of all,
            up to twenty times a second and at the end. Its exception ends the evaluation

        Returns ManyResults: arrays of the numbers of all states. Raises as evaluate().
        """
        arguments = {name: value for name, value in locals().items() if name not in NO_STATE}
        count, *numbers = states_of(self._model, arguments, MANY)
        ends = ends_of(sequences, count)
        with counted(progress, "states") as report:
            return self._model.evaluate_many(*numbers, ends, _threads(threads), bool(results), report)

    def reset(self):
        """Discards the previous result: the next evaluation starts cold."""
        self._model.reset()

    def stiffness(self, side):
        """Stiffness of the contact of one wheel in the last result of evaluate(), with the rail held.

        side: "left" or "right"

        Returns (3, 3), symmetric: how the force along y [N], the force along z [N] and the moment about x [N m] of the rail on
        the wheelset fall per movement of the axle along y [m], along z [m] and about x [rad]. Zero if the wheel carries no
        load or the last result is not usable. Raises ValueError for another side.
        """
        return self._model.stiffness(side)

    @property
    def config(self):
        """Parameters by full name, as text: {"wheel/profile": "S1002", ...}. They include those of config/default.yaml."""
        return self._model.parameters

    @property
    def notes(self):
        """What was understood of each profile file, and warnings, one line each."""
        return self._model.notes

    @property
    def has_design(self):
        """Whether track/line has curvature, cant or gradient (doc/curves.md)."""
        return self._model.has_design

    @property
    def wheel_profiles(self):
        """(left, right) Profile of the wheels."""
        return self._model.wheel_profiles

    @property
    def rail_profiles(self):
        """(left, right) Profile of the upright rails; None for a rail whose profile changes along the line."""
        return self._model.rail_profiles

    def __repr__(self):
        names = [", ".join(sorted({profile.name if profile else "sections" for profile in pair}))
                 for pair in (self.wheel_profiles, self.rail_profiles)]
        return f"<WheelsetContact: wheels {names[0]}, rails {names[1]}, method {self.config['contact/method']}>"


def sources(config=()):
    """Parameters for the extension module: those of `config` over config/default.yaml; see WheelsetContact."""
    items = [config] if isinstance(config, (str, os.PathLike, Mapping)) else config
    if not isinstance(items, (list, tuple)):
        raise TypeError(f"config = {config!r}: must be the name of a file, a dict, or a list of these")
    return [_source(item) for item in (shipped("config/default.yaml"), *items)]


def _source(item):
    if isinstance(item, Mapping):
        if _depth(item) > DEEPEST:
            raise ValueError(f"config: has more than {DEEPEST} nested groups")
        return core.ParameterSource(False, json.dumps(item, default=_plain, ensure_ascii=False))
    if isinstance(item, (str, os.PathLike)):
        return core.ParameterSource(True, os.fspath(item))
    raise TypeError(f"config: {item!r} must be the name of a file or a dict")


def _depth(item):
    """Number of nested groups and lists; no more than one above the permitted one is counted."""
    depth, level = 0, [item]
    while level and depth <= DEEPEST:
        depth += 1
        level = [entry for group in level for entry in (group.values() if isinstance(group, Mapping) else group)
                 if isinstance(entry, (Mapping, list, tuple))]
    return depth


def _plain(value):
    """A value that JSON does not know, as one that it knows."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, numbers.Integral):
        return int(value)
    if isinstance(value, numbers.Real):
        return float(value)
    if isinstance(value, Mapping):
        return dict(value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    raise TypeError(f"config: {value!r} cannot be the value of a parameter")


def _threads(threads):
    if threads is None:
        return min(len(os.sched_getaffinity(0)), MOST_THREADS)
    if isinstance(threads, bool) or not isinstance(threads, numbers.Integral):
        raise TypeError(f"threads = {threads!r}: must be an integer")
    if not 1 <= threads <= MOST_THREADS:
        raise ValueError(f"threads = {threads}: must be from 1 to {MOST_THREADS}")
    return int(threads)
