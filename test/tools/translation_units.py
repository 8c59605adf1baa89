# SPDX-License-Identifier: BSD-3-Clause
"""The sources of each folder, joined for a check that compiles them with clang. Most of the time of such a check is spent on the
headers of Eigen and ROS, which are then read once per folder."""

import hashlib
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

VERSION = 14
SKIPPED = 77
# Flags that differ between the sources of a folder and do not affect the checks.
IRRELEVANT = re.compile("-fPIC|-Winvalid-pch|-fmacro-prefix-map=|-D.*_EXPORTS")


def version_of(tool):
    output = subprocess.run([tool, "--version"], capture_output=True, text=True, check=True).stdout
    return int(re.search(r"version (\d+)", output).group(1))


def require(tool):
    """Name of a tool with the version for which the checks are written. Exits as skipped if it is not installed."""
    for name in (f"{tool}-{VERSION}", tool):
        if shutil.which(name) and version_of(name) == VERSION:
            return name
    print(f"skipped: {tool} {VERSION} is not installed")
    sys.exit(SKIPPED)


def sources_of(file):
    """The sources that CMake joined in this file, or the file itself."""
    if file.name.startswith("unity_"):
        return [pathlib.Path(name) for name in re.findall(r'^#include "([^"]+\.cpp)"', file.read_text(), re.MULTILINE)]
    return [file]


def groups(folder, build_dir):
    """Sources below the folder that are in the same folder and have the same flags, as a list of (flags, files)."""
    found = {}
    for entry in json.loads((build_dir / "compile_commands.json").read_text()):
        words = shlex.split(re.sub(r" -o .*", "", re.sub(r" -include \S+", "", entry["command"])))[1:]
        flags = tuple(word for word in words if not IRRELEVANT.match(word))
        for file in sources_of(pathlib.Path(entry["file"])):
            if folder in file.parents:
                found.setdefault((file.parent, flags), set()).add(file)
    return [(flags, sorted(files)) for (_, flags), files in sorted(found.items())]


def write(flags, files, folder):
    """Writes a source to the folder that includes all files. Its name is unique for files and flags."""
    text = "".join(f'#include "{file}"\n' for file in files)
    unit = folder / f"{files[0].parent.name}_{hashlib.sha256((repr(flags) + text).encode()).hexdigest()[:12]}.cpp"
    unit.write_text(text)
    return unit


def join(clang, flags, files, folder):
    """A source in the folder that includes all files, or None if they do not compile together."""
    unit = write(flags, files, folder)
    if len(files) == 1 or not subprocess.run([clang, *flags, "-w", "-fsyntax-only", unit], stderr=subprocess.DEVNULL,
                                             check=False).returncode:
        return unit
    unit.unlink()
    return None
