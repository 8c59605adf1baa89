# SPDX-License-Identifier: BSD-3-Clause
"""What a campaign has to do: which bags, cut where. Nothing here depends on the workers."""
import hashlib
import math
import sys
from pathlib import Path

import rosbag

from ..command import Failure
from .folder import FORMAT


def sha256(path):
    """Checksum of a file, in hexadecimal digits."""
    with open(path, "rb") as stream:
        checksum = hashlib.sha256()
        while block := stream.read(1 << 20):
            checksum.update(block)
    return checksum.hexdigest()


def read_index(path, wheelsets):
    """How many poses a bag holds, and when its recording begins and ends [s]."""
    poses = [f"{slash}{name.strip('/')}/wheelset/pose" if name.strip("/") else f"{slash}wheelset/pose"
             for name in wheelsets or [""] for slash in ("", "/")]
    with rosbag.Bag(str(path), skip_index=True) as bag:  # without the places of its messages
        count = bag.get_message_count(poses)
        return (count, bag.get_start_time(), bag.get_end_time()) if count else (0, 0, 0)


def cuts(path, wheelsets, per_slice):
    """Recording times [s], as text, between slices of about `per_slice` answers; none for a bag that is one slice, such as
    one that must be read whole (damaged, or no bag), of which the user is told."""
    try:
        poses, start, end = read_index(path, wheelsets)
    except Exception as error:  # rosbag lets decoders' own through
        print(f"contact_campaign: {path}: is one slice, since its index cannot be read ({error})", file=sys.stderr)
        return []
    count = math.ceil(poses / per_slice)
    return list(dict.fromkeys(f"{start + k * (end - start) / count:.6f}" for k in range(1, count)))


def plan_of_bag(path, wheelsets, per_slice):
    """The campaign's entry for a bag."""
    state = path.stat()
    at = [None, *cuts(path, wheelsets, per_slice), None]
    return {"bag": str(path), "size": state.st_size, "modified": state.st_mtime_ns,
            "slices": [[start, end] for start, end in zip(at, at[1:])]}


def plan_of(options, before=None):
    """The campaign as a dictionary, told by its manifest. Bags that have not changed since `before` keep its cuts."""
    bags = [Path(name).resolve() for name in options.bags]
    names = [bag.name for bag in bags]
    for name in names:
        if names.count(name) > 1:
            raise Failure(f"two bags are named {name}: their answers would have one name")
    plan = {"format": FORMAT, "folder": str(Path.cwd()), "options": replay_options(options), "slice": options.slice,
            "configs": {str(Path(name).resolve()): sha256(name) for name in options.config}, "bags": {}}
    for bag in bags:
        known = (before or {}).get("bags", {}).get(bag.name)
        state = bag.stat()
        if known and (known["bag"], known["size"], known["modified"]) == (str(bag), state.st_size, state.st_mtime_ns):
            plan["bags"][bag.name] = {key: known[key] for key in ("bag", "size", "modified", "slices")}
        else:
            plan["bags"][bag.name] = plan_of_bag(bag, options.wheelset, options.slice)
    return plan


def replay_options(options):
    """What contact_replay is told beside the bag and the slice."""
    words = [word for name in options.config for word in ("--config", str(Path(name).resolve()))]
    words += ["--wheelset", *options.wheelset] if options.wheelset else []
    return words + [f"--{name}" for name in ("keep-topics", "no-grids", "lz4") if getattr(options, name.replace("-", "_"))]
