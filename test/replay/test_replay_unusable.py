# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay does not end with 0 if the input of most poses is unusable, although each of them has a result."""

from wheel_rail_contact.msg import WheelsetContact

from replay_case import DOUBTFUL_LOADS, FEW_RESULTS, ReplayCase, pairs, pose, stamp

PAIRS = 20


def without_direction(message):
    """Sets the length of the quaternion to 0."""
    message.pose.orientation.w = 0


def in_unknown_frame(message):
    message.header.frame_id = "nowhere"


def beside_the_rails(message):
    message.pose.position.y = 0.09


class UnusableInput(ReplayCase):
    def write(self, change, changed):
        """Writes pairs. @param changed number of the first poses that `change` alters"""
        return self.write_bag(pairs(range(PAIRS), change=lambda i, there, _: i < changed and change(there)))

    def test_bag_without_usable_input_does_not_end_with_0(self):
        for change, status in ((without_direction, WheelsetContact.INVALID_INPUT),
                               (in_unknown_frame, WheelsetContact.NO_TRANSFORM)):
            with self.subTest(change=change.__name__):
                out, printed = self.replay(self.write(change, PAIRS), f"{status}.bag", status=FEW_RESULTS)
                self.assertEqual([result.status for result in self.results(out)], [status] * PAIRS)
                self.assertIn("20 of 20 poses have a result; the input of 20 of these is unusable", printed)
                self.assertIn("in.bag: only 0 of 20 poses have a result of usable input", printed.splitlines()[-1])

    def test_loads_of_another_unit_or_sign_do_not_end_with_0(self):
        for factor, torque, words in ((1e-3, 0, "the mean wheel load is 100 N: loads must be in N, not in kN or t"),
                                      (-1, 0, "the mean wheel load is -100 kN, upward: "),
                                      (1, 1e6, "a wheel lifts in all results: unit or sign of torque.x?")):
            def change(_, __, forces):
                forces.wrench.force.z, forces.wrench.torque.x = -200e3 * factor, torque

            with self.subTest(words=words):
                bag = self.write_bag(pairs(range(PAIRS), change=change))
                _, printed = self.replay(bag, f"{torque}{factor}.bag", status=DOUBTFUL_LOADS)
                self.assertEqual(printed.count(words), 2)  # in the summary, and as the reason of the status

    def test_half_of_the_input_must_be_usable(self):
        _, printed = self.replay(self.write(without_direction, 11), "most.bag", status=FEW_RESULTS)
        self.assertIn("only 9 of 20 poses have a result of usable input", printed)
        _, printed = self.replay(self.write(without_direction, 10), "half.bag")
        self.assertIn("the input of 10 of these is unusable", printed)

    def test_dropped_poses_and_unusable_input_count_together(self):
        path = self.write(without_direction, 6)
        self.write_bag([("/wheelset/pose", pose(i), stamp(i)) for i in range(PAIRS, PAIRS + 9)], path.name, "a")
        _, printed = self.replay(path, status=FEW_RESULTS)
        self.assertIn("only 14 of 29 poses have a result of usable input", printed)

    def test_usable_input_without_a_contact_is_answered(self):
        out, printed = self.replay(self.write(beside_the_rails, PAIRS))
        self.assertEqual({result.status for result in self.results(out)}, {WheelsetContact.OFF_PROFILE})
        self.assertNotIn("unusable", printed)

    def test_part_of_a_bag_may_have_little_usable_input(self):
        self.replay(self.write(without_direction, 15), "part.bag", "--to", "1.016")

    def test_resumed_replay_counts_the_results_that_are_in_the_bag(self):
        count = 2000  # the results fill several chunks of the output
        path = self.write_bag(pairs(range(count), change=lambda i, there, _: i % 5 < 3 and without_direction(there)))
        out, printed = self.replay(path, status=FEW_RESULTS)
        summary = printed.splitlines()[1:]
        self.assertIn(f"only {2 * count // 5} of {count} poses have a result of usable input", summary[-1])
        _, printed = self.replay(path, out.name, "--resume", status=FEW_RESULTS)
        self.assertRegex(printed, r"; [1-9]\d+ results were already in the output")
        self.assertEqual(printed.splitlines()[1:], summary)
