# SPDX-License-Identifier: BSD-3-Clause
"""Runs contact_chart_runner, the program that measures times and errors."""
import subprocess

from ..command import Failure

RUNNER = "contact_chart_runner"


def measure(program, quick, progress):
    """Properties of the program and its build as {name: text}, and the lines of its table.

    Calls progress(done, total, title) after every step.
    """
    facts, lines = {}, []
    command = [str(program)] + (["--quick"] if quick else [])
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            for line in process.stdout:
                if not line.startswith("# "):
                    lines.append(line)
                    continue
                name, text = line[2:].rstrip("\n").split(": ", 1)
                if name == "progress":
                    done, total, title = text.split(" ", 2)
                    progress(int(done), int(total), title)
                else:
                    facts[name] = text
        except BaseException:
            process.kill()
            raise
    if process.returncode != 0:
        raise Failure(f"{RUNNER} failed (status {process.returncode})")
    return facts, lines
