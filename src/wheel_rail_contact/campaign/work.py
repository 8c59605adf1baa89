# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of a worker.

Each function may run twice for the same slice, even at the same time. The resulting file is the same.
"""
import contextlib
import os
import re
import shutil
import socket
import subprocess
import time
import uuid
from pathlib import Path

from ..command import Failure, runner
from .folder import record_of, record_path, write_json
from .plan import sha256

DONE, DAMAGED, FEW_RESULTS, DOUBTFUL_LOADS = 0, 3, 4, 5  # exit statuses of contact_replay
END_WITH_WORKER = ("setpriv", "--pdeathsig", "KILL")
# Lines of the summary that contact_replay prints.
EVALUATED = re.compile(r"^(\d+) pairs evaluated in \S+ s, ", re.MULTILINE)
STATUS = re.compile(r"^  ([A-Z_]+): (\d+) \(", re.MULTILINE)
DROPPED = re.compile(r"^  (\S*): (\d+) messages dropped: (.*)", re.MULTILINE)
POSES = re.compile(r"^  \d+ of (\d+) poses have a result(?:;.*)?$", re.MULTILINE)
LACKING = re.compile(r"^  (\S*): (\d+) \w+ lack a neighbour's forces", re.MULTILINE)


def evaluate_slice(task):
    """Evaluates one slice. @return its record"""
    part = Path(task["part"])
    known = record_of(part)
    if known:
        return known
    part.parent.mkdir(parents=True, exist_ok=True)
    start, end = task["slice"]
    span = (["--from", start] if start else []) + (["--to", end] if end else [])
    began = time.monotonic()
    with _partial(part.parent) as partial:
        command = [*END_WITH_WORKER, runner("contact_replay"), task["bag"], partial, "--threads", "1", *span,
                   *task["options"]]
        run = subprocess.run(command, cwd=task["folder"], capture_output=True, text=True, check=False)
        if run.returncode not in (DONE, DAMAGED, FEW_RESULTS, DOUBTFUL_LOADS):
            raise Failure(_last_line(run))
        record = {**_summary(run.stdout), "from": start, "to": end, "faults": _faults(run, task["bag"]),
                  "notes": [] if start else _notes(run.stdout),  # all slices of a bag have the same
                  "seconds": round(time.monotonic() - began, 3), "worker": f"{socket.gethostname()}:{os.getpid()}"}
        return _finish(partial, part, record)


def join_slices(task):
    """Joins the slices of a bag and removes them. @return the record of the bag"""
    results = Path(task["results"])
    known = record_of(results)
    if known is None:
        parts = [Path(part) for part in task["parts"]]
        records = [_checked(part) for part in parts]
        with _partial(parts[0].parent) as partial:
            compression = ["--lz4"] if "--lz4" in task["options"] else []
            run = subprocess.run([*END_WITH_WORKER, runner("contact_join"), *compression, partial, *parts],
                                 capture_output=True, text=True, check=False)
            if run.returncode != DONE:
                raise Failure(_last_line(run))
            known = _finish(partial, results, {"results": sum(record["results"] for record in records),
                                               "done": records})
    shutil.rmtree(Path(task["parts"][0]).parent, ignore_errors=True)
    return known


@contextlib.contextmanager
def _partial(folder):
    """A unique file name for this task. The file is removed at the end, unless it was renamed."""
    path = folder / f"{uuid.uuid4().hex}.partial"
    try:
        yield path
    finally:
        path.unlink(missing_ok=True)


def _finish(partial, path, record):
    """Renames the finished file, then writes its record. @return the record"""
    record = {"sha256": sha256(partial), "bytes": partial.stat().st_size, **record}
    os.replace(partial, path)
    write_json(record_path(path), record)
    return record


def _checked(part):
    """Record of a slice. Raises Failure if the file differs from its checksum."""
    record = record_of(part)
    if record is None or sha256(part) != record["sha256"]:
        record_path(part).unlink(missing_ok=True)
        raise Failure(f"{part} was changed after it was written; the same command evaluates it again")
    return record


def _summary(text):
    """Counts of the summary that contact_replay prints."""
    statuses = {name: int(count) for name, count in STATUS.findall(text)}
    dropped = [[inputs, int(count), reason] for inputs, count, reason in DROPPED.findall(text)]
    lacking = {topic: int(count) for topic, count in LACKING.findall(text)}
    return {"results": int(EVALUATED.search(text).group(1)), "poses": int(POSES.search(text).group(1)),
            "statuses": statuses, "dropped": dropped, "lacking_neighbour": lacking}


def _notes(text):
    """What contact_replay understood of the profile files: the lines that it prints before its summary."""
    return text[:EVALUATED.search(text).start()].splitlines()


def _faults(run, bag):
    """Parts of the bag that could not be read, as sentences that begin with the path of the bag."""
    start = "contact_replay: "
    lines = [line[len(start):] for line in run.stderr.splitlines() if line.startswith(f"{start}{bag}: ")]
    return lines[:-1] if run.returncode == FEW_RESULTS else lines  # the last one is on the number of results


def _last_line(run):
    """Last error message of a program."""
    lines = [line for line in run.stderr.splitlines() if line.strip() and not line.startswith("(")]
    return lines[-1] if lines else f"ended with status {run.returncode}"
