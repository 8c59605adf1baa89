# SPDX-License-Identifier: BSD-3-Clause
"""What a worker does. Either function may run twice for the same slice, at once or later: the result is the same file."""
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

DONE, DAMAGED = 0, 3  # exit statuses of contact_replay
DIES_WITH_ITS_WORKER = ("setpriv", "--pdeathsig", "KILL")
ANSWERED = re.compile(r"(\d+) pairs answered")
STATUS = re.compile(r"  ([A-Z_]+): (\d+) \(")
DROPPED = re.compile(r"  (\S*): (\d+) messages dropped: (.*)")
LACKING = re.compile(r"  (\S*): (\d+) answers lack a neighbour's forces")


def answer_slice(task):
    """Answers one slice. @return its record."""
    part = Path(task["part"])
    known = record_of(part)
    if known:
        return known
    part.parent.mkdir(parents=True, exist_ok=True)
    start, end = task["slice"]
    span = (["--from", start] if start else []) + (["--to", end] if end else [])
    began = time.monotonic()
    with _partial(part.parent) as partial:
        command = [*DIES_WITH_ITS_WORKER, runner("contact_replay"), task["bag"], partial, "--threads", "1", *span,
                   *task["options"]]
        run = subprocess.run(command, cwd=task["folder"], capture_output=True, text=True, check=False)
        if run.returncode not in (DONE, DAMAGED):
            raise Failure(_last_words(run))
        record = {**_summary(run.stdout), "from": start, "to": end, "faults": _faults(run),
                  "seconds": round(time.monotonic() - began, 3), "worker": f"{socket.gethostname()}:{os.getpid()}"}
        return _finish(partial, part, record)


def join_slices(task):
    """Joins the slices of a bag and removes them. @return its record."""
    answers = Path(task["answers"])
    known = record_of(answers)
    if known is None:
        parts = [Path(part) for part in task["parts"]]
        records = [_checked(part) for part in parts]
        with _partial(parts[0].parent) as partial:
            compression = ["--lz4"] if "--lz4" in task["options"] else []
            run = subprocess.run([*DIES_WITH_ITS_WORKER, runner("contact_join"), *compression, partial, *parts],
                                 capture_output=True, text=True, check=False)
            if run.returncode != DONE:
                raise Failure(_last_words(run))
            known = _finish(partial, answers, {"answers": sum(record["answers"] for record in records),
                                               "done": records})
    shutil.rmtree(Path(task["parts"][0]).parent, ignore_errors=True)
    return known


@contextlib.contextmanager
def _partial(folder):
    """A name for a file that nobody else writes to; removed unless it was renamed."""
    path = folder / f"{uuid.uuid4().hex}.partial"
    try:
        yield path
    finally:
        path.unlink(missing_ok=True)


def _finish(partial, path, record):
    """Makes the file and then its record appear."""
    record = {"sha256": sha256(partial), "bytes": partial.stat().st_size, **record}
    os.replace(partial, path)
    write_json(record_path(path), record)
    return record


def _checked(part):
    """The record of a slice whose bytes are those that were written."""
    record = record_of(part)
    if record is None or sha256(part) != record["sha256"]:
        record_path(part).unlink(missing_ok=True)
        raise Failure(f"{part} is not as it was written; the same command answers it again")
    return record


def _summary(text):
    statuses = {name: int(count) for name, count in STATUS.findall(text)}
    dropped = [[inputs, int(count), reason] for inputs, count, reason in DROPPED.findall(text)]
    lacking = {answers: int(count) for answers, count in LACKING.findall(text)}
    return {"answers": int(ANSWERED.search(text).group(1)), "statuses": statuses, "dropped": dropped,
            "lacking_neighbour": lacking}


def _faults(run):
    """Sentences about what could not be read."""
    start = "contact_replay: "
    return [line[len(start):] for line in run.stderr.splitlines() if line.startswith(start)]


def _last_words(run):
    lines = [line for line in run.stderr.splitlines() if line.strip() and not line.startswith("(")]
    return lines[-1] if lines else f"ended with status {run.returncode}"
