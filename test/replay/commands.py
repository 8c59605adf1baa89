# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of commands: what a command prints, a temporary folder, and a full disk for child processes."""
import contextlib
import io
import pathlib
import resource
import tempfile
import unittest


def no_file_larger_than(size):
    """A preexec_fn that limits the file size of the child process to `size` [B]. Writes then fail as on a full disk."""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


def status_of(main, arguments, out, err):
    """Exit status of a command that prints to `out` and `err`."""
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            return main([str(argument) for argument in arguments])
        except SystemExit as end:
            return end.code


def running(main):
    """A function that runs a command with its arguments. @return exit status, standard output, standard error"""
    def run(*arguments):
        out, err = io.StringIO(), io.StringIO()
        status = status_of(main, arguments, out, err)
        return status, out.getvalue(), err.getvalue()
    return run


class CommandCase(unittest.TestCase):
    def run_command(self, main, *arguments, status=0):
        """Runs the main function of a command. @return its output"""
        printed = io.StringIO()
        self.assertEqual(status_of(main, arguments, printed, printed), status, printed.getvalue())
        return printed.getvalue()


class FolderCase(CommandCase):
    """Tests with a temporary folder each."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
