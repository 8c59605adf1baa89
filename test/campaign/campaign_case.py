# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of contact_campaign: runs of the command, a cluster of processes, and a case with a folder."""

import contextlib
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import time
import unittest
from commands import running
from replay_case import ReplayCase
from wheel_rail_contact.campaign.cluster import dask
from wheel_rail_contact.campaign.command_line import main
from wheel_rail_contact.command import Failure

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
GRID = "contact: {method: conjugate_gradient, grid: {along: 8, across: 24}}\n"  # short start time
TIMEOUT = 60  # [s] for the slowest machine
SLICE = 300


def skip_without_dask():
    """The setUpModule of the modules with tests: without Dask, all their tests are skipped."""
    try:
        dask()
    except Failure as missing:
        raise unittest.SkipTest(str(missing)) from None


def wait_for(condition):
    """Waits until the condition is true, and returns its value."""
    end = time.monotonic() + TIMEOUT
    while not (found := condition()):
        if time.monotonic() > end:
            raise TimeoutError("the condition did not become true")
        time.sleep(0.01)
    return found


def processes_of(folder):
    """Command lines of the running processes that contain the path of a folder."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):
            line = path.read_bytes().decode(errors="replace")
            if str(folder) in line and int(path.parent.name) != os.getpid():
                found.append(line.replace("\0", " "))
    return found


def run(*arguments):
    """Runs the command. @return exit status and output"""
    status, out, err = running(main)(*arguments)
    return status, out + err


class Cluster:
    """A scheduler, and workers with one core each, in separate processes."""

    def __init__(self, folder):
        self.folder, self.processes = folder, []
        self._start("dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--scheduler-file", "scheduler.json")
        file = folder / "scheduler.json"
        self.address = wait_for(lambda: file.exists() and file.read_text() and json.loads(file.read_text())["address"])

    def _start(self, program, *arguments):
        self.processes.append(subprocess.Popen(
            [sys.executable, "-m", f"distributed.cli.{program}", *arguments, "--no-dashboard"], cwd=self.folder,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        return self.processes[-1]

    def add_worker(self):
        return self._start("dask_worker", self.address, "--nthreads", "1", "--no-nanny", "--local-directory", str(self.folder))

    def close(self):
        for process in self.processes:
            process.kill()
            process.wait()


class Case(ReplayCase):
    def setUp(self):
        super().setUp()
        self.options = ["--config", self.config(GRID, "grid.yaml"), "--no-grids"]
        self.out = self.folder / "out"

    def command(self, *bags, slice=SLICE, more=()):
        return [*bags, "--out", self.out, "--slice", slice, *self.options, *more]

    def records(self):
        """Contents of the records of the slices that are done and not yet joined, by file name."""
        return {path.name: path.read_text() for path in self.out.glob("unfinished/*/*.bag.json")}

    def manifest(self):
        return json.loads((self.out / "manifest.json").read_text())

    def assert_done(self, bag):
        """Checks that the results are those of one replay, and that the manifest contains their checksum."""
        whole, _ = self.replay(bag, "whole.bag", *self.options)
        self.assert_same_file(whole, self.out / bag.name)
        entry = self.manifest()["bags"][bag.name]
        self.assertEqual(entry["sha256"], hashlib.sha256(whole.read_bytes()).hexdigest())
        self.assertEqual(entry["results"], len(self.results(whole)))
        self.assertEqual(len(entry["done"]), len(entry["slices"]))
        self.assertFalse((self.out / "unfinished").exists())
        whole.unlink()
        return entry
