# SPDX-License-Identifier: BSD-3-Clause
"""contact_campaign refuses changes of a campaign, and what it cannot use, by name."""

import contextlib
import json
import os
import pathlib
import sys
import tempfile
import types
import unittest
import unittest.mock

from campaign_case import GRID, Case, Cluster, run, skip_without_dask

setUpModule = skip_without_dask


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
