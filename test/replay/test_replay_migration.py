# SPDX-License-Identifier: BSD-3-Clause
"""Results and displacements that were stored before the messages had friction: refused with a remedy, and converted.

stored/without_friction.bag has a message of each of both types as of revision c44c0a4, in which every number is another one."""

import inspect
import pathlib
import subprocess
import sys
import unittest
import xml.etree.ElementTree

import genpy
import rosbag.migration
from wheel_rail_contact.msg import ContactDerivatives, PatchCreep, RailDisplacements, WheelsetContact
from wheel_rail_contact.report import command_line as report

from replay_case import ReplayCase

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
OLD = pathlib.Path(__file__).parent / "stored" / "without_friction.bag"
CHANGED = {"WheelsetContact", "ContactPatch", "WheelForces", "RailDeflection", "RailDisplacement"}  # have new fields
EMPTY = ("0.0", str(PatchCreep()), str(ContactDerivatives()))


def rules():
    """File with the rules that package.xml names."""
    root = xml.etree.ElementTree.parse(PACKAGE / "package.xml").getroot()
    return PACKAGE / root.find("export/rosbag").get("migration_rule_file")


@unittest.skipIf(sys.version_info >= (3, 13) and "locals()[name]" in inspect.getsource(rosbag.migration),
                 "rosbag fix of this system does not work with its Python: exec() no longer changes locals()")
class Migration(ReplayCase):
    def fix(self):
        path = self.folder / "fixed.bag"
        done = subprocess.run(["rosbag", "fix", "--noplugins", OLD, path, rules()], capture_output=True, text=True, check=False)
        self.assertIn("migrated successfully", done.stdout, done.stderr)
        return path

    def compare(self, old, new):
        """Expects the fields of an old message in the new one, and the others to be empty. @return number of fields"""
        self.assertEqual(old._type, new._type)
        added = set(new.__slots__) - set(old.__slots__)
        self.assertEqual(bool(added), old._type.split("/")[1] in CHANGED, old._type)
        for name in added:
            self.assertIn(str(getattr(new, name)), EMPTY, name)
        count = 0
        for name in old.__slots__:
            values = getattr(old, name), getattr(new, name)
            lists = isinstance(values[0], (list, tuple))
            self.assertTrue(not lists or len(values[0]) == len(values[1]), name)
            for one, other in zip(*values) if lists else [values]:
                if isinstance(one, genpy.Message):
                    count += self.compare(one, other)
                else:
                    self.assertEqual(one, other, name)
                    count += 1
        return count

    def test_every_field_of_old_messages_keeps_its_value_and_new_ones_are_empty(self):
        with rosbag.Bag(str(OLD)) as old, rosbag.Bag(str(self.fix())) as new:
            counts = {}
            for (topic, one, time), (same, other, when) in zip(old.read_messages(), new.read_messages()):
                self.assertEqual((topic, time), (same, when))
                counts[one._type] = self.compare(one, other)
                self.assertEqual(other._md5sum, {"wheel_rail_contact/WheelsetContact": WheelsetContact,
                                                 "wheel_rail_contact/RailDisplacements": RailDisplacements}[one._type]._md5sum)
        self.assertEqual(counts, {"wheel_rail_contact/WheelsetContact": 196, "wheel_rail_contact/RailDisplacements": 9})

    def test_old_messages_are_refused_with_the_remedy(self):
        config = self.config("track: {displacement: topic}\n")
        bag = self.folder / "in.bag"
        with rosbag.Bag(str(self.make_bag(3, "pairs.bag"))) as pairs, rosbag.Bag(str(OLD)) as old, \
                rosbag.Bag(str(bag), "w") as mixed:
            for source in pairs, old:
                for topic, raw, time in source.read_messages(raw=True):
                    mixed.write(topic, raw, time, raw=True)
        _, printed = self.replay(bag, "out.bag", "--config", config, status=1)
        self.assertIn("/wheelset/rail_displacement is of type wheel_rail_contact/RailDisplacements, but of another version of "
                      "its package: `rosbag fix` converts it", printed)
        printed = self.run_command(report.main, OLD, "--out", self.folder / "report", status=1)
        self.assertIn("convert the bag with `rosbag fix`", printed)

