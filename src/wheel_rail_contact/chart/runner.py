# SPDX-License-Identifier: BSD-3-Clause
"""Finds and runs the program that measures."""
import os
import subprocess
import sys
from pathlib import Path

from .errors import ChartError

NAME = "contact_chart_runner"


def find_runner():
    """Path of the program: beside the command, in the devel space as in the install space, or in the workspace."""
    command = Path(sys.argv[0])
    spaces = [Path(prefix, "lib", "wheel_rail_contact")
              for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep) if prefix]
    for folder in (command.parent, command.resolve().parent, *spaces):
        if os.access(folder / NAME, os.X_OK) and (folder / NAME).is_file():
            return folder / NAME
    raise ChartError(f"{NAME} was not found beside this command or in CMAKE_PREFIX_PATH; build the package and source "
                     "its setup.bash")


def run(program, quick, progress):
    """What the program tells of itself, {name: text}, and the lines of its table.

    Calls progress(done, total, title) as it goes.
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
        raise ChartError(f"{NAME} failed (status {process.returncode})")
    return facts, lines
