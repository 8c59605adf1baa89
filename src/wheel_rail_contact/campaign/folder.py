# SPDX-License-Identifier: BSD-3-Clause
"""The campaign's folder: answers, what is left of unfinished bags, and the manifest.

A slice or a bag is done when its record, a JSON file beside it, is there; records come after what they tell, both by
renaming. So whoever is killed leaves nothing that counts and is not whole."""
import contextlib
import fcntl
import json
import os
import shutil
from pathlib import Path

from ..command import Failure

FORMAT = 2  # of the manifest and the records
MANIFEST = "manifest.json"
WORK = "unfinished"  # folder of slices
LOCK = ".lock"
COMMON = ("folder", "options", "slice", "configs")  # of a plan: equal whenever a campaign goes on


def write_json(path, content):
    """In one step: a reader finds the old file or the new one."""
    partial = path.with_name(f"{path.name}.{os.getpid()}.partial")
    with open(partial, "w", encoding="utf-8") as stream:
        json.dump(content, stream, indent=1)
        stream.write("\n")
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(partial, path)


def read_json(path):
    """Content of a file, None where there is none."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None


class Folder:
    """Where a campaign's files stand."""

    def __init__(self, path):
        self.path = Path(path).resolve()

    @contextlib.contextmanager
    def opened(self):
        """Makes the folder or takes up one of a campaign; nobody else may be at work in it. Gives the manifest."""
        self.path.mkdir(parents=True, exist_ok=True)
        if not (self.path / MANIFEST).is_file() and any(file.name != LOCK for file in self.path.iterdir()):
            raise Failure(f"--out {self.path}: is not empty, and no campaign's folder")
        with open(self.path / LOCK, "w", encoding="ascii") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                raise Failure(f"--out {self.path}: another campaign is at work there") from None
            manifest = read_json(self.path / MANIFEST)
            if manifest and manifest["format"] != FORMAT:
                raise Failure(f"--out {self.path}: holds a campaign of another version of contact_campaign (format "
                              f"{manifest['format']}, not {FORMAT}); take another folder, or finish it with that version")
            yield manifest

    def answers(self, bag):
        """The bag of answers."""
        return self.path / bag

    def part(self, bag, number):
        """The answers of a slice."""
        return self.path / WORK / bag / f"{number:06}.bag"

    def clear(self):
        """Removes what slices have left, once all are joined."""
        shutil.rmtree(self.path / WORK, ignore_errors=True)

    def write_manifest(self, plan):
        """The plan with what is known of each bag."""
        bags = {name: {**entry, **(record_of(self.answers(name)) or {})} for name, entry in plan["bags"].items()}
        write_json(self.path / MANIFEST, {**plan, "bags": bags})


def require_same(plan, before):
    """A campaign goes on with the same bags and options only, or its answers would not belong together."""
    for name in COMMON:
        if plan[name] != before[name]:
            raise Failure(f"{name} {plan[name]} is not that of the campaign in this folder: {before[name]}")
    for bag, entry in plan["bags"].items():
        known = before["bags"].get(bag)
        if known is None or any(entry[key] != known[key] for key in entry):
            raise Failure(f"{bag} is not in the campaign in this folder, or has changed since")
    missing = before["bags"].keys() - plan["bags"].keys()
    if missing:
        raise Failure(f"{', '.join(sorted(missing))} of the campaign in this folder was not named")


def record_path(path):
    """The file that tells of a slice's or a bag's answers."""
    return path.with_name(path.name + ".json")


def record_of(path):
    """What is known of answers that are there; None if they are not, or not whole."""
    record = read_json(record_path(path))
    whole = record is not None and path.is_file() and path.stat().st_size == record["bytes"]
    return record if whole else None
