# SPDX-License-Identifier: BSD-3-Clause
"""Rows of the chart. SI units; errors relative."""
import csv
import platform
from dataclasses import dataclass
from pathlib import Path

INTEGERS = ("cells_along", "cells_across", "samples")
TEXTS = ("scene", "title", "kind", "method", "start", "status", "reason", "solver")


@dataclass(frozen=True)
class Row:
    """One method on one grid (auto: at one tolerance) in one scene, from cold or warm; columns as in the file."""

    scene: str
    title: str
    kind: str  # wheelset: the whole chain; normal: the normal problem alone
    method: str
    cells_along: int
    cells_across: int
    tolerance: float  # of auto, else 0
    start: str  # cold, warm
    status: str  # answered, refused, other_patches, not_run
    reason: str
    time: float  # median [s]; of not_run: as expected
    time_quartile_1: float
    time_quartile_3: float
    samples: int
    solver: str  # the method at work: of auto the one it chose; empty unless answered
    error: float  # largest of the three; this and what follows is None unless answered
    error_max_pressure: float
    error_area: float
    error_approach: float
    error_estimate: float
    truth_error: float  # of the scene

    @property
    def rung(self):
        """What tells the rows of one method and scene apart: the grid, of auto the tolerance."""
        return self.tolerance if self.method == "auto" else (self.cells_along, self.cells_across)

    @property
    def answered(self):
        return self.status == "answered"


def parse(lines):
    """Rows from the lines of a table."""
    return [Row(**{name: _value(name, text) for name, text in record.items()}) for record in csv.DictReader(lines)]


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


def write(path, facts, lines):
    """The table with its origin in comment lines above it."""
    comments = [f"# {name}: {text}\n" for name, text in facts.items()]
    path.write_text("".join(comments + lines), encoding="utf-8")


def read(path):
    """Facts and rows of a written table."""
    lines = path.read_text(encoding="utf-8").splitlines()
    facts = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
    return facts, parse(line for line in lines if not line.startswith("# "))
