# SPDX-License-Identifier: BSD-3-Clause
"""Test case with a temporary folder, and functions that convert tables with contact_states."""
from commands import FolderCase
from wheel_rail_contact.states.command_line import main
from wheel_rail_contact.states.state import read_bag


class StatesCase(FolderCase):
    def run_states(self, source, target, *options, status=0):
        """Runs contact_states. Returns what it prints."""
        return self.run_command(main, self.folder / source, self.folder / target, *options, status=status)

    def write(self, table):
        """Writes the table in.csv: a text (UTF-8, its line ends unchanged) or bytes."""
        (self.folder / "in.csv").write_bytes(table if isinstance(table, bytes) else table.encode())

    def convert(self, table, *options):
        """States of a table, and what contact_states prints."""
        self.write(table)
        (self.folder / "out.bag").unlink(missing_ok=True)
        printed = self.run_states("in.csv", "out.bag", *options)
        return read_bag(self.folder / "out.bag"), printed

    def states_of(self, table, *options):
        return self.convert(table, *options)[0]

    def error_of(self, table, *options):
        """What contact_states prints when it refuses a table, as it must."""
        self.write(table)
        (self.folder / "out.bag").unlink(missing_ok=True)
        printed = self.run_states("in.csv", "out.bag", *options, status=1)
        self.assertFalse((self.folder / "out.bag").exists())
        return printed

    def misuse_of(self, *options):
        """What contact_states prints when it refuses its options, as it must."""
        self.write("time [s],y [mm]\n1,0\n")
        printed = self.run_states("in.csv", "out.bag", *options, status=2)
        self.assertFalse((self.folder / "out.bag").exists())
        return printed
