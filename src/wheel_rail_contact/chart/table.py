# SPDX-License-Identifier: BSD-3-Clause
"""Table of the chart. SI units; relative errors."""
import csv
import platform
from dataclasses import dataclass, fields
from pathlib import Path

INTEGERS = ("cells_along", "cells_across", "samples")
TEXTS = ("scene", "title", "kind", "method", "start", "status", "reason")
SOLVED = "solved"  # status of a row with a result


@dataclass(frozen=True)
class Row:
    """One method on one grid (auto: at one tolerance) in one scene, started cold or warm. Fields are the columns."""

    scene: str
    title: str
    kind: str  # wheelset: whole calculation; normal: normal problem of one wheel alone
    method: str
    cells_along: int
    cells_across: int
    tolerance: float  # of auto, else 0
    start: str  # cold, warm
    status: str  # SOLVED, refused, other_wheels, not_run
    reason: str  # of a missing result
    time: float  # median [s]; expected time if not run
    time_quartile_1: float
    time_quartile_3: float
    time_longest: float  # of a state of a warm sweep; None if cold or not run
    samples: int
    error: float  # largest of the next three; these and the estimate are None without a result
    error_max_pressure: float
    error_area: float
    error_approach: float
    error_estimate: float
    truth_error: float  # of the scene's reference solution

    @property
    def setting(self):
        """Grid (cells along, cells across); for auto the tolerance. Unique for each method, scene and start."""
        return self.tolerance if self.method == "auto" else (self.cells_along, self.cells_across)

    @property
    def has_result(self):
        return self.status == SOLVED


def _value(name, text):
    if name in TEXTS:
        return text
    if name in INTEGERS:
        return int(text)
    return float(text) if text else None


def machine():
    """Name of the processor."""
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def write(path, facts, rows):
    """Writes the table of rows, of one class, with the facts in comment lines above it."""
    names = [each.name for each in fields(rows[0])]
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.writelines(f"# {name}: {text}\n" for name, text in facts.items())
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(names)
        lines.writerows([_text(name, getattr(row, name)) for name in names] for row in rows)


def _text(name, value):
    if value is None or name in TEXTS or name in INTEGERS:
        return value
    return f"{value:g}" if name == "tolerance" else f"{value:.4g}"


def read(path):
    """Facts and rows of a table written by write()."""
    lines = path.read_text(encoding="utf-8").splitlines()
    facts = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
    records = csv.DictReader(line for line in lines if not line.startswith("# "))
    return facts, [Row(**{name: _value(name, text) for name, text in record.items()}) for record in records]
