# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay on bags of a crashed recorder, on truncated files and on damaged files.

Everything readable is evaluated, the rest is reported, and the exit status is not 0.
"""

import os
import shutil
import struct
import subprocess

import rosbag
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from replay_case import DAMAGED, PROGRAM, ReplayCase, pairs, stamp

CHUNK = 20000  # [B] about 30 pairs
FIRST = 4117   # [B] place of the first chunk, after magic and bag header


def head(length, **fields):
    """Beginning of a record of the bag format: its fields, and the length of its data [B]."""
    header = b"".join(struct.pack("<I", len(name) + 1 + len(value)) + name.encode() + b"=" + value
                      for name, value in fields.items())
    return struct.pack("<I", len(header)) + header + struct.pack("<I", length)


class DamagedBags(ReplayCase):
    def setUp(self):
        super().setUp()
        whole = self.make_bag(250, "whole.bag", chunk_threshold=CHUNK)
        self.expected = self.results(self.replay(whole, "expected.bag", "--no-grids")[0])
        self.assertEqual(len(self.expected), 250)

    def results_of_damaged(self, bag, reason, *options):
        """Replays a damaged bag, and checks that the reason is reported. @return the results"""
        out, printed = self.replay(bag, "out.bag", "--no-grids", *options, status=DAMAGED)
        self.assertIn(reason, printed)
        return self.results(out)

    def crashed_bag(self, count, chunk=10**7):
        """A bag whose last chunk was not closed."""
        crashed = self.folder / "crashed.bag"
        with rosbag.Bag(str(self.folder / "recording.bag"), "w", chunk_threshold=chunk) as bag:
            for message in pairs(range(count)):
                bag.write(*message)
            bag._file.flush()
            shutil.copy(self.folder / "recording.bag", crashed)
        return crashed

    def test_bag_of_a_crashed_recorder_is_evaluated_up_to_its_last_message(self):
        self.assertEqual(self.results_of_damaged(self.crashed_bag(250, CHUNK), "not closed"), self.expected)

    def test_open_chunk_of_a_crashed_recorder_is_read_as_far_as_possible(self):
        crashed = self.crashed_bag(200)
        os.truncate(crashed, crashed.stat().st_size - 100)
        self.assertEqual(self.results_of_damaged(crashed, "not closed"), self.expected[:199])

    def test_truncated_file_is_evaluated_up_to_its_end(self):
        for compression in ("none", "bz2", "lz4"):
            cut = self.make_bag(250, f"cut_{compression}.bag", chunk_threshold=CHUNK, compression=compression)
            os.truncate(cut, int(0.6 * cut.stat().st_size))
            out, printed = self.replay(cut, compression + ".bag", "--no-grids", status=DAMAGED)
            results = self.results(out)
            self.assertIn("no usable index", printed)
            self.assertTrue(80 < len(results) < 250, len(results))
            self.assertEqual(results, self.expected[:len(results)])

    def reindexed(self, cut):
        """Copy of a bag with a new index, as `rosbag reindex` writes it."""
        path = cut.with_name("reindexed.bag")
        shutil.copy(cut, path)
        with rosbag.Bag(str(path), "a", allow_unindexed=True) as bag:
            for _ in bag.reindex():
                pass
        return path

    def test_truncated_chunk_of_a_reindexed_bag_is_read_although_its_index_is_empty(self):
        cut = self.make_bag(250, "cut.bag", chunk_threshold=10**7)
        os.truncate(cut, int(0.6 * cut.stat().st_size))
        results = self.results_of_damaged(self.reindexed(cut), "the index of the bag does not list the records from byte")
        self.assertTrue(150 < len(results) < 250, len(results))
        self.assertEqual(results, self.expected[:len(results)])
        self.assertEqual(results, self.results(self.replay(cut, "cut_out.bag", "--no-grids", status=DAMAGED)[0]))

    def test_truncated_chunk_before_the_index_is_read_up_to_the_index(self):
        cut = self.make_bag(250, "cut.bag", chunk_threshold=CHUNK)
        os.truncate(cut, int(0.6 * cut.stat().st_size))
        content = self.reindexed(cut).read_bytes()  # without the truncated chunk, which is inserted again
        field = content.index(b"index_pos=") + len(b"index_pos=")
        index, = struct.unpack("<Q", content[field:field + 8])
        # rosbag up to 1.15.9 leaves zeros in place of the chunk.
        end = min(index, FIRST + len(os.path.commonprefix([content[FIRST:], cut.read_bytes()[FIRST:]])))
        rest = cut.read_bytes()[end:]
        self.assertGreater(len(rest), 2000)
        bag = self.folder / "inserted.bag"
        bag.write_bytes(content[:field] + struct.pack("<Q", end + len(rest)) + content[field + 8:end] + rest + content[index:])
        results = self.results_of_damaged(bag, f"the index of the bag does not list the records from byte {end} on")
        self.assertEqual(results, self.expected[:len(results)])
        self.assertEqual(results, self.results(self.replay(cut, "cut_out.bag", "--no-grids", status=DAMAGED)[0]))

    def test_damaged_chunk_is_skipped(self):
        for compression in ("bz2", "lz4"):
            bag = self.make_bag(250, f"{compression}.bag", chunk_threshold=CHUNK, compression=compression)
            content = bytearray(bag.read_bytes())
            middle = len(content) // 2
            content[middle:middle + 50] = bytes(50)
            bag.write_bytes(content)
            out, printed = self.replay(bag, compression + "_out.bag", "--no-grids", status=DAMAGED)
            self.assertIn("the chunk at byte", printed)
            stamps = {r.header.stamp for r in self.results(out)}
            self.assertTrue(stamps < {r.header.stamp for r in self.expected})
            self.assertGreater(len(stamps), 120)

    def test_chunks_after_a_damaged_first_chunk_are_read(self):
        remarks = [("/remark", String(f"remark {i} " + 90 * "."), stamp(0)) for i in range(300)]
        bag = self.write_bag([*remarks, *pairs(range(100))], "remarks.bag", chunk_threshold=CHUNK, compression="bz2")
        content = bytearray(bag.read_bytes())
        content[FIRST + 150:FIRST + 200] = bytes(50)
        bag.write_bytes(content[:-200])  # the index is cut off
        self.assertEqual(self.results_of_damaged(bag, f"the chunk at byte {FIRST}", "--keep-topics"), self.expected[:100])

    def test_chunks_are_read_up_to_the_limit_of_their_total_size(self):
        bag = self.folder / "expanding.bag"
        with rosbag.Bag(str(bag), "w", chunk_threshold=CHUNK, compression="bz2") as file:
            for message in pairs(range(100)):
                file.write(*message)
            file.flush()
            for i in range(3):
                file.write("/remark", String(2**20 * "."), stamp(200 + i))
        for name, content in (("indexed", bag.read_bytes()), ("cut", bag.read_bytes()[:-200])):
            bag.write_bytes(content)
            out, printed = self.replay(bag, f"{name}.bag", "--no-grids", "--keep-topics", "--expand-up-to", 1, status=DAMAGED)
            self.assertEqual(printed.count("the decompressed chunks would exceed 1 MiB"), 1)
            self.assertEqual(self.results(out), self.expected[:100])
            out, _ = self.replay(bag, f"{name}_all.bag", "--no-grids", "--keep-topics", status=0 if name == "indexed" else DAMAGED)
            self.assertEqual(len(self.results(out, "/remark")), 3)

    def test_bag_without_readable_topics_is_reported_with_reason(self):
        bag = self.make_bag(250, "cut.bag", chunk_threshold=CHUNK, compression="bz2")
        os.truncate(bag, 4500)
        _, printed = self.replay(bag, "out.bag", status=1)
        self.assertIn("no topic /wheelset/", printed)
        self.assertIn("no usable index", printed)

    def peak_memory(self, bag, status=DAMAGED):
        """@return largest resident memory of a replay [MB], and its output"""
        with open(self.folder / "printed", "w+", encoding="utf-8") as printed:
            replay = subprocess.Popen([PROGRAM, bag, self.folder / f"{bag.stem}_out.bag"], stdout=printed, stderr=printed)
            _, ended, usage = os.wait4(replay.pid, 0)
            replay.returncode = os.WEXITSTATUS(ended) if os.WIFEXITED(ended) else -os.WTERMSIG(ended)
            printed.seek(0)
            text = printed.read()
        self.assertEqual(replay.returncode, status, text)
        return usage.ru_maxrss / 1e3, text

    def test_false_chunk_sizes_do_not_allocate_memory(self):
        usual, _ = self.peak_memory(self.folder / "whole.bag", 0)
        for compression in ("bz2", "lz4"):
            for size, reason in ((2**32 - 1, "gives a size above 256 MiB"), (2**28, "compressed data is damaged")):
                bag = self.make_bag(250, f"{compression}_{size}.bag", chunk_threshold=CHUNK, compression=compression)
                content = bag.read_bytes()
                field = content.index(b"size=") + len(b"size=")  # of the first chunk
                bag.write_bytes(content[:field] + struct.pack("<I", size) + content[field + 4:])
                peak, printed = self.peak_memory(bag)
                self.assertIn(reason, printed)
                self.assertLess(peak, usual + 50, bag.name)

    def test_file_hole_after_a_crashed_recording_allocates_limited_memory(self):
        usual, _ = self.peak_memory(self.folder / "whole.bag", 0)
        crashed = self.crashed_bag(200)
        os.truncate(crashed, crashed.stat().st_size + 2 * 2**30)
        peak, printed = self.peak_memory(crashed)
        self.assertIn("only the first 256 MiB are read", printed)
        self.assertLess(peak, usual + 300)  # 256 MiB are 268 MB
        self.assertEqual(self.results(self.folder / "crashed_out.bag")[-1].header.stamp, stamp(199))

    def test_false_connection_counts_do_not_allocate_memory(self):
        usual, _ = self.peak_memory(self.folder / "whole.bag", 0)
        content = (self.folder / "whole.bag").read_bytes()
        # Written in parts: the peak memory of a child process starts with the memory of its parent.
        thousands = [range(first, first + 1000) for first in range(10**6, 2 * 10**6, 1000)]

        counted = self.folder / "counted.bag"  # connections in the index, each with one message
        with open(counted, "wb") as file:
            file.write(content + head(8 * 10**6, op=b"\x06", chunk_pos=struct.pack("<Q", 4117),
                                      start_time=struct.pack("<II", 1, 0), end_time=struct.pack("<II", 2, 0)))
            for numbers in thousands:
                file.write(b"".join(struct.pack("<II", number, 1) for number in numbers))
        peak, _ = self.peak_memory(counted, 0)
        self.assertLess(peak, usual + 30)  # the record has 8 MB

        described = self.folder / "described.bag"  # connections in a chunk of a bag without index
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
        self.assertEqual(len(self.results(self.folder / "described_out.bag")), len(self.expected))

    def test_false_transform_counts_do_not_allocate_memory(self):
        usual, _ = self.peak_memory(self.folder / "whole.bag", 0)
        for count in (2**32 - 1, 2 * 10**6):
            bag = self.make_bag(250, f"{count}.bag", chunk_threshold=CHUNK)
            with rosbag.Bag(str(bag), "a") as file:
                file.write("/tf", (TFMessage._type, struct.pack("<I", count), TFMessage._md5sum, TFMessage), stamp(100),
                           raw=True)
            peak, printed = self.peak_memory(bag)
            self.assertIn("250 pairs evaluated", printed)
            self.assertIn("1 messages are truncated", printed)
            self.assertLess(peak, usual + 50)

    def test_files_that_are_not_bags_are_refused(self):
        for content in (b"", b"no bag", b"#ROSBAG V1.2\n"):
            path = self.folder / "strange.bag"
            path.write_bytes(content)
            _, printed = self.replay(path, "out.bag", status=1)
            self.assertIn("not a bag of version 2.0", printed)
        self.assertFalse((self.folder / "out.bag").exists())
        self.assertIn("No such file", self.replay(self.folder / "absent.bag", "out.bag", status=1)[1])
