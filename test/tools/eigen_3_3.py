# SPDX-License-Identifier: BSD-3-Clause
"""Headers of Eigen with the interfaces of Eigen 3.3, made from those of Eigen 3.4.

Only Eigen 3.4 is installed on Debian 12. The names of further additions are in newer_names.yaml.
"""

import re
import shutil
import sys

# File, pattern, replacement: removes iterators, indexed views and reshaped(), and constructors from lists. Each pattern must
# occur, because another version may require other patterns.
REMOVED = (
    ("Core/DenseBase.h", r"( *inline iterator begin\(\);.*?inline const_iterator cend\(\) const;)", r"  private:\n\1\n  public:"),
    ("Core/DenseBase.h", r"\n# *include \"../plugins/(IndexedView|Reshaped)Methods.h\"", ""),
    ("Core/Array.h", r"(\n[^\n]* Array\(const std::initializer_list<[^\n]*\n)", r"\n  private:\1  public:\n"),
    ("Core/Matrix.h", r"(\n[^\n]* Matrix\(const std::initializer_list<[^\n]*\n)", r"\n  private:\1  public:\n"),
)


def write(build_dir, folder):
    """Writes the headers to a folder. It must be searched before the folder of the installed headers."""
    commands = (build_dir / "compile_commands.json").read_text()
    installed = re.search(r"-isystem (\S+/eigen3)", commands).group(1)
    shutil.copytree(f"{installed}/Eigen", folder / "Eigen", dirs_exist_ok=True)
    if not (folder / "Eigen" / "src" / "Core" / "Reshaped.h").exists():
        return  # Eigen 3.3 is installed
    for name, pattern, replacement in REMOVED:
        file = folder / "Eigen" / "src" / name
        text, count = re.subn(pattern, replacement, file.read_text(), flags=re.DOTALL)
        if not count:
            sys.exit(f"Eigen/src/{name} does not contain {pattern}")
        file.write_text(text)
