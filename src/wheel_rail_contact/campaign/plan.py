# SPDX-License-Identifier: BSD-3-Clause
"""Plan of a campaign: the bags, and the limits of their slices. It does not depend on the workers."""
import hashlib
import math
import sys
from pathlib import Path

import rosbag

from ..command import Failure
from .folder import FORMAT

INPUTS = ("pose", "load", "left-rail-force", "right-rail-force", "rail-displacement", "distance")  # options for topics


def sha256(path):
    """Checksum of a file, in hexadecimal digits."""
    with open(path, "rb") as stream:
        checksum = hashlib.sha256()
        while block := stream.read(1 << 20):
            checksum.update(block)
    return checksum.hexdigest()


def pose_topics(wheelsets, pose):
    """Names of the topics of the poses, with and without a leading slash.

    @param pose name of the topic as in contact_replay; None: the usual one
    """
    names = [pose] if (pose or "").startswith("/") else [f"{name}/{pose or 'wheelset/pose'}" for name in wheelsets or [""]]
    return [slash + name.strip("/") for name in names for slash in ("", "/")]


def read_index(path, poses):
    """Number of poses in a bag, and the times at which its recording begins and ends [s].

    @param poses names of their topics
    """
    with rosbag.Bag(str(path), skip_index=True) as bag:  # does not read the positions of the messages
        count = bag.get_message_count(poses)
        return (count, bag.get_start_time(), bag.get_end_time()) if count else (0, 0, 0)


def cuts(path, topics, per_slice):
    """Recording times [s], as text, between slices of about `per_slice` results. Empty if the bag is one slice.

    A bag with an unreadable index is one slice. This is reported on standard error.
    """
    try:
        poses, start, end = read_index(path, topics)
    except Exception as error:  # rosbag does not convert the exceptions of its decoders
        print(f"contact_campaign: {path}: evaluated as one slice, because its index cannot be read ({error})",
              file=sys.stderr)
        return []
    count = math.ceil(poses / per_slice)
    return list(dict.fromkeys(f"{start + k * (end - start) / count:.6f}" for k in range(1, count)))


def plan_of_bag(path, topics, per_slice):
    """Entry of a bag in the plan."""
    state = path.stat()
    at = [None, *cuts(path, topics, per_slice), None]
    return {"bag": str(path), "size": state.st_size, "modified": state.st_mtime_ns,
            "slices": [[start, end] for start, end in zip(at, at[1:])]}


def plan_of(options, before=None):
    """The plan as a dictionary, as in the manifest.

    @param before manifest of an earlier run: bags that have not changed keep their slices
    """
    bags = [Path(name).resolve() for name in options.bags]
    names = [bag.name for bag in bags]
    for name in names:
        if names.count(name) > 1:
            raise Failure(f"two bags are named {name}: their results would have the same name")
    plan = {"format": FORMAT, "folder": str(Path.cwd()), "options": replay_options(options), "slice": options.slice,
            "configs": {str(Path(name).resolve()): sha256(name) for name in options.config}, "bags": {}}
    for bag in bags:
        known = (before or {}).get("bags", {}).get(bag.name)
        state = bag.stat()
        if known and (known["bag"], known["size"], known["modified"]) == (str(bag), state.st_size, state.st_mtime_ns):
            plan["bags"][bag.name] = {key: known[key] for key in ("bag", "size", "modified", "slices")}
        else:
            plan["bags"][bag.name] = plan_of_bag(bag, pose_topics(options.wheelset, options.pose), options.slice)
    return plan


def replay_options(options):
    """Options of contact_replay other than the bag and the slice."""
    words = [word for name in options.config for word in ("--config", str(Path(name).resolve()))]
    words += ["--wheelset", *options.wheelset] if options.wheelset else []
    topics = ((name, getattr(options, name.replace("-", "_"))) for name in INPUTS)
    words += [word for name, topic in topics if topic is not None for word in (f"--{name}", topic)]
    return words + [f"--{name}" for name in ("keep-topics", "no-grids", "lz4") if getattr(options, name.replace("-", "_"))]
