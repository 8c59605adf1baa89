# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of contact_node from YAML files, as contact_replay applies them: each file over config/default.yaml."""
from pathlib import Path

import yaml
from roslib.packages import InvalidROSPkgException, get_pkg_dir

from .command import Failure, shipped

DEFAULTS = "config/default.yaml"
SCHEME = "package://"


def _resolved(name):
    """Path of a file: a path, package://NAME/..., or relative to this package."""
    if name.startswith(SCHEME):
        package, _, rest = name[len(SCHEME):].partition("/")
        try:
            return Path(get_pkg_dir(package)) / rest
        except InvalidROSPkgException:
            raise Failure(f"{name}: there is no ROS package '{package}'") from None
    if Path(name).is_file():
        return Path(name)
    try:
        return shipped(name)
    except Failure:
        raise Failure(f"no such file: {name}") from None


def _flat(group, prefix=""):
    """Parameters of nested groups: full name -> value."""
    found = {}
    for key, value in group.items():
        name = f"{prefix}{key}"
        found.update(_flat(value, name + "/") if isinstance(value, dict) else {name: value})
    return found


def _read(path):
    try:
        with open(path, encoding="utf-8") as file:
            document = yaml.safe_load(file)
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise Failure(f"{path}: {' '.join(str(error).split())}") from None
    if document is not None and not isinstance(document, dict):
        raise Failure(f"{path}: must be a map of names and values")
    return _flat(document or {})


def read_parameters(files):
    """Parameters by full names, such as wheelset/tape_circle. Later files override earlier ones and config/default.yaml.

    Only the names in the group wheelset are checked. contact_node and contact_replay check all names and values.

    @throw Failure if a file cannot be read, or contains an unknown name in the group wheelset
    """
    defaults = _read(shipped(DEFAULTS))
    parameters = dict(defaults)
    for name in files:
        read = _read(_resolved(name))
        for key in read:
            if key.split("/")[0] == "wheelset" and key not in defaults:
                raise Failure(f"{name}: parameter {key} is unknown")
        parameters.update(read)
    return parameters
