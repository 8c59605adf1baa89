# SPDX-License-Identifier: BSD-3-Clause
"""contact_report: the page contains pictures of the results in the bag, and the contact points are on the profiles."""
import base64
import html.parser
import io
import shutil
import subprocess
import sys
import unittest
from importlib.util import find_spec

import genpy
import numpy as np
import rosbag
from matplotlib import image
from commands import error_without_space
from sweep_case import PACKAGE, SWEEP, SweepCase
from wheel_rail_contact.msg import RailDisplacements, WheelsetContact
from wheel_rail_contact.report import drawing, histories, positions
from wheel_rail_contact.report.command_line import main
from wheel_rail_contact.report.page import extremes
from wheel_rail_contact.report.results import per_result, read, read_full

TABLE = PACKAGE / "config" / "rails" / "pads_40_100.yaml"
BENDING = f"""\
wheel: {{right: {{rolling_radius: 0.4597}}}}
rail: {{profile: UIC60_manchester, right: {{profile: 60E1, inclination: 1:20}}}}
rail_bending: {{model: compliance, table: {TABLE}}}
stress: {{depths: 4}}
"""
BROWSER = "chromium-headless-shell"
WINDOW = (1200, 6000)  # large enough for the whole page
PAGE_WIDTH = 1100      # of the text, defined in the style of the page


class Page(html.parser.HTMLParser):
    """Pictures, links and text of a page."""

    def __init__(self, text):
        super().__init__()
        self.pictures, self.links, self.text = [], [], ""
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if tag == "img" and name == "src":
                self.pictures.append(value)
            elif name in ("src", "href"):
                self.links.append(value)

    def handle_data(self, data):
        self.text += data + "\n"


class Report(SweepCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "bend.yaml").write_text(BENDING)
        cls.bending = cls.replay("bending.bag", cls.folder / "bend.yaml")
        (cls.folder / "displace.yaml").write_text((cls.folder / "bend.yaml").read_text() + "track: {displacement: topic}\n")
        cls.displaced = cls.replay("displaced.bag", cls.folder / "displace.yaml", cls.displaced_sweep())

    @classmethod
    def displaced_sweep(cls):
        """@return path of the sweep, on rails that are displaced by millimetres"""
        path = cls.folder / "displaced_sweep.bag"
        with rosbag.Bag(str(SWEEP)) as sweep, rosbag.Bag(str(path), "w") as bag:
            for topic, message, time in sweep.read_messages():
                bag.write(topic, message, time)
                if topic.endswith("pose"):
                    displacements = RailDisplacements(header=message.header)
                    displacements.left.lateral, displacements.left.roll = 2e-3, -5e-3
                    displacements.right.lateral, displacements.right.vertical = 1e-3, 3e-3
                    bag.write("/wheelset/rail_displacement", displacements, time)
        return path

    def report(self, *arguments, status=0):
        return self.run_command(main, *arguments, status=status)

    def test_page_contains_its_pictures_and_the_extreme_values(self):
        out = self.folder / "report"
        self.report(self.bending, "--out", out, "--compare", self.rigid, "--at", "1.0")
        page = Page((out / "report.html").read_text(encoding="utf-8"))
        self.assertEqual(page.links, [])
        # Histories, contact positions, pressures at the given instant and at the two worst ones, errors; stress of both wheels,
        # unless this is a build with sanitizers, without the Python module.
        self.assertEqual(len(page.pictures), 8 if find_spec("wheel_rail_contact._core") else 6)
        for picture in page.pictures:
            kind, data = picture.split(",", 1)
            self.assertEqual(kind, "data:image/png;base64")
            pixels = image.imread(io.BytesIO(base64.b64decode(data)), format="png")
            self.assertGreater(len(np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0)), 20, "a picture is empty")
        results, _ = read(self.bending)
        worst = 1e-6 * results.patches["max_pressure"][results.patches["side"] == 1].max()
        self.assertIn(f"max_pressure [MPa], right\n{worst:.0f}\n", page.text)
        highest = 1e-6 * results.patches["rail_stress.von_mises.value"][results.patches["side"] == 1].max()
        self.assertIn(f"von Mises stress in the rail [MPa], right\n{highest:.0f}\n", page.text)
        self.assertIn("Highest stress beneath the surface\n", page.text)
        self.assertIn("Dashed: rigid.bag", page.text)
        self.assertIn("rail_bending/model: compliance", page.text)

    @unittest.skipUnless(shutil.which(BROWSER), f"needs {BROWSER}")
    def test_browser_shows_every_picture(self):
        out = self.folder / "shown"
        self.report(self.rigid, "--out", out)
        shot = self.folder / "shot.png"
        subprocess.run([BROWSER, "--no-sandbox", "--hide-scrollbars", "--force-color-profile=srgb",
                        f"--window-size={WINDOW[0]},{WINDOW[1]}", f"--screenshot={shot}", (out / "report.html").as_uri()],
                       check=True, capture_output=True, timeout=60)
        page = image.imread(str(shot))[:, :, :3]
        self.assertEqual(page.shape[:2], WINDOW[::-1])
        seen = 0
        left = (WINDOW[0] - PAGE_WIDTH) // 2
        for path in sorted(out.glob("*.png")):
            picture = image.imread(str(path))[:, :, :3]
            height, width = picture.shape[:2]
            if width > PAGE_WIDTH:
                continue  # scaled by the browser
            column = page[:, left:left + width]
            # Candidates for the position are found with the middle row. At one of them, every pixel must be the same.
            middle = height // 2
            positions = np.flatnonzero((column == picture[middle]).all(axis=(1, 2))) - middle
            self.assertTrue(any(np.array_equal(column[top:top + height], picture) for top in positions if top >= 0),
                            f"{path.name} is not visible")
            seen += 1
        # Histories, two instants, errors. The picture of the contact positions is wider than the page.
        self.assertEqual(seen, 4)

    def test_contact_points_are_on_both_profiles(self):
        for bag in (self.rigid, self.bending, self.displaced):
            results, _ = read(bag)
            self.assertGreater(len(results.patches["side"]), 200)
            for side in (0, 1):
                for kind, points in zip(("rail", "wheel"), positions.contact_points(results, side)):
                    outline = results.outlines[side][kind]
                    distance = np.hypot(*(points[:, None, :] - outline[None, :, :]).T).min(axis=0)
                    # Half the step of the outline is 0.2 mm. The approach of the bodies is at most 0.2 mm.
                    self.assertLess(distance.max(), 0.3e-3, f"{bag.name}, {kind}, side {side}")

    def test_histories_contain_the_values_of_the_messages(self):
        results, topic = read(self.rigid)
        self.assertEqual(topic, "/contact_node/contact")
        right = np.flatnonzero(results.patches["side"] == 1)
        highest = per_result(results.patches["max_pressure"], results, right, "max")
        area = per_result(results.patches["area"], results, right, "sum")
        for index, message in read_full(self.rigid, topic, {0, 57, 100}).items():
            patches = [p for p in message.patches if p.side == 1]
            self.assertEqual(highest[index], max(p.max_pressure for p in patches))
            self.assertAlmostEqual(area[index], sum(p.area for p in patches), delta=1e-18)
            self.assertEqual(results.rail[index][1][3], message.right_rail.lateral_force)
            self.assertEqual(results.wheel[index][1].tolist()[:2], [message.right_wheel.lateral_force,
                                                                    message.right_wheel.vertical_force])
        span = results.stamp[50], results.stamp[60]
        np.testing.assert_array_equal(read(self.rigid, span=span)[0].y, results.y[50:61])
        self.assertEqual(read_full(self.rigid, topic, {7}, span)[7].wheelset.position.y, results.y[57])

    def test_friction_is_shown_only_if_there_is_any(self):
        path = self.folder / "friction.bag"
        with rosbag.Bag(str(self.rigid)) as old, rosbag.Bag(str(path), "w") as new:
            for topic, message, time in old.read_messages():
                message.right_wheel.friction_lateral_force = -4321.0
                for patch in message.patches:
                    patch.creep.adhesion_share, patch.creep.power = 0.25 + 0.5 * patch.side, 3e3
                new.write(topic, message, time)
        for bag, is_shown in ((path, True), (self.rigid, False)):
            results, _ = read(bag)
            _, left_out = histories.histories(results, None, self.folder / "friction.png")
            values = {row[0]: row[1] for row in extremes(results)}
            self.assertEqual([values.get(name) for name in ("Y by friction of the wheel [kN], right",
                                                            "adhesion_share [-], right", "power of friction [kW], left")],
                             ["-4.3", "0.75", "3.00"] if is_shown else [None] * 3)
            labels = [row.label.split("\n", maxsplit=1)[0] for row in histories._rows(results) if row.lines]
            self.assertEqual("friction power" in labels, is_shown)
            self.assertNotIn("friction", "".join(left_out))

    def test_long_histories_keep_their_peaks(self):
        x = np.arange(100000.0)
        y = np.sin(x / 5000)
        y[43210], y[43215], y[70000:70100] = 7, -7, np.nan
        place, mean, low, high = drawing.ranges(x, y)
        self.assertEqual((len(place), np.nanmax(high), np.nanmin(low), np.isnan(mean).sum()), (drawing.COLUMNS, 7, -7, 1))
        self.assertTrue((np.diff(place) > 0).all())
        np.testing.assert_allclose(np.nan_to_num(mean), np.nan_to_num(y).reshape(-1, 100).mean(axis=1), atol=1e-9)
        self.assertLess({43210, 43215}, set(drawing.prominent(x, np.nan_to_num(y)).tolist()))

    def test_reasons_that_differ_only_in_numbers_are_counted_together(self):
        path = self.folder / "remarks.bag"
        with rosbag.Bag(str(path), "w") as bag:
            for i, text in enumerate(("right rail: Y = 61.0 kN", "right rail: Y = -7.3 kN", "left rail: Y = 61.0 kN")):
                result = WheelsetContact(status_text=text)
                result.wheelset.orientation.w = 1
                bag.write("/contact_node/contact", result, genpy.Time(1 + i))
        results, _ = read(str(path))
        self.assertEqual(sorted(results.reasons.values()), [[1, "left rail: Y = 61.0 kN"], [2, "right rail: Y = 61.0 kN"]])

    def test_folder_that_cannot_be_written_is_reported_with_its_name(self):
        self.assertIn("contact_report: --out /sys/report: ", self.report(self.rigid, "--out", "/sys/report", status=1))
        command, out = PACKAGE / "scripts" / "contact_report", self.folder / "full"
        self.assertEqual(error_without_space(2**18, sys.executable, command, self.rigid, "--out", out),
                         f"contact_report: {out}: File too large\n")

    def test_bags_without_results_and_those_of_another_version_are_refused(self):
        self.assertIn("0 topics with results", self.report(SWEEP, "--out", self.folder / "none", status=1))
        self.assertIn("none from --from to", self.report(self.rigid, "--from", 99, "--out", self.folder / "none", status=1))
        self.assertIn("No such file", self.report(self.folder / "absent.bag", "--out", self.folder / "none", status=1))
        self.assertFalse((self.folder / "none").exists())

        class Other(WheelsetContact):
            _md5sum = "0" * 32

        path = self.folder / "other.bag"
        with rosbag.Bag(str(path), "w") as bag:
            bag.write("/contact_node/contact", Other(), genpy.Time(1))
        self.assertIn("another version", self.report(path, "--out", self.folder / "other", status=1))
