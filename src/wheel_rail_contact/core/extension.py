# SPDX-License-Identifier: BSD-3-Clause
"""The extension module. Builds with sanitizers do not have it."""
import importlib

from ..command import PACKAGE
from . import old_names

_NAME = f"{PACKAGE}._core"

try:
    core = importlib.import_module(_NAME)
except ModuleNotFoundError as error:
    if error.name != _NAME:
        raise
    raise ImportError(f"the Python module {_NAME} was not found; build the package and source its setup.bash (builds with "
                      "sanitizers have no such module)") from None
old_names.add_to(core)
