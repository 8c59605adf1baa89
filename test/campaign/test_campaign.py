# SPDX-License-Identifier: BSD-3-Clause
"""contact_campaign writes the same files as contact_replay, even if workers or the campaign are killed."""

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

import rosbag
from wheel_rail_contact.campaign.campaign import AHEAD, Campaign
from wheel_rail_contact.campaign.cluster import dask
from wheel_rail_contact.campaign.command_line import main
from wheel_rail_contact.campaign.folder import Folder
from wheel_rail_contact.campaign.interrupts import Interrupts
from wheel_rail_contact.campaign.work import evaluate_slice, join_slices
from wheel_rail_contact.command import Failure
from wheel_rail_contact.msg import WheelsetContact

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PACKAGE / "test" / "replay"))
from replay_case import ReplayCase, load, pose, stamp  # noqa: E402  (in the folder of other tests)

COMMAND = PACKAGE / "scripts" / "contact_campaign"
GRID = "contact: {method: conjugate_gradient, grid: {along: 8, across: 24}}\n"  # short start time
TIMEOUT = 60  # [s] for the slowest machine
PAIRS, SLICE, SLICES = 3000, 300, 10


def setUpModule():
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
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        status = main([str(argument) for argument in arguments])
    return status, printed.getvalue()


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
        return self._start("dask_worker", self.address, "--nthreads", "1", "--no-nanny", "--local-directory",
                           str(self.folder))

    def close(self):
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


class LocalCluster(Case):
    def test_interrupted_or_killed_campaign_continues_without_repeating_finished_work(self):
        bag = self.make_bag(PAIRS)
        command = [str(word) for word in self.command(bag)]
        with subprocess.Popen([sys.executable, COMMAND, *command], stderr=subprocess.PIPE, text=True,
                              start_new_session=True) as first:
            wait_for(lambda: len(self.records()) >= 2)
            os.killpg(first.pid, signal.SIGINT)  # like Ctrl-C in a terminal
            printed = first.stderr.read()
        self.assertEqual((first.returncode, printed.splitlines()[-1]), (130, "contact_campaign: interrupted"))
        self.assertNotIn("Traceback", printed)
        with subprocess.Popen([sys.executable, COMMAND, *command], stderr=subprocess.DEVNULL) as second:
            wait_for(lambda: len(self.records()) >= 5)
            second.send_signal(signal.SIGKILL)
        self.assertLess(len(self.records()), SLICES)
        wait_for(lambda: not processes_of(self.folder))  # its workers and their replays end with the campaign
        before = self.records()
        status, printed = run(*command)
        self.assertEqual(status, 0, printed)
        entry = self.assert_done(bag)
        kept = {f"{k:06}.bag.json": record for k, record in enumerate(entry["done"])}
        for name, record in before.items():
            self.assertEqual(json.loads(record), kept[name])
        self.assertIn(f"{PAIRS} results of 1 bags", printed)
        state = (self.out / bag.name).stat()
        status, printed = run(*command)
        self.assertEqual((status, printed), (0, f"{PAIRS} results of 1 bags in {self.out}\n  OK: {PAIRS}\n"))
        self.assertEqual((self.out / bag.name).stat(), state)


class ExternalCluster(Case):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.cluster = Cluster(pathlib.Path(folder.name))
        cls.addClassCleanup(cls.cluster.close)
        cls.worker = cls.cluster.add_worker()
        with dask().Client(cls.cluster.address) as client:
            wait_for(client.nthreads)

    def campaign(self, *bags, status=0, **options):
        found, printed = run(*self.command(*bags, **options), "--scheduler", self.cluster.address)
        self.assertEqual(found, status, printed)
        return printed

    def test_slices_of_a_killed_worker_are_evaluated_by_another_worker(self):
        bag = self.make_bag(PAIRS)
        with subprocess.Popen([sys.executable, COMMAND, *map(str, self.command(bag)), "--scheduler",
                               self.cluster.address], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as campaign:
            wait_for(lambda: len(self.records()) >= 2 and any(self.out.glob("unfinished/*/*.partial")))
            before = self.records()
            self.worker.kill()
            type(self).worker = self.cluster.add_worker()
            self.assertEqual(campaign.wait(TIMEOUT), 0)
        workers = [record["worker"] for record in self.assert_done(bag)["done"]]
        self.assertEqual(len(set(workers)), 2)
        self.assertGreaterEqual(len(before), 2)

    def test_short_bag_is_one_slice_and_long_bag_is_divided(self):
        bags = [self.make_bag(1230, "long.bag"), self.make_bag(30, "short.bag")]
        printed = self.campaign(*bags)
        self.assertIn("1260 results of 2 bags", printed)
        self.assertIn("OK: 1260", printed)
        self.assertEqual([len(self.assert_done(bag)["slices"]) for bag in bags], [5, 1])

    def test_results_without_the_forces_of_a_neighbour_are_counted_over_all_slices(self):
        soft = self.folder / "soft.yaml"
        soft.write_text("rail_bending: {model: compliance, table: config/rails/pads_10_25.yaml,"
                        " neighbours: [{topic: /neighbour, distance: 2.5}]}\n")
        self.options += ["--config", soft]
        bag = self.make_bag(500)
        with rosbag.Bag(str(bag), "a") as file:
            file.write("/neighbour", WheelsetContact(header=pose(399).header), stamp(399))
        self.assertIn("/contact_node/contact: 400 results lack a neighbour's forces", self.campaign(bag))
        self.assertEqual(len(self.assert_done(bag)["done"]), 2)

    def test_failed_bag_does_not_stop_the_others(self):
        good, bad = self.make_bag(30, "good.bag"), self.folder / "bad.bag"
        bad.write_text("#ROSBAG V2.0\n")
        packed = self.folder / "packed.bag"
        packed.write_bytes(gzip.compress(good.read_bytes()))
        printed = self.campaign(bad, packed, good, status=1)
        self.assertIn("2 tasks failed", printed)
        for name in ("bad.bag", "packed.bag"):
            self.assertIn(f"{name}: evaluated as one slice, because its index cannot be read", printed)
            self.assertIn(f"{name}: contact_replay:", printed)
        self.assertEqual(len(self.results(self.out / "good.bag")), 30)

    def test_bag_without_index_is_one_slice_and_its_damage_is_reported(self):
        bag = self.make_bag(1000)
        bag.write_bytes(bag.read_bytes()[:-20000])
        printed = self.campaign(bag, status=3)
        self.assertIn("has no usable index", printed)
        self.assertEqual(len(self.manifest()["bags"][bag.name]["slices"]), 1)

    def test_topics_of_other_names_are_read_and_counted(self):
        bag, plain = self.folder / "named.bag", self.make_bag(500, "plain.bag")
        with rosbag.Bag(str(plain)) as source, rosbag.Bag(str(bag), "w") as named:
            for topic, message, at in source.read_messages():
                named.write("/vehicle/pose" if topic.endswith("pose") else "/axle/load", message, at)
        self.options += ["--pose", "/vehicle/pose", "--load", "axle/load"]
        self.campaign(bag)
        self.assertEqual(len(self.assert_done(bag)["slices"]), 2)

    def test_bag_in_which_most_poses_have_no_result_is_named(self):
        bag = self.folder / "poor.bag"
        with rosbag.Bag(str(bag), "w") as poor:
            for i in range(1000):
                poor.write("/wheelset/pose", pose(i), stamp(i))
                if i < 400:
                    poor.write("/wheelset/load", load(i), stamp(i))
        good = self.make_bag(30, "good.bag")
        for size in (300, 5000):  # four slices, one slice
            self.out = self.folder / f"out_{size}"
            printed = self.campaign(bag, good, status=4, slice=size)
            self.assertIn("poor.bag: only 400 of 1000 poses have a result", printed)
            self.assertNotIn("good.bag", printed)
            self.assertEqual({tuple(record["faults"]) for record in self.manifest()["bags"]["poor.bag"]["done"]}, {()})

    def test_slice_that_was_changed_on_the_disk_is_evaluated_again(self):
        from wheel_rail_contact.campaign import work
        bag, part = self.make_bag(30), self.out / "parts" / "0.bag"
        task = {"bag": str(bag), "part": str(part), "slice": [None, None], "folder": str(self.folder),
                "options": [str(word) for word in self.options]}
        record = work.evaluate_slice(task)
        whole = part.read_bytes()
        part.write_bytes(whole[:-1] + bytes([whole[-1] ^ 1]))
        join = {"parts": [str(part)], "results": str(self.out / "out.bag"), "options": []}
        with self.assertRaisesRegex(Failure, "was changed after it was written"):
            work.join_slices(join)
        self.assertEqual(work.evaluate_slice(task)["sha256"], record["sha256"])
        self.assertEqual(work.join_slices(join)["sha256"], record["sha256"])


class InOrder:
    """Replaces Dask. It has one core. The tasks do nothing, and end in the order in which they were submitted.

    @param statuses of each task, in the order in which they are returned
    """

    def __init__(self, *statuses):
        self.submitted, self.running, self.statuses = [], collections.deque(), statuses
        self.add, self.count = self.running.append, self.running.__len__

    def nthreads(self):
        return {"worker": 1}

    def submit(self, function, task, **_):
        self.submitted.append((function, task["name"]))
        return types.SimpleNamespace(key=len(self.submitted), statuses=iter(self.statuses),
                                     result=lambda: {"results": 1})

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
    def test_first_interrupt_is_noted_and_second_is_raised_immediately(self):
        with Interrupts() as interrupts:
            interrupts.raise_noted()
            interrupt()
            self.assertRaises(KeyboardInterrupt, interrupt)
            self.assertRaises(KeyboardInterrupt, interrupts.raise_noted)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_ignored_interrupt_stays_ignored(self):
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.SIG_IGN))
        with Interrupts() as interrupts:
            interrupt()
            interrupts.raise_noted()
        self.assertIs(signal.getsignal(signal.SIGINT), signal.SIG_IGN)


class InterruptedInADestructor:
    """Interrupts in its destructor, as may occur in a library. Python drops exceptions of destructors."""

    def __del__(self):
        interrupt()


class Order(unittest.TestCase):
    NAMES = [f"{k}.bag" for k in range(2 * AHEAD + 1)]  # more tasks than are submitted at a time

    def names_of_tasks(self, *statuses):
        """Names of the bags of all evaluate_slice tasks and of all join_slices tasks, in the order of their submission."""
        dask = InOrder(*statuses)
        plan = {"folder": "", "options": [],
                "bags": {name: {"bag": name, "slices": [[None, None]]} for name in self.NAMES}}
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch("distributed.as_completed", lambda: dask):
            campaign = Campaign(dask, plan, Folder(folder))
            campaign.run()
        self.assertEqual(campaign.failures, [])
        return [[name for done, name in dask.submitted if done is function] for function in (evaluate_slice, join_slices)]

    def test_each_of_many_short_bags_is_evaluated_and_joined_once(self):
        self.assertEqual(self.names_of_tasks("finished"), [self.NAMES, self.NAMES])

    def test_tasks_of_a_lost_worker_are_awaited_again(self):
        self.assertEqual([sorted(names) for names in self.names_of_tasks("lost", "pending", "finished")],
                         [self.NAMES, self.NAMES])

    def test_interrupt_in_a_destructor_ends_the_campaign(self):
        with unittest.mock.patch.object(InOrder, "is_empty", lambda _: InterruptedInADestructor() is None):
            self.assertRaises(KeyboardInterrupt, self.names_of_tasks, "finished")


class Misuse(Case):
    def refuse(self, *arguments):
        status, printed = run(*arguments)
        self.assertEqual(status, 1)
        return printed

    def test_changes_of_a_campaign_are_refused_by_name(self):
        bag = self.make_bag(30)
        self.out.mkdir()
        (self.out / "letter.txt").write_text("precious")
        self.assertIn("is not empty, and is not the folder of a campaign", self.refuse(*self.command(bag)))
        (self.out / "letter.txt").unlink()
        absent = "tcp://127.0.0.1:9"
        with unittest.mock.patch("wheel_rail_contact.campaign.cluster.TIMEOUT", 0.5):
            self.assertIn(f"--scheduler {absent}: found no scheduler", self.refuse(*self.command(bag), "--scheduler", absent))
        self.assertIn("slice: 10 differs from the campaign", self.refuse(*self.command(bag, slice=10)))
        (self.folder / "grid.yaml").write_text(GRID + "track: {rail_inclination: 0.05}\n")
        self.assertIn("configs: ", self.refuse(*self.command(bag)))
        (self.folder / "grid.yaml").write_text(GRID)
        self.assertIn("other.bag is not part of the campaign", self.refuse(*self.command(bag, self.make_bag(9, "other.bag"))))
        os.utime(bag, ns=(0, 0))
        self.assertIn("in.bag is not part of the campaign in this folder, or has been changed", self.refuse(*self.command(bag)))

    def test_folder_of_another_version_is_refused_by_name(self):
        bag = self.make_bag(3)
        self.assertEqual(run(*self.command(bag))[0], 0)
        before = {**self.manifest(), "format": 2}
        del before["bags"]["in.bag"]["done"][0]["lacking_neighbour"]
        (self.out / "manifest.json").write_text(json.dumps(before))
        printed = self.refuse(*self.command(bag))
        self.assertIn(f"--out {self.out}: contains a campaign of another version", printed)
        self.assertIn("use another folder", printed)
        self.assertEqual(self.manifest(), before)

    def test_missing_or_old_dask_is_reported_in_one_sentence(self):
        bag = self.make_bag(3)
        old = types.SimpleNamespace(Client=object, __version__="1.25.0")
        for module, message in ((None, "Dask cannot be imported (import of distributed"), (old, "Dask 1.25.0 is too old")):
            with unittest.mock.patch.dict(sys.modules, distributed=module):
                self.assertIn(f"contact_campaign: {message}", self.refuse(*self.command(bag)))

    def test_scheduler_without_workers_is_refused(self):
        bag = self.make_bag(3)
        with tempfile.TemporaryDirectory() as folder, contextlib.closing(Cluster(pathlib.Path(folder))) as cluster:
            with unittest.mock.patch("wheel_rail_contact.campaign.cluster.TIMEOUT", 0.5):
                printed = self.refuse(*self.command(bag), "--scheduler", cluster.address)
        self.assertIn("found no scheduler with workers at this address (no worker after 0.5 s)", printed)

    def test_two_bags_with_one_name_are_refused(self):
        bag = self.make_bag(3)
        self.assertIn("two bags are named in.bag", self.refuse(*self.command(bag, bag)))
        self.assertIn("No such file", self.refuse(*self.command(self.folder / "none.bag")))


if __name__ == "__main__":
    unittest.main()
