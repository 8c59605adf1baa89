# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay on bags of a recorder that crashed, cut off files, and damaged ones: all that can be read is answered,
the rest is told, and the program does not end with 0."""

import os
import shutil
import struct
import subprocess

import rosbag
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from replay_case import DAMAGED, PROGRAM, ReplayCase, stamp, write_pairs

CHUNK = 20000  # bytes: about 30 pairs


def head(length, **fields):
    """Of a record of the format: its fields, and how long its data are."""
    header = b"".join(struct.pack("<I", len(name) + 1 + len(value)) + name.encode() + b"=" + value
                      for name, value in fields.items())
    return struct.pack("<I", len(header)) + header + struct.pack("<I", length)


class DamagedBags(ReplayCase):
    def setUp(self):
        super().setUp()
        whole = self.make_bag(250, "whole.bag", chunk_threshold=CHUNK)
        self.whole = self.answers(self.replay(whole, "expected.bag", "--no-grids")[0])
        self.assertEqual(len(self.whole), 250)

    def expect_damaged(self, bag, complaint, *options):
        out, printed = self.replay(bag, "out.bag", "--no-grids", *options, status=DAMAGED)
        self.assertIn(complaint, printed)
        return self.answers(out)

    def crashed_bag(self, count):
        """One whose only chunk was not closed."""
        crashed = self.folder / "crashed.bag"
        with rosbag.Bag(str(self.folder / "recording.bag"), "w", chunk_threshold=10**7) as bag:
            write_pairs(bag, count)
            bag._file.flush()
            shutil.copy(self.folder / "recording.bag", crashed)
        return crashed

    def test_bag_of_a_crashed_recorder_is_answered_up_to_its_last_message(self):
        crashed = self.folder / "crashed.bag"
        with rosbag.Bag(str(self.folder / "recording.bag"), "w", chunk_threshold=CHUNK) as bag:
            write_pairs(bag, 250)
            bag.flush()
            bag._file.flush()
            shutil.copy(self.folder / "recording.bag", crashed)
        self.assertEqual(self.expect_damaged(crashed, "not closed"), self.whole)

    def test_chunk_in_hand_of_a_crashed_recorder_is_read_as_far_as_it_goes(self):
        crashed = self.crashed_bag(200)
        with open(crashed, "r+b") as file:
            file.truncate(crashed.stat().st_size - 100)
        self.assertEqual(self.expect_damaged(crashed, "not closed"), self.whole[:199])

    def test_file_that_was_cut_off_is_answered_up_to_the_cut(self):
        for compression in ("none", "bz2", "lz4"):
            cut = self.make_bag(250, f"cut_{compression}.bag", chunk_threshold=CHUNK, compression=compression)
            with open(cut, "r+b") as file:
                file.truncate(int(0.6 * cut.stat().st_size))
            out, printed = self.replay(cut, compression + ".bag", "--no-grids", status=DAMAGED)
            answers = self.answers(out)
            self.assertIn("no usable index", printed)
            self.assertTrue(80 < len(answers) < 250, len(answers))
            self.assertEqual(answers, self.whole[:len(answers)])

    def test_damaged_chunk_is_left_out(self):
        for compression in ("bz2", "lz4"):
            bag = self.make_bag(250, f"{compression}.bag", chunk_threshold=CHUNK, compression=compression)
            content = bytearray(bag.read_bytes())
            middle = len(content) // 2
            content[middle:middle + 50] = bytes(50)
            bag.write_bytes(content)
            out, printed = self.replay(bag, compression + "_out.bag", "--no-grids", status=DAMAGED)
            self.assertIn("the chunk at byte", printed)
            stamps = {a.header.stamp for a in self.answers(out)}
            self.assertTrue(stamps < {a.header.stamp for a in self.whole})
            self.assertGreater(len(stamps), 120)

    def test_damaged_chunk_at_the_beginning_does_not_hide_those_after_it(self):
        bag = self.folder / "remarks.bag"
        with rosbag.Bag(str(bag), "w", chunk_threshold=CHUNK, compression="bz2") as file:
            for i in range(300):
                file.write("/remark", String(f"remark {i} " + 90 * "."), stamp(0))
            write_pairs(file, 100)
        content = bytearray(bag.read_bytes())
        first_chunk = 4117  # after magic and bag header
        content[first_chunk + 150:first_chunk + 200] = bytes(50)
        bag.write_bytes(content[:-200])  # the index is cut off
        self.assertEqual(self.expect_damaged(bag, f"the chunk at byte {first_chunk}", "--keep-topics"), self.whole[:100])

    def test_bag_that_lost_its_topics_says_why(self):
        bag = self.make_bag(250, "cut.bag", chunk_threshold=CHUNK, compression="bz2")
        with open(bag, "r+b") as file:
            file.truncate(4500)
        _, printed = self.replay(bag, "out.bag", status=1)
        self.assertIn("no topic /wheelset/", printed)
        self.assertIn("no usable index", printed)

    def peak_memory(self, bag, status=DAMAGED):
        """@return largest resident memory of a replay [MB], and what was printed"""
        with open(self.folder / "printed", "w+", encoding="utf-8") as printed:
            replay = subprocess.Popen([PROGRAM, bag, self.folder / f"{bag.stem}_out.bag"], stdout=printed, stderr=printed)
            _, ended, usage = os.wait4(replay.pid, 0)
            replay.returncode = os.waitstatus_to_exitcode(ended)
            printed.seek(0)
            text = printed.read()
        self.assertEqual(replay.returncode, status, text)
        return usage.ru_maxrss / 1e3, text

    def test_sizes_that_are_only_claimed_take_no_memory(self):
        usual, _ = self.peak_memory(self.folder / "whole.bag", 0)
        for compression in ("bz2", "lz4"):
            for size, complaint in ((2**32 - 1, "claims to hold more than 256 MiB"), (2**28, "compressed data is damaged")):
                bag = self.make_bag(250, f"{compression}_{size}.bag", chunk_threshold=CHUNK, compression=compression)
                content = bag.read_bytes()
                field = content.index(b"size=") + len(b"size=")  # of the first chunk
                bag.write_bytes(content[:field] + struct.pack("<I", size) + content[field + 4:])
                peak, printed = self.peak_memory(bag)
                self.assertIn(complaint, printed)
                self.assertLess(peak, usual + 50, bag.name)

    def test_hole_at_the_end_of_a_crashed_recording_takes_bounded_memory(self):
        usual, _ = self.peak_memory(self.folder / "whole.bag", 0)
        crashed = self.crashed_bag(200)
        with open(crashed, "r+b") as file:
            file.truncate(crashed.stat().st_size + 2 * 2**30)
        peak, printed = self.peak_memory(crashed)
        self.assertIn("only the first 256 MiB are read", printed)
        self.assertLess(peak, usual + 300)  # 256 MiB are 268 MB
        self.assertEqual(self.answers(self.folder / "crashed_out.bag")[-1].header.stamp, stamp(199))

    def test_connections_that_are_only_claimed_take_no_memory(self):
        usual, _ = self.peak_memory(self.folder / "whole.bag", 0)
        content = (self.folder / "whole.bag").read_bytes()
        # Written in parts: the peak of a process begins with the memory of the one that started it.
        thousands = [range(first, first + 1000) for first in range(10**6, 2 * 10**6, 1000)]

        counted = self.folder / "counted.bag"  # in the index, with a message each
        with open(counted, "wb") as file:
            file.write(content + head(8 * 10**6, op=b"\x06", chunk_pos=struct.pack("<Q", 4117),
                                      start_time=struct.pack("<II", 1, 0), end_time=struct.pack("<II", 2, 0)))
            for numbers in thousands:
                file.write(b"".join(struct.pack("<II", number, 1) for number in numbers))
        peak, _ = self.peak_memory(counted, 0)
        self.assertLess(peak, usual + 30)  # the record has 8 MB

        described = self.folder / "described.bag"  # in a chunk of a bag without index
        field = content.index(b"index_pos=") + len(b"index_pos=")
        end, = struct.unpack("<Q", content[field:field + 8])
        connection = head(0, op=b"\x07", topic=b"/t", conn=bytes(4))
        size = 10**6 * len(connection)
        with open(described, "wb") as file:
            file.write(content[:field] + bytes(8) + content[field + 8:end])
            file.write(head(size, op=b"\x05", compression=b"none", size=struct.pack("<I", size)))
            for numbers in thousands:
                file.write(b"".join(connection[:-8] + struct.pack("<II", number, 0) for number in numbers))
        peak, printed = self.peak_memory(described)
        self.assertIn("more than 65536 connections", printed)
        self.assertLess(peak, usual + 90)  # the chunk has 40 MB
        self.assertEqual(len(self.answers(self.folder / "described_out.bag")), len(self.whole))

    def test_transforms_that_are_only_claimed_take_no_memory(self):
        usual, _ = self.peak_memory(self.folder / "whole.bag", 0)
        for count in (2**32 - 1, 2 * 10**6):
            bag = self.make_bag(250, f"{count}.bag", chunk_threshold=CHUNK)
            with rosbag.Bag(str(bag), "a") as file:
                file.write("/tf", (TFMessage._type, struct.pack("<I", count), TFMessage._md5sum, TFMessage), stamp(100),
                           raw=True)
            peak, printed = self.peak_memory(bag)
            self.assertIn("250 pairs answered", printed)
            self.assertIn("1 messages are cut off", printed)
            self.assertLess(peak, usual + 50)

    def test_what_is_no_bag_is_refused(self):
        for content in (b"", b"no bag", b"#ROSBAG V1.2\n"):
            path = self.folder / "strange.bag"
            path.write_bytes(content)
            _, printed = self.replay(path, "out.bag", status=1)
            self.assertIn("no bag of version 2.0", printed)
        self.assertFalse((self.folder / "out.bag").exists())
        self.assertIn("No such file", self.replay(self.folder / "absent.bag", "out.bag", status=1)[1])


if __name__ == "__main__":
    import unittest
    unittest.main()
