# SPDX-License-Identifier: BSD-3-Clause
"""contact_campaign: the files of contact_replay, whoever is killed on the way."""

import collections
import contextlib
import gzip
import hashlib
import io
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import types
import unittest
import unittest.mock

import distributed
import rosbag
from wheel_rail_contact.campaign.campaign import AHEAD, Campaign
from wheel_rail_contact.campaign.command_line import main
from wheel_rail_contact.campaign.folder import Folder
from wheel_rail_contact.campaign.interrupts import Interrupts
from wheel_rail_contact.campaign.work import answer_slice, join_slices
from wheel_rail_contact.msg import WheelsetContact

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PACKAGE / "test" / "replay"))
from replay_case import ReplayCase, pose, stamp  # noqa: E402  (stands beside other tests)

COMMAND = PACKAGE / "scripts" / "contact_campaign"
GRID = "contact: {method: conjugate_gradient, grid: {along: 8, across: 24}}\n"  # starts quickly
PATIENCE = 60  # [s] of the slowest machine
PAIRS, SLICE, SLICES = 3000, 300, 10


def wait_for(condition):
    """What the condition gives as soon as that is true."""
    end = time.monotonic() + PATIENCE
    while not (found := condition()):
        if time.monotonic() > end:
            raise TimeoutError("waited in vain")
        time.sleep(0.01)
    return found


def processes_of(folder):
    """Command lines of running processes that name a folder."""
    found = []
    for place in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):
            line = place.read_bytes().decode(errors="replace")
            if str(folder) in line and int(place.parent.name) != os.getpid():
                found.append(line.replace("\0", " "))
    return found


def run(*arguments):
    """Exit status of the command and what it printed."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        status = main([str(argument) for argument in arguments])
    return status, printed.getvalue()


class Cluster:
    """A scheduler and workers, one core each, as processes of their own."""

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
        return self._start("dask_worker", self.address, "--nthreads", "1", "--no-nanny", "--local-directory",
                           str(self.folder))

    def end(self):
        for process in self.processes:
            process.kill()
            process.wait()


class Case(ReplayCase):
    def setUp(self):
        super().setUp()
        (self.folder / "grid.yaml").write_text(GRID)
        self.options = ["--config", self.folder / "grid.yaml", "--no-grids"]
        self.out = self.folder / "out"

    def command(self, *bags, slice=SLICE, more=()):
        return [*bags, "--out", self.out, "--slice", slice, *self.options, *more]

    def records(self):
        """By slice, of those that are done and not joined."""
        return {path.name: path.read_text() for path in self.out.glob("unfinished/*/*.bag.json")}

    def manifest(self):
        return json.loads((self.out / "manifest.json").read_text())

    def assert_done(self, bag):
        """Answers are those of one replay, and the manifest tells their checksums."""
        whole, _ = self.replay(bag, "whole.bag", *self.options)
        self.assert_same_file(whole, self.out / bag.name)
        entry = self.manifest()["bags"][bag.name]
        self.assertEqual(entry["sha256"], hashlib.sha256(whole.read_bytes()).hexdigest())
        self.assertEqual(entry["answers"], len(self.answers(whole)))
        self.assertEqual(len(entry["done"]), len(entry["slices"]))
        self.assertFalse((self.out / "unfinished").exists())
        whole.unlink()
        return entry


class OwnCluster(Case):
    def test_broken_off_and_killed_campaign_goes_on_and_does_nothing_twice(self):
        bag = self.make_bag(PAIRS)
        command = [str(word) for word in self.command(bag)]
        with subprocess.Popen([sys.executable, COMMAND, *command], stderr=subprocess.PIPE, text=True,
                              start_new_session=True) as first:
            wait_for(lambda: len(self.records()) >= 2)
            os.killpg(first.pid, signal.SIGINT)  # as a terminal does
            told = first.stderr.read()
        self.assertEqual((first.returncode, told.splitlines()[-1]), (130, "contact_campaign: interrupted"))
        self.assertNotIn("Traceback", told)
        with subprocess.Popen([sys.executable, COMMAND, *command], stderr=subprocess.DEVNULL) as second:
            wait_for(lambda: len(self.records()) >= 5)
            second.send_signal(signal.SIGKILL)
        self.assertLess(len(self.records()), SLICES)
        wait_for(lambda: not processes_of(self.folder))  # its workers and their replays end with it
        before = self.records()
        status, printed = run(*command)
        self.assertEqual(status, 0, printed)
        entry = self.assert_done(bag)
        kept = {f"{k:06}.bag.json": record for k, record in enumerate(entry["done"])}
        for name, record in before.items():
            self.assertEqual(json.loads(record), kept[name])
        self.assertIn(f"{PAIRS} answers of 1 bags", printed)
        state = (self.out / bag.name).stat()
        status, printed = run(*command)
        self.assertEqual((status, printed), (0, f"{PAIRS} answers of 1 bags in {self.out}\n  OK: {PAIRS}\n"))
        self.assertEqual((self.out / bag.name).stat(), state)


class GivenCluster(Case):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.cluster = Cluster(pathlib.Path(folder.name))
        cls.addClassCleanup(cls.cluster.end)
        cls.worker = cls.cluster.add_worker()
        with distributed.Client(cls.cluster.address) as client:
            client.wait_for_workers(1, timeout=PATIENCE)

    def campaign(self, *bags, status=0, **options):
        found, printed = run(*self.command(*bags, **options), "--scheduler", self.cluster.address)
        self.assertEqual(found, status, printed)
        return printed

    def test_a_killed_workers_slices_are_answered_by_another(self):
        bag = self.make_bag(PAIRS)
        with subprocess.Popen([sys.executable, COMMAND, *map(str, self.command(bag)), "--scheduler",
                               self.cluster.address], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as campaign:
            wait_for(lambda: len(self.records()) >= 2 and any(self.out.glob("unfinished/*/*.partial")))
            before = self.records()
            self.worker.kill()
            type(self).worker = self.cluster.add_worker()
            self.assertEqual(campaign.wait(PATIENCE), 0)
        workers = [record["worker"] for record in self.assert_done(bag)["done"]]
        self.assertEqual(len(set(workers)), 2)
        self.assertGreaterEqual(len(before), 2)

    def test_long_and_short_bags(self):
        bags = [self.make_bag(1230, "long.bag"), self.make_bag(30, "short.bag")]
        printed = self.campaign(*bags)
        self.assertIn("1260 answers of 2 bags", printed)
        self.assertIn("OK: 1260", printed)
        self.assertEqual([len(self.assert_done(bag)["slices"]) for bag in bags], [5, 1])

    def test_answers_that_lack_a_neighbours_forces_are_counted_over_the_slices(self):
        soft = self.folder / "soft.yaml"
        soft.write_text("rail_bending: {model: compliance, table: config/rails/pads_10_25.yaml,"
                        " neighbours: [{topic: /neighbour, distance: 2.5}]}\n")
        self.options += ["--config", soft]
        bag = self.make_bag(500)
        with rosbag.Bag(str(bag), "a") as file:
            file.write("/neighbour", WheelsetContact(header=pose(399).header), stamp(399))
        self.assertIn("/contact_node/contact: 400 answers lack a neighbour's forces", self.campaign(bag))
        self.assertEqual(len(self.assert_done(bag)["done"]), 2)

    def test_a_bag_that_fails_does_not_stop_the_others(self):
        good, bad = self.make_bag(30, "good.bag"), self.folder / "bad.bag"
        bad.write_text("#ROSBAG V2.0\n")
        packed = self.folder / "packed.bag"
        packed.write_bytes(gzip.compress(good.read_bytes()))
        printed = self.campaign(bad, packed, good, status=1)
        self.assertIn("2 tasks failed", printed)
        for name in ("bad.bag", "packed.bag"):
            self.assertIn(f"{name}: is one slice, since its index cannot be read", printed)
            self.assertIn(f"{name}: contact_replay:", printed)
        self.assertEqual(len(self.answers(self.out / "good.bag")), 30)

    def test_a_bag_without_index_is_one_slice_and_its_damage_is_told(self):
        bag = self.make_bag(1000)
        bag.write_bytes(bag.read_bytes()[:-20000])
        printed = self.campaign(bag, status=3)
        self.assertIn("has no usable index", printed)
        self.assertEqual(len(self.manifest()["bags"][bag.name]["slices"]), 1)

    def test_a_part_that_changed_on_the_disk_is_answered_again(self):
        from wheel_rail_contact.campaign import work
        from wheel_rail_contact.command import Failure
        bag, part = self.make_bag(30), self.out / "parts" / "0.bag"
        task = {"bag": str(bag), "part": str(part), "slice": [None, None], "folder": str(self.folder),
                "options": [str(word) for word in self.options]}
        record = work.answer_slice(task)
        whole = part.read_bytes()
        part.write_bytes(whole[:-1] + bytes([whole[-1] ^ 1]))
        join = {"parts": [str(part)], "answers": str(self.out / "out.bag"), "options": []}
        with self.assertRaisesRegex(Failure, "is not as it was written"):
            work.join_slices(join)
        self.assertEqual(work.answer_slice(task)["sha256"], record["sha256"])
        self.assertEqual(work.join_slices(join)["sha256"], record["sha256"])


class InOrder:
    """Stands for Dask: one core, whose tasks come back in the order in which they were submitted, and do nothing.

    `statuses`: of each task, each time that it comes back.
    """

    def __init__(self, *statuses):
        self.submitted, self.running, self.statuses = [], collections.deque(), statuses
        self.add, self.count = self.running.append, self.running.__len__

    def nthreads(self):
        return {"worker": 1}

    def submit(self, function, task, **_):
        self.submitted.append((function, task["name"]))
        return types.SimpleNamespace(key=len(self.submitted), statuses=iter(self.statuses),
                                     result=lambda: {"answers": 1})

    def is_empty(self):
        return not self.running

    def has_ready(self):
        return bool(self.running)

    def __next__(self):
        future = self.running.popleft()
        future.status = next(future.statuses)
        return future


def interrupt():
    os.kill(os.getpid(), signal.SIGINT)


class CtrlC(unittest.TestCase):
    def test_the_first_one_waits_and_the_second_one_is_raised_at_once(self):
        with Interrupts() as interrupts:
            interrupts.raise_noted()
            interrupt()
            self.assertRaises(KeyboardInterrupt, interrupt)
            self.assertRaises(KeyboardInterrupt, interrupts.raise_noted)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_one_that_is_ignored_stays_so(self):
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.SIG_IGN))
        with Interrupts() as interrupts:
            interrupt()
            interrupts.raise_noted()
        self.assertIs(signal.getsignal(signal.SIGINT), signal.SIG_IGN)


class InterruptedInADestructor:
    """As any of a library may be: Python drops what a destructor raises."""

    def __del__(self):
        interrupt()


class Order(unittest.TestCase):
    NAMES = [f"{k}.bag" for k in range(2 * AHEAD + 1)]  # more than one core is given at a time

    def names_of_tasks(self, *statuses):
        """Of all answer_slice and of all join_slices, as they were submitted."""
        dask = InOrder(*statuses)
        plan = {"folder": "", "options": [],
                "bags": {name: {"bag": name, "slices": [[None, None]]} for name in self.NAMES}}
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch("distributed.as_completed", lambda: dask):
            campaign = Campaign(dask, plan, Folder(folder))
            campaign.run()
        self.assertEqual(campaign.failures, [])
        return [[name for done, name in dask.submitted if done is function] for function in (answer_slice, join_slices)]

    def test_each_of_many_short_bags_is_answered_and_joined_once(self):
        self.assertEqual(self.names_of_tasks("finished"), [self.NAMES, self.NAMES])

    def test_results_lost_with_their_worker_are_waited_for_again(self):
        self.assertEqual([sorted(names) for names in self.names_of_tasks("lost", "pending", "finished")],
                         [self.NAMES, self.NAMES])

    def test_an_interrupt_that_strikes_in_a_destructor_ends_the_campaign(self):
        with unittest.mock.patch.object(InOrder, "is_empty", lambda _: InterruptedInADestructor() is None):
            self.assertRaises(KeyboardInterrupt, self.names_of_tasks, "finished")


class Misuse(Case):
    def refuse(self, *arguments):
        status, printed = run(*arguments)
        self.assertEqual(status, 1)
        return printed

    def test_what_does_not_fit_the_folder_is_refused_by_name(self):
        bag = self.make_bag(30)
        self.out.mkdir()
        (self.out / "letter.txt").write_text("precious")
        self.assertIn("is not empty, and no campaign's folder", self.refuse(*self.command(bag)))
        (self.out / "letter.txt").unlink()
        absent = "tcp://127.0.0.1:9"
        with unittest.mock.patch("wheel_rail_contact.campaign.cluster.PATIENCE", "0.5s"):
            self.assertIn(f"--scheduler {absent}: no scheduler", self.refuse(*self.command(bag), "--scheduler", absent))
        self.assertIn("slice 10 is not that of the campaign", self.refuse(*self.command(bag, slice=10)))
        (self.folder / "grid.yaml").write_text(GRID + "track: {rail_inclination: 0.05}\n")
        self.assertIn("configs", self.refuse(*self.command(bag)))
        (self.folder / "grid.yaml").write_text(GRID)
        self.assertIn("other.bag is not in the campaign", self.refuse(*self.command(bag, self.make_bag(9, "other.bag"))))
        os.utime(bag, ns=(0, 0))
        self.assertIn("in.bag is not in the campaign in this folder, or has changed", self.refuse(*self.command(bag)))

    def test_a_folder_of_another_version_is_refused_by_name(self):
        bag = self.make_bag(3)
        self.assertEqual(run(*self.command(bag))[0], 0)
        before = {**self.manifest(), "format": 1}
        del before["bags"]["in.bag"]["done"][0]["lacking_neighbour"]
        (self.out / "manifest.json").write_text(json.dumps(before))
        printed = self.refuse(*self.command(bag))
        self.assertIn(f"--out {self.out}: holds a campaign of another version", printed)
        self.assertIn("take another folder", printed)
        self.assertEqual(self.manifest(), before)

    def test_two_bags_of_one_name_are_refused(self):
        bag = self.make_bag(3)
        self.assertIn("two bags are named in.bag", self.refuse(*self.command(bag, bag)))
        self.assertIn("No such file", self.refuse(*self.command(self.folder / "none.bag")))


if __name__ == "__main__":
    unittest.main()
