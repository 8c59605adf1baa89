# SPDX-License-Identifier: BSD-3-Clause
"""Runs CalculiX and reads the displacements that it prints."""
import re
import shutil
import subprocess

import numpy as np

from ..command import Failure


def program():
    """Path of ccx; raises Failure if it is not installed."""
    path = shutil.which("ccx")
    if path is None:
        raise Failure("CalculiX (ccx) is not installed; on Debian: apt install calculix-ccx")
    return path


def version():
    """Version of ccx."""
    run = subprocess.run([program(), "-v"], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    found = re.search(r"[Vv]ersion\s+(\S+)", run.stdout)
    return found.group(1) if found else "unknown"


def solve(directory, job, step_count, on_step):
    """Runs ccx on `job`.inp in `directory`. Calls on_step(k) when load step k = 1, 2, ... begins.

    Returns the printed displacements of each step: a list of dictionaries, node number -> array(3) [m].
    Raises Failure if ccx is missing or fails.
    """
    with subprocess.Popen([program(), job], cwd=directory, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT) as run:
        errors = []
        for line in run.stdout:
            step = re.match(r"\s*STEP\s+(\d+)\s*$", line)
            if step:
                on_step(int(step.group(1)))
            if "*ERROR" in line or errors:
                errors.append(line.strip())
    steps = _read_displacements(directory / f"{job}.dat") if (directory / f"{job}.dat").exists() else []
    if run.returncode != 0 or errors or len(steps) != step_count:
        raise Failure("ccx failed: " + (" ".join(errors[:5]) or f"exit status {run.returncode}, "
                                          f"{len(steps)} of {step_count} steps solved"))
    return steps


def _read_displacements(path):
    """Reads blocks of lines `node ux uy uz`, one block per step."""
    steps = []
    for line in path.read_text(encoding="ascii").splitlines():
        if line.lstrip().startswith("displacements"):
            steps.append({})
        fields = line.split()
        if steps and len(fields) == 4 and fields[0].isdigit():
            steps[-1][int(fields[0])] = np.array(fields[1:], float)
    return steps
