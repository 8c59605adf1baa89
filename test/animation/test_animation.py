# SPDX-License-Identifier: BSD-3-Clause
"""contact_animation: drawn bodies touch where the answer says, and the file holds what was drawn."""
import pathlib
import sys
import unittest

import genpy
import numpy as np
import rosbag
from PIL import Image
from wheel_rail_contact.animation.command_line import main
from wheel_rail_contact.animation.gif import write_gif
from wheel_rail_contact.animation.section import section
from wheel_rail_contact.msg import WheelsetContact
from wheel_rail_contact.report.answers import full, read

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "replay"))
from sweep_case import SWEEP, SweepCase  # noqa: E402  (stands beside other tests)

MOVED = """\
rail: {profile: UIC60_manchester}
rail_bending: {model: prescribed, prescribed: {lateral: 2.0e-3, vertical: -1.0e-3, roll: 20.0e-3}}
"""


def distance(point, curve):
    """From a point to the nearest of a curve's chords."""
    start, way = curve[:-1], np.diff(curve, axis=0)
    share = np.clip(((point - start) * way).sum(axis=1) / (way**2).sum(axis=1), 0, 1)
    return np.hypot(*(start + share[:, None] * way - point).T).min()


class Animation(SweepCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "moved.yaml").write_text(MOVED)
        cls.moved = cls.replay("moved.bag", cls.folder / "moved.yaml")

    def animate(self, *arguments, status=0):
        return self.run_command(main, *arguments, status=status)

    def test_bodies_touch_where_the_answer_says(self):
        answers, topic = read(self.moved)
        for message in full(self.moved, topic, {0, 57, 100}).values():
            for patch in message.patches:
                shown = section(message, patch.side, answers.outlines)
                origin = 1e3 * np.array([(1, -1)[patch.side] * patch.pose.position.y, patch.pose.position.z])
                # The patch's origin lies on the rail; chords of 0.4 mm are off by 2 um where the radius is 13 mm.
                self.assertLess(distance(origin, shown.rail), 0.003)
                # The wheel is pressed into the rail by the approach.
                self.assertLess(distance(origin, shown.wheel), 1e3 * patch.approach + 0.003)
                drawn = next(p for p in shown.patches if p.force == 1e-3 * patch.normal_force)
                centre = drawn.pressure.sum(axis=0) @ drawn.surface / drawn.pressure.sum()
                self.assertLess(distance(centre, shown.rail), 1e3 * patch.approach)
                # Both bodies' outlines run along the patch's plane there.
                tangent = drawn.surface[-1] - drawn.surface[0]
                self.assertAlmostEqual(tangent @ drawn.normal, 0, delta=1e-9)

    def test_file_holds_the_pictures_of_both_runs(self):
        out = self.folder / "sweep.gif"
        self.animate(self.rigid, self.moved, "--out", out, "--frames", 3, "--rate", 4, "--side", "right")
        with Image.open(out) as gif:
            self.assertEqual((gif.n_frames, gif.info["duration"], gif.info["loop"]), (3, 250, 0))
            frames = []
            for k in range(gif.n_frames):
                gif.seek(k)
                frames.append(np.asarray(gif.convert("RGB")).astype(int))
        for frame in frames:
            self.assertEqual(frame[0, 0].tolist(), [255, 255, 255])
            for half in np.array_split(frame[:, :860], 2, axis=1):  # the colour scale stands beside both
                bodies = half[30:460]  # grey but for the pressure; titles above and histories below are coloured
                self.assertGreater(np.count_nonzero(np.ptp(bodies, axis=2) > 60), 200, "no pressure is drawn")
        self.assertTrue((frames[0] != frames[1]).any())

    def test_few_colours_are_kept_exactly(self):
        rng = np.random.default_rng(7)
        colours = rng.integers(0, 256, (200, 3), dtype=np.uint8)
        frames = [colours[rng.integers(0, 200, (40, 60))] for _ in range(3)]
        out = self.folder / "colours.gif"
        write_gif(out, frames, 10)
        with Image.open(out) as gif:
            for k, frame in enumerate(frames):
                gif.seek(k)
                self.assertTrue((np.asarray(gif.convert("RGB")) == frame).all())

    def test_what_cannot_be_drawn_is_told(self):
        out = self.folder / "none.gif"
        recorded = self.folder / "recorded.bag"
        with rosbag.Bag(str(recorded), "w") as bag:
            bag.write("/contact_node/contact", WheelsetContact(), genpy.Time(1))
        lifted = self.folder / "lifted.bag"
        with rosbag.Bag(str(lifted), "w") as bag, rosbag.Bag(str(self.rigid)) as whole:
            for topic, message, time, header in whole.read_messages(return_connection_header=True):
                if message._type == WheelsetContact._type:
                    message.patches = [patch for patch in message.patches if patch.side == 1]
                bag.write(topic, message, time, connection_header=header)  # which holds the profiles
        for arguments, words in (((lifted,), "lifted.bag: no answer that would be shown has a contact on the left side"),
                                 ((self.rigid, self.rigid, self.rigid), "at most two bags"),
                                 ((self.rigid, "--label", "a", "--label", "b"), "--label"),
                                 ((self.rigid, "--frames", 0), "--frames 0"), ((self.rigid, "--rate", -1), "--rate -1"),
                                 ((recorded,), "does not tell the profiles"), ((SWEEP,), "0 topics with answers")):
            self.assertIn(words, self.animate(*arguments, "--out", out, status=1))
        self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
