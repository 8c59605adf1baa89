# SPDX-License-Identifier: BSD-3-Clause
"""The text files of the package, also in a source folder that is not a git repository."""

import re

GENERATED = re.compile(r"(build|devel|install|logs)\w*|\.git|\.programs|\.catkin_tools|__pycache__|.*\.egg-info|\.vscode|\.idea")


def text_files(source):
    """Yields every text file of the package as (path, text), except those in generated folders."""
    pending = [source]
    while pending:
        for path in sorted(pending.pop().iterdir()):
            if GENERATED.fullmatch(path.name):
                continue
            if path.is_dir():
                pending.append(path)
            elif b"\0" not in path.read_bytes()[:4096]:
                yield path, path.read_text()
