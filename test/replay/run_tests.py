# SPDX-License-Identifier: BSD-3-Clause
"""Runs modules with tests of the working folder, as `python3 -m unittest` does. They may import the helpers of this folder."""
import sys
import unittest

if __name__ == "__main__":  # not in the processes that tests start
    sys.path.insert(0, "")
    unittest.main(None)
