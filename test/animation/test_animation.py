# SPDX-License-Identifier: BSD-3-Clause
"""contact_animation: the drawn bodies touch at the contact positions of the results, and the file contains the pictures."""
import genpy
import numpy as np
import rosbag
from PIL import Image
from sweep_case import SWEEP, SweepCase
from wheel_rail_contact.animation.command_line import main
from wheel_rail_contact.animation.gif import write_gif
from wheel_rail_contact.animation.run import read_run
from wheel_rail_contact.animation.section import section
from wheel_rail_contact.msg import WheelsetContact
from wheel_rail_contact.report.results import read, read_full

MOVED = """\
wheel: {left: {rolling_radius: 0.4597}}
rail: {profile: UIC60_manchester, right: {profile: 60E1, inclination: 1:20}}
rail_bending: {model: prescribed, prescribed: {lateral: 2.0e-3, vertical: -1.0e-3, roll: 20.0e-3}}
"""


def distance(point, curve):
    """Distance from a point to the nearest chord of a curve."""
    start, chord = curve[:-1], np.diff(curve, axis=0)
    share = np.clip(((point - start) * chord).sum(axis=1) / (chord**2).sum(axis=1), 0, 1)
    return np.hypot(*(start + share[:, None] * chord - point).T).min()


class Animation(SweepCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "moved.yaml").write_text(MOVED)
        cls.moved = cls.replay("moved.bag", cls.folder / "moved.yaml")

    def animate(self, *arguments, status=0):
        return self.run_command(main, *arguments, status=status)

    def test_drawn_bodies_touch_at_the_contact_positions_of_the_results(self):
        results, topic = read(self.moved)
        for message in read_full(self.moved, topic, {0, 57, 100}).values():
            for patch in message.patches:
                shown = section(message, patch.side, results.outlines[patch.side])
                origin = 1e3 * np.array([(1, -1)[patch.side] * patch.pose.position.y, patch.pose.position.z])
                # The origin of the patch is on the rail. At a radius of 13 mm, chords of 0.4 mm deviate by 2 um.
                self.assertLess(distance(origin, shown.rail), 0.003)
                # The wheel overlaps the rail by the approach.
                self.assertLess(distance(origin, shown.wheel), 1e3 * patch.approach + 0.003)
                drawn = next(p for p in shown.patches if p.force == 1e-3 * patch.normal_force)
                centre = drawn.pressure.sum(axis=0) @ drawn.surface / drawn.pressure.sum()
                self.assertLess(distance(centre, shown.rail), 1e3 * patch.approach)
                # The plane of the patch is perpendicular to its normal.
                tangent = drawn.surface[-1] - drawn.surface[0]
                self.assertAlmostEqual(tangent @ drawn.normal, 0, delta=1e-9)

    def test_file_contains_the_pictures_of_both_runs(self):
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
            for half in np.array_split(frame[:, :860], 2, axis=1):  # without the colour scale on the right
                bodies = half[30:460]  # only the pressure is coloured; excludes the coloured titles and histories
                self.assertGreater(np.count_nonzero(np.ptp(bodies, axis=2) > 60), 200, "no pressure is drawn")
        self.assertTrue((frames[0] != frames[1]).any())

    def test_frames_with_at_most_256_colours_keep_them_exactly(self):
        rng = np.random.default_rng(7)
        colours = rng.integers(0, 256, (200, 3), dtype=np.uint8)
        frames = [colours[rng.integers(0, 200, (40, 60))] for _ in range(3)]
        out = self.folder / "colours.gif"
        write_gif(out, frames, 10)
        with Image.open(out) as gif:
            for k, frame in enumerate(frames):
                gif.seek(k)
                self.assertTrue((np.asarray(gif.convert("RGB")) == frame).all())

    def edited(self, name, edit):
        """@return path of the results of the sweep, each changed by a function of its index and the message"""
        path = self.folder / name
        with rosbag.Bag(str(path), "w") as bag, rosbag.Bag(str(self.rigid)) as source:
            results = 0
            for topic, message, time, header in source.read_messages(return_connection_header=True):
                if message._type == WheelsetContact._type:
                    edit(results, message)
                    results += 1
                bag.write(topic, message, time, connection_header=header)  # contains the profiles
        return path

    def test_wheel_without_a_contact_and_the_sign_of_the_steepest_angle_are_stated(self):
        def edit(index, message):
            if index > 0:
                message.status, message.patches = message.LIFT_OFF, [patch for patch in message.patches if patch.side == 1]
            else:
                message.patches[0].contact_angle = np.radians(-12)

        run = read_run(self.edited("back.bag", edit), "label", 0, 2, None)
        self.assertIn("angle -12°", run.texts[0])
        self.assertEqual(run.texts[1], "LIFT_OFF: the left wheel carries no load")

    def test_undrawable_input_is_reported_and_writes_no_file(self):
        out = self.folder / "none.gif"
        recorded = self.folder / "recorded.bag"
        with rosbag.Bag(str(recorded), "w") as bag:
            bag.write("/contact_node/contact", WheelsetContact(), genpy.Time(1))
        def lift(_, message):
            message.patches = [patch for patch in message.patches if patch.side == 1]

        lifted = self.edited("lifted.bag", lift)
        for arguments, words in (((lifted,), "lifted.bag: no result to be shown has a contact on the left side"),
                                 ((self.rigid, self.rigid, self.rigid), "3 bags: must be at most two"),
                                 ((self.rigid, "--label", "a", "--label", "b"), "--label"),
                                 ((self.rigid, "--frames", 0), "--frames 0"), ((self.rigid, "--rate", -1), "--rate -1"),
                                 ((recorded,), "does not contain the outlines of the profiles"),
                                 ((SWEEP,), "0 topics with results")):
            self.assertIn(words, self.animate(*arguments, "--out", out, status=1))
        self.assertFalse(out.exists())
