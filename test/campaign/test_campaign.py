# SPDX-License-Identifier: BSD-3-Clause
"""contact_campaign writes the same files as contact_replay, even if workers or the campaign are killed."""

import gzip
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile

from campaign_case import PACKAGE, TIMEOUT, Case, Cluster, processes_of, run, skip_without_dask, wait_for
from replay_case import pairs, pose, stamp
from wheel_rail_contact.campaign.cluster import dask
from wheel_rail_contact.command import Failure
from wheel_rail_contact.msg import WheelsetContact

COMMAND = PACKAGE / "scripts" / "contact_campaign"
MEASURED_RAIL = PACKAGE / "test" / "stability" / "profiles" / "60e1_measured.csv"
PAIRS, SLICES = 3000, 10

setUpModule = skip_without_dask


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
        self.options += ["--config", self.config("rail_bending: {model: compliance, table: config/rails/pads_10_25.yaml,"
                                                 " neighbours: [{topic: /neighbour, distance: 2.5}]}\n")]
        neighbour = WheelsetContact(header=pose(399).header)
        bag = self.write_bag([*pairs(range(500)), ("/neighbour", neighbour, stamp(399))])
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
        bag = self.write_bag([("/vehicle/pose" if topic.endswith("pose") else "/axle/load", message, at)
                              for topic, message, at in pairs(range(500))])
        self.options += ["--pose", "/vehicle/pose", "--load", "axle/load"]
        self.campaign(bag)
        self.assertEqual(len(self.assert_done(bag)["slices"]), 2)

    def use_measured_rail(self):
        self.options += ["--config", self.config(f"rail: {{profile: {MEASURED_RAIL}}}\n")]

    def test_notes_on_profile_files_are_printed_once_and_are_no_faults(self):
        self.use_measured_rail()
        bags = [self.make_bag(count, f"{count}.bag") for count in (500, 30)]
        printed = self.campaign(*bags)
        self.assertEqual(printed.count(f"rail/profile = {MEASURED_RAIL}: table, "), 1, printed)
        for bag, slices in zip(bags, (2, 1)):
            done = self.assert_done(bag)["done"]
            self.assertEqual([record["faults"] for record in done], [[]] * slices)
            self.assertEqual([len(record["notes"]) for record in done], [1] + [0] * (slices - 1))

    def test_notes_do_not_hide_faults_of_the_bag(self):
        self.use_measured_rail()
        bag = self.make_bag(1000)
        bag.write_bytes(bag.read_bytes()[:-20000])
        self.campaign(bag, status=3)
        record, = self.manifest()["bags"][bag.name]["done"]
        self.assertGreater(len(record["faults"]), 0)
        for fault in record["faults"]:
            self.assertTrue(fault.startswith(f"{bag}: "), fault)

    def test_empty_name_of_a_topic_is_not_ignored(self):
        printed = self.campaign(self.make_bag(3), more=["--load", ""], status=1)
        self.assertIn('--load = "": must be the name of a topic', printed)

    def test_bag_in_which_most_poses_have_no_result_is_named(self):
        bag = self.write_bag([one for i, one in enumerate(pairs(range(1000))) if i < 800 or i % 2 == 0], "poor.bag")
        good = self.make_bag(30, "good.bag")
        for size in (300, 5000):  # four slices, one slice
            self.out = self.folder / f"out_{size}"
            printed = self.campaign(bag, good, status=4, slice=size)
            self.assertIn("poor.bag: only 400 of 1000 poses have a result", printed)
            self.assertNotIn("good.bag", printed)
            self.assertEqual({tuple(record["faults"]) for record in self.manifest()["bags"]["poor.bag"]["done"]}, {()})

    def test_bag_in_which_most_input_is_unusable_is_named(self):
        def change(i, there, _):
            there.header.frame_id = "nowhere" if i < 300 else "track"
            there.pose.orientation.w = 0 if 300 <= i < 600 else 1

        bag = self.write_bag(pairs(range(1000), change=change), "poor.bag")
        for size in (5000, 300):  # one slice, four slices
            self.out = self.folder / f"out_{size}"
            printed = self.campaign(bag, status=4, slice=size)
            self.assertIn("poor.bag: only 400 of 1000 poses have a result of usable input", printed)
            done = self.manifest()["bags"]["poor.bag"]["done"]
            self.assertEqual([sum(record[key] for record in done) for key in ("results", "poses")], [1000, 1000])
            self.assertEqual({tuple(record["faults"]) for record in done}, {()})

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
