# SPDX-License-Identifier: BSD-3-Clause
"""Functions shared by the commands: exit status, error messages, and paths of files and programs of the package."""
import contextlib
import os
import sys
import tempfile
from pathlib import Path

PACKAGE = "wheel_rail_contact"


class Failure(Exception):
    """Failure of a command; the message is one sentence for the user."""


def finish(name, work, *arguments):
    """Runs a command and returns its exit status: the value that `work` returns, or 0 if this is None.

    A Failure, an OSError or Ctrl-C is reported as one sentence on standard error.
    """
    try:
        return work(*arguments) or 0
    except (Failure, OSError) as error:
        text = f"{error.filename}: {error.strerror}" if getattr(error, "filename", None) else error
        print(f"{name}: {text}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"\n{name}: interrupted", file=sys.stderr)
        return 130


@contextlib.contextmanager
def writing(path):
    """Adds the path to errors during writing: the error of a full disk does not contain it."""
    try:
        yield
    except FileExistsError:
        raise
    except OSError as error:
        raise Failure(f"{error.filename or path}: {error.strerror or error}") from error


def output_folder(folder):
    """Creates the folder of the option --out if it is missing. Raises Failure unless files can be written to it."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except FileExistsError:
        raise Failure(f"--out {folder}: is not a folder") from None
    except OSError as error:
        raise Failure(f"--out {folder}: no file can be written to this folder ({error.strerror})") from error


def shipped(name):
    """Path of a file of the package, in the source tree or in the install space."""
    here = Path(__file__).resolve().parent
    for root in (here.parents[1], *(parent / "share" / PACKAGE for parent in here.parents)):
        if (root / name).is_file():
            return root / name
    raise Failure(f"file {name} of the package was not found")


def runner(name):
    """Path of a program: in the folder of the command (devel or install space), or in a sourced workspace."""
    command = Path(sys.argv[0])
    workspaces = [Path(prefix, "lib", PACKAGE)
                  for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep) if prefix]
    for folder in (command.parent, command.resolve().parent, *workspaces):
        if os.access(folder / name, os.X_OK) and (folder / name).is_file():
            return folder / name
    raise Failure(f"{name} was not found; source the workspace's setup.bash first")


def native():
    """The extension module of the package."""
    try:
        from .core.extension import core
    except ImportError as error:
        raise Failure(error) from error
    return core


@contextlib.contextmanager
def calculating():
    """Makes a Failure of an error of the extension module: its message is one sentence for the user."""
    try:
        yield
    except (ValueError, RuntimeError) as error:
        raise Failure(error) from error


def contact_model(config=()):
    """ContactModel of the extension module, with parameters of the node as for WheelsetContact."""
    return _with_parameters("ContactModel", config)


def running_circles(config=()):
    """Distance of the running circles, and mean rolling radius [m]. No contact is prepared, which saves time."""
    return _with_parameters("running_circles", config)


def load_doubt(mean, config=()):
    """Reason to doubt the unit or sign of loads with this mean wheel load, down positive [N]; empty if there is none."""
    return _with_parameters("load_doubt", config, mean)


def _with_parameters(name, config, *arguments):
    core = native()
    from .core.contact import sources
    with calculating():
        return getattr(core, name)(sources(config), *arguments)


def pyplot():
    """pyplot of matplotlib, with a backend that draws only to files."""
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot as plot
    except ImportError as error:
        raise Failure("matplotlib is not installed; on Debian: apt install python3-matplotlib") from error
    return plot
