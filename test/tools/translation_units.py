# SPDX-License-Identifier: BSD-3-Clause
"""The sources of the package, joined for a check that compiles them with clang. Most of the time of such a check is spent on the
headers of Eigen and ROS, which are then read only a few times."""

import collections
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
# Flags that the checks need. Each target has those of folders, libraries and definitions that it uses.
RELEVANT = re.compile(r"-(isystem|I|std=|D(?!.*_EXPORTS)|W(?!invalid-pch))")
ERROR = re.compile(r"^([^:\n]+):\d+:\d+: (?:fatal )?error: ", re.MULTILINE)

MAIN = re.compile(r"^int (main)\(", re.MULTILINE)
CONSTANT = re.compile(r"^constexpr [^=;{(]*?(\w+) =", re.MULTILINE)
INCLUDE = re.compile(r"^#include .*\n", re.MULTILINE)


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


def sources(folder, build_dir):
    """All sources below the folder, and flags with which each of them can be compiled: those of all targets together."""
    flags, files = {}, set()
    for entry in json.loads((build_dir / "compile_commands.json").read_text()):
        found = {file for file in sources_of(pathlib.Path(entry["file"])) if folder in file.parents}
        if found:
            words = shlex.split(entry["command"].replace("-isystem ", "-isystem"))
            flags.update(dict.fromkeys(filter(RELEVANT.match, words)))
            files |= found
    return tuple(flags), sorted(files)


def numbered(files):
    """Names to be changed in each file: `main` and constants that an earlier file has as well get a number at their end."""
    uses, renamed = collections.Counter(), {}
    for file in files:
        text = file.read_text()
        names = sorted({*CONSTANT.findall(text), *MAIN.findall(text)})
        uses.update(names)
        renamed[file] = [(name, f"{name}{uses[name]}") for name in names if uses[name] > 1]
    return renamed


def write(flags, files, folder):
    """Writes a source to the folder that includes all files. Its name is unique for its content and the flags."""
    lines = []
    if len(files) > 1:  # headers come first: the names in them stay as they are
        heads = [file.read_text().split("\nnamespace", 1)[0] for file in files]
        lines = sorted({line for head in heads for line in INCLUDE.findall(head)})
    for file, names in numbered(files).items():
        lines += [f"#define {name} {new}\n" for name, new in names]
        lines.append(f'#include "{file}"\n')
        lines += [f"#undef {name}\n" for name, _ in names]
    text = "".join(lines)
    unit = folder / f"unit_{hashlib.sha256((repr(flags) + text).encode()).hexdigest()[:12]}.cpp"
    unit.write_text(text)
    return unit


def joined(clang, flags, files, folder):
    """Yields sources in the folder that each include as many of the files as compile together."""
    while files:
        unit = write(flags, files, folder)
        run = subprocess.run([clang, *flags, "-w", "-ferror-limit=0", "-fsyntax-only", unit], capture_output=True, text=True,
                             check=False)
        failed = {pathlib.Path(path) for path in ERROR.findall(run.stderr)}
        kept = [file for file in files if file not in failed]
        if run.returncode and not 0 < len(kept) < len(files):
            kept = files[:1]  # has an error of its own, or is of no use to others
        if kept != files:
            unit.unlink()
            unit = write(flags, kept, folder)
        yield unit
        files = [file for file in files if file not in kept]
