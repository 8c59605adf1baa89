# SPDX-License-Identifier: BSD-3-Clause
"""Profile with all that its file shows."""
import os
from collections import namedtuple
from pathlib import Path

from ..command import Failure, native
from .nearest import nearest_standard

FARTHEST_STANDARD = 5e-3  # of a profile whose kind its content shows, root mean square [m]
LARGEST_ROTATION = 0.15  # of such a profile from the standard one [rad]
GIVE_KIND = "; give --wheel or --rail"
EXTENSIONS = {".prw": "wheel", ".whl": "wheel", ".prr": "rail", ".ban": "rail"}

# kind: "wheel" or "rail"
# known_by: how the kind is known: a phrase with "by"
# profile: Profile of the extension module
# points: (n, 2) used points of the file, in order [m]; none for a standard profile
# smoothing: noise for which the profile was smoothed [m]; 0: not smoothed
# nearest: Fit of the nearest standard profile
Checked = namedtuple("Checked", "kind known_by profile points smoothing nearest")


def text_of(name):
    """Name of a file as a text that can be printed."""
    return os.fsencode(name).decode(errors="replace")


def checked_profile(name, kind, options):
    """Reads a profile from a file, or takes a standard profile by its name.

    name: of the file or the standard profile
    kind: "wheel" or "rail"; None: the extension of the file name states it (EXTENSIONS), or the content: if it is a profile of
        only one kind, and this is within 5 mm (r.m.s.) of a standard profile of its kind. A reversed wheel can have the shape of
        a rail, but it is not as close to one
    options: group `profile` of a parameter file, as the text of a YAML document

    Raises Failure with the file, the reason and what to do, if there is no such profile or its kind is not known; ValueError if
    an option is out of range.
    """
    stated = EXTENSIONS.get(Path(name).suffix.lower())
    if kind or stated:
        found = [_attempt(name, kind or stated, "by option" if kind else "by its extension", options)]
    else:
        found = [_attempt(name, each, "by its content", options) for each in ("wheel", "rail")]
    profiles = [each for each in found if isinstance(each, Checked)]
    if len(profiles) == 1 and (len(found) == 1 or _is_near_standard(profiles[0])):
        return profiles[0]
    raise Failure(f"{text_of(name)}: {found[0] if len(found) == 1 else _unknown_kind(*found)}")


def _attempt(name, kind, known_by, options):
    """Checked, or the reason why there is none."""
    found = native().describe_profile(os.fsencode(name), kind, options)
    return found if isinstance(found, str) else Checked(kind, known_by, *found, nearest_standard(found[0], kind))


def _is_near_standard(checked):
    return checked.nearest.rms < FARTHEST_STANDARD and abs(checked.nearest.motion.rotation) < LARGEST_ROTATION


def _unknown_kind(wheel, rail):
    """Reason why the content does not show the kind: of the attempts to read it as each kind. If both fail, no option helps."""
    if isinstance(wheel, str) and isinstance(rail, str):
        return wheel if wheel == rail else f"as a wheel: {wheel}; as a rail: {rail}"
    if isinstance(wheel, Checked) and isinstance(rail, Checked):
        return f"can be a wheel or a rail{GIVE_KIND}"
    kind, other, reason = ("wheel", "rail", rail) if isinstance(wheel, Checked) else ("rail", "wheel", wheel)
    return f"can be a {kind}, but is far from every standard profile; as a {other}: {reason}{GIVE_KIND}"
