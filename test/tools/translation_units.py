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
ERROR = re.compile(r"^([^:\n]+):\d+:\d+: (?:fatal )?error: (?:redefinition of '(\w+)')?", re.MULTILINE)

MAIN = re.compile(r"^int main\(", re.MULTILINE)
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


def write(flags, files, renamed, folder):
    """Writes a source to the folder that includes all files. Its name is unique for its content and the flags."""
    lines = []
    if renamed:  # headers come first: the names in them stay as they are
        heads = [file.read_text().split("\nnamespace", 1)[0] for file in files]
        lines = sorted({line for head in heads for line in INCLUDE.findall(head)})
    for file in files:
        names = sorted(renamed.get(file, {}).items())
        lines += [f"#define {name} {new}\n" for name, new in names]
        lines.append(f'#include "{file}"\n')
        lines += [f"#undef {name}\n" for name, _ in names]
    text = "".join(lines)
    unit = folder / f"unit_{hashlib.sha256((repr(flags) + text).encode()).hexdigest()[:12]}.cpp"
    unit.write_text(text)
    return unit


def joined(clang, flags, files, folder):
    """Yields (source, files): sources in the folder that each include as many of the files as compile together.

    Several files may use one name, in unnamed namespaces or as `main`. It then gets a number at its end, as in main2 and main3.
    If this does not help, the file is left to the next source.
    """
    fixed = set()  # files of which no other name can be changed
    while files:
        programs = [file for file in files if MAIN.search(file.read_text())][1:]
        renamed = {file: {"main": f"main{number}"} for number, file in enumerate(programs, 2)}
        uses = collections.Counter()
        while True:
            unit = write(flags, files, renamed, folder)
            run = subprocess.run([clang, *flags, "-w", "-ferror-limit=0", "-fsyntax-only", unit], capture_output=True, text=True,
                                 check=False)
            failed = {pathlib.Path(path) for path, _ in ERROR.findall(run.stderr)}
            twice = {(pathlib.Path(path), name) for path, name in ERROR.findall(run.stderr) if name}
            new = sorted((file, name) for file, name in twice
                         if file in files and file not in fixed and name not in renamed.get(file, {}))
            if not new:
                break
            unit.unlink()
            for file, name in new:
                uses[name] += 1
                renamed.setdefault(file, {})[name] = f"{name}{uses[name] + 1}"
        kept = [file for file in files if file not in failed]
        if run.returncode and not 0 < len(kept) < len(files):
            kept = files[:1]  # has an error of its own, or is of no use to others
        if kept != files:
            unit.unlink()
            unit = write(flags, kept, {file: names for file, names in renamed.items() if file in kept and len(kept) > 1}, folder)
        yield unit, kept
        files = [file for file in files if file not in kept]
        fixed.update(files)
