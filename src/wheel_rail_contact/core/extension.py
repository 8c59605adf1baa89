# SPDX-License-Identifier: BSD-3-Clause
"""The extension module, which is optional in a build."""
import importlib

from ..command import PACKAGE

_NAME = f"{PACKAGE}._core"

try:
    core = importlib.import_module(_NAME)
except ModuleNotFoundError as error:
    if error.name != _NAME:
        raise
    raise ImportError(f"{PACKAGE} was built without its Python module; install pybind11-dev and python3-dev, and build it "
                      "again") from None
