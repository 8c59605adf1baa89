# SPDX-License-Identifier: BSD-3-Clause
"""What the package's commands have in common: how they end, and where they find what comes with the package."""
import contextlib
import os
import sys
from pathlib import Path

PACKAGE = "wheel_rail_contact"


class Failure(Exception):
    """What went wrong, in one sentence for the user."""


def finish(name, work, *arguments):
    """Runs the work of a command; returns its exit status: what the work returns, else 0. A failure is one sentence on
    standard error."""
    try:
        return work(*arguments) or 0
    except (Failure, OSError) as error:
        print(f"{name}: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"\n{name}: interrupted", file=sys.stderr)
        return 130


@contextlib.contextmanager
def writing(path):
    """Tells what cannot be written by its name, which the error of a full disk does not hold."""
    try:
        yield
    except FileExistsError:
        raise
    except OSError as error:
        raise Failure(f"{error.filename or path}: {error.strerror or error}") from error


def shipped(name):
    """Path of a file that comes with the package, in the source tree or installed."""
    here = Path(__file__).resolve().parent
    for root in (here.parents[1], *(parent / "share" / PACKAGE for parent in here.parents)):
        if (root / name).is_file():
            return root / name
    raise Failure(f"{name} of the package was not found")


def runner(name):
    """Path of a program: beside the command, in the devel space as in the install space, or in a workspace."""
    command = Path(sys.argv[0])
    workspaces = [Path(prefix, "lib", PACKAGE)
                  for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep) if prefix]
    for folder in (command.parent, command.resolve().parent, *workspaces):
        if os.access(folder / name, os.X_OK) and (folder / name).is_file():
            return folder / name
    raise Failure(f"{name} was not found; source the workspace's setup.bash first")


def pyplot():
    """matplotlib's pyplot, drawing to files only."""
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot as plot
    except ImportError as error:
        raise Failure("matplotlib is not installed; on Debian: apt install python3-matplotlib") from error
    return plot
