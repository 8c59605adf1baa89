# SPDX-License-Identifier: BSD-3-Clause
"""Folder of a campaign: results, slices of unfinished bags, and the manifest.

A slice or a bag is done when its record exists, a JSON file next to it. The record is written after the file that it
describes. Both get their name by renaming. A process that is killed therefore never leaves an incomplete file that counts
as done.
"""
import contextlib
import fcntl
import json
import os
import shutil
from pathlib import Path

from ..command import Failure, output_folder

FORMAT = 5  # of the manifest and the records
MANIFEST = "manifest.json"
WORK = "unfinished"  # subfolder of the slices
LOCK = ".lock"
COMMON = ("folder", "options", "slice", "configs")  # keys of a plan that must not change when a campaign continues


def write_json(path, content):
    """Writes a file in one step: a reader finds either the old file or the new one."""
    partial = path.with_name(f"{path.name}.{os.getpid()}.partial")
    with open(partial, "w", encoding="utf-8") as stream:
        json.dump(content, stream, indent=1)
        stream.write("\n")
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(partial, path)


def read_json(path):
    """Content of a file; None if it does not exist."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None


class Folder:
    """Paths and files of a campaign."""

    def __init__(self, path):
        self.path = Path(path).resolve()

    @contextlib.contextmanager
    def opened(self):
        """Creates the folder, or opens the folder of an earlier run, and locks it. Yields its manifest; None if new.

        Raises Failure if the folder contains other files, or if another campaign uses it.
        """
        output_folder(self.path)
        if not (self.path / MANIFEST).is_file() and any(file.name != LOCK for file in self.path.iterdir()):
            raise Failure(f"--out {self.path}: is not empty, and is not the folder of a campaign")
        with open(self.path / LOCK, "w", encoding="ascii") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                raise Failure(f"--out {self.path}: is in use by another campaign") from None
            manifest = read_json(self.path / MANIFEST)
            if manifest and manifest["format"] != FORMAT:
                raise Failure(f"--out {self.path}: contains a campaign of another version of contact_campaign (format "
                              f"{manifest['format']}, not {FORMAT}); use another folder, or finish it with that version")
            yield manifest

    def results(self, bag):
        """Path of the bag of results."""
        return self.path / bag

    def part(self, bag, number):
        """Path of the results of a slice."""
        return self.path / WORK / bag / f"{number:06}.bag"

    def clear(self):
        """Removes the files of the slices; call it when all are joined."""
        shutil.rmtree(self.path / WORK, ignore_errors=True)

    def write_manifest(self, plan):
        """Writes the plan, with the records of the bags that are done."""
        bags = {name: {**entry, **(record_of(self.results(name)) or {})} for name, entry in plan["bags"].items()}
        write_json(self.path / MANIFEST, {**plan, "bags": bags})


def require_same(plan, before):
    """Raises Failure if the plan differs from that of the earlier run: all results must come from the same options."""
    for name in COMMON:
        if plan[name] != before[name]:
            raise Failure(f"{name}: {plan[name]} differs from the campaign in this folder: {before[name]}")
    for bag, entry in plan["bags"].items():
        known = before["bags"].get(bag)
        if known is None or any(entry[key] != known[key] for key in entry):
            raise Failure(f"{bag} is not part of the campaign in this folder, or has been changed")
    missing = before["bags"].keys() - plan["bags"].keys()
    if missing:
        raise Failure(f"missing bags of the campaign in this folder: {', '.join(sorted(missing))}")


def record_path(path):
    """Path of the record of a slice or a bag."""
    return path.with_name(path.name + ".json")


def record_of(path):
    """Record of a slice or a bag; None if its results do not exist or are incomplete."""
    record = read_json(record_path(path))
    complete = record is not None and path.is_file() and path.stat().st_size == record["bytes"]
    return record if complete else None
