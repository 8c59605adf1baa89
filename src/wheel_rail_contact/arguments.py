# SPDX-License-Identifier: BSD-3-Clause
"""Parser of the command lines, with what argparse lacks."""
import argparse
import re


class Parser(argparse.ArgumentParser):
    """Takes negative numbers with an exponent, such as -20e3, as values. Before Python 3.14, argparse takes them as options."""

    def __init__(self, **settings):
        super().__init__(**settings)
        self._negative_number_matcher = re.compile(r"-\.?\d")  # as in Python 3.14


class DefaultsFormatter(argparse.ArgumentDefaultsHelpFormatter):
    """Help with the default values, where there are any."""

    def _get_help_string(self, action):
        return action.help if action.default in (None, []) else super()._get_help_string(action)
