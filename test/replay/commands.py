# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of commands: what a command prints and draws, a temporary folder, and a full disk."""
import contextlib
import io
import os
import pathlib
import resource
import subprocess
import tempfile
import unittest


def error_without_space(size, *command):
    """What a command prints that fails because no file may be larger than `size` [B]: as on a full disk."""
    done = subprocess.run(command, capture_output=True, text=True, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
    assert done.returncode == 1, done.stdout + done.stderr
    return done.stderr


def is_drawn(path):
    """False for a blank picture: the standard deviation of its pixels is 0, that of thin lines on white is 0.1."""
    from matplotlib import image
    return image.imread(str(path))[:, :, :3].std() > 0.05


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

    def config(self, text, name="my.yaml"):
        """Writes a parameter file. @return its path"""
        (self.folder / name).write_text(text)
        return self.folder / name

    def replayed(self, bag, *options, name="results.bag"):
        """Path of the results of a bag by contact_replay."""
        subprocess.run([os.environ["CONTACT_REPLAY"], bag, self.folder / name, *options], check=True, capture_output=True)
        return self.folder / name
