# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay with displacements of the rails and distances in the bag."""

import math
from geometry_msgs.msg import Point, PointStamped, TwistStamped
from std_msgs.msg import Header
from wheel_rail_contact.msg import RailDisplacements, WheelsetContact

from replay_case import ReplayCase, load, pose, rows_of, stamp

PAIRS = 40
TOPICS = "track: {displacement: topic, distance: topic}\n"


def displacements(i, left=(0, 0, 0), right=(0, 0, 0)):
    message = RailDisplacements(header=Header(stamp=stamp(i)))
    for rail, values in (message.left, left), (message.right, right):
        rail.lateral, rail.vertical, rail.roll = values
    return message


def distance(i, x=0.0):
    return PointStamped(Header(stamp=stamp(i)), Point(x=x))


def twist(i, speed=20.0, rotation=0.0, frame="track"):
    message = TwistStamped(header=Header(stamp=stamp(i), frame_id=frame))
    message.twist.linear.x, message.twist.angular.y = speed, rotation
    return message


class Inputs(ReplayCase):
    def write(self, name, messages):
        """Writes a bag. @param messages function: number of a pair -> its messages by topic"""
        return self.write_bag([(f"/wheelset/{topic}", message, stamp(i)) for i in range(PAIRS)
                               for topic, message in messages(i).items()], name)

    def test_rails_displaced_with_the_wheelset_give_the_same_contact(self):
        def moved(i):
            shift = 1e-3 * math.sin(0.3 * i)
            there = pose(i)
            there.pose.position.y += shift
            return {"pose": there, "load": load(i), "distance": distance(i, 50.0 * i),
                    "rail_displacement": displacements(i, (shift, 2e-3, 0), (-shift, 2e-3, 0))}

        config = self.config(TOPICS)
        out, _ = self.replay(self.write("moved.bag", moved), "moved_out.bag", "--config", config)
        plain, _ = self.replay(self.make_bag(PAIRS), "plain.bag")
        results = self.results(out)
        self.assertEqual(len(results), PAIRS)
        for i, (result, same) in enumerate(zip(results, self.results(plain))):
            self.assertEqual(result.status, WheelsetContact.OK, result.status_text)
            shift = 1e-3 * math.sin(0.3 * i)
            for rail, lateral in (result.left_rail, shift), (result.right_rail, -shift):
                self.assertEqual((rail.given_lateral, rail.given_vertical, rail.given_roll), (lateral, 2e-3, 0))
                self.assertEqual((rail.lateral, rail.vertical, rail.roll), (lateral, 2e-3, 0))  # rigid rails
            # Rounding moves the grids slightly. The height is accurate to a share of the approach of 0.1 mm.
            self.assertAlmostEqual(result.wheelset.position.z, same.wheelset.position.z + 2e-3, delta=1e-7)
            for patch, other in zip(result.patches, same.patches):
                self.assertAlmostEqual(patch.max_pressure, other.max_pressure, delta=0.02 * other.max_pressure)

    def test_deflection_is_added_to_the_given_displacement(self):
        config = self.config(TOPICS + "rail_bending: {model: compliance, table: config/rails/pads_40_100.yaml}\n")
        rails = (5e-4, -2e-4, 1e-3), (0, 1e-4, -2e-3)
        bag = self.write("in.bag", lambda i: {"pose": pose(i), "load": load(i), "distance": distance(i),
                                              "rail_displacement": displacements(i, *rails)})
        out, _ = self.replay(bag, "out.bag", "--config", config, "--csv", self.folder / "out.csv")
        rows = {int(row["result [-]"]): row for row in rows_of(self.folder / "out.csv")}
        for i, result in enumerate(self.results(out)):
            for side, rail, given in zip(("left", "right"), (result.left_rail, result.right_rail), rails):
                self.assertEqual((rail.given_lateral, rail.given_vertical, rail.given_roll), given)
                self.assertLess(rail.vertical - given[1], -1e-4, "the load presses the rail down")
                for column, value in zip(("lateral [m]", "vertical [m]", "roll [rad]"), given):
                    self.assertEqual(float(rows[i][f"{side}_given_{column}"]), value)

    def test_distance_is_the_place_on_the_line(self):
        line = self.folder / "line.csv"
        line.write_text("x [m],rail_vertical_left [mm],rail_vertical_right [mm]\n0,0,0\n5,5,5\n10,10,10\n")
        bag = self.write("in.bag", lambda i: {"pose": pose(i), "load": load(i), "distance": distance(i, 0.3 * i)})
        by_topic = self.results(self.replay(bag, "topic.bag", "--config",
                                            self.config(f"track: {{line: {line}, distance: topic}}\n"))[0])
        for i, result in enumerate(by_topic):
            self.assertEqual(result.status, WheelsetContact.OK if 0.3 * i <= 10 else WheelsetContact.OUTSIDE_LINE)
            self.assertAlmostEqual(result.left_rail.given_vertical, 0.3e-3 * i if 0.3 * i <= 10 else 0, delta=1e-12)
        by_pose = self.results(self.replay(bag, "pose.bag", "--config", self.config(f"track: {{line: {line}}}\n"))[0])
        self.assertEqual({result.left_rail.given_vertical for result in by_pose}, {0}, "all poses are at x = 0")

    def test_nonfinite_values_are_refused_and_unmatched_messages_are_counted(self):
        def messages(i):
            right = (math.nan, 0, 0) if i == 3 else (0, 0, 0)
            found = {"pose": pose(i), "load": load(i), "distance": distance(i, math.inf if i == 5 else 0.0),
                     "rail_displacement": displacements(i, right=right)}
            return {topic: found[topic] for topic in found if (i, topic) not in ((7, "distance"), (8, "rail_displacement"))}

        out, printed = self.replay(self.write("in.bag", messages), "out.bag", "--config", self.config(TOPICS))
        results = self.results(out)
        self.assertEqual([result.header.stamp for result in results], [stamp(i) for i in range(PAIRS) if i not in (7, 8)])
        for i, reason in (3, "right rail displacement is not finite"), (5, "distance: point.x is not finite"):
            self.assertEqual((results[i].status, results[i].status_text), (WheelsetContact.INVALID_INPUT, reason))
        self.assertEqual({result.status for i, result in enumerate(results) if i not in (3, 5)}, {WheelsetContact.OK})
        self.assertIn("6 messages dropped: no message with a matching stamp", printed)

    def with_twist(self, messages, creep="method: linear", count=PAIRS):
        """Results of pairs with twists, of which those of `messages` are others than 20 m/s, or None. @return also the output"""
        def all_of(i):
            found = {"pose": pose(i), "load": load(i), "twist": messages.get(i, twist(i))}
            return {topic: message for topic, message in found.items() if message and i < count}

        config = self.config(f"creep: {{{creep}}}\n")
        out, printed = self.replay(self.write("twist.bag", all_of), f"{len(list(self.folder.iterdir()))}.bag", "--config", config)
        return self.results(out), printed

    def test_twist_is_counted_if_missing_refused_if_invalid_and_named_if_slow(self):
        messages = {4: None, 5: twist(5, math.nan), 6: twist(6, frame="body"), 7: twist(7, 0.009), 8: twist(8, 1001.0)}
        results, printed = self.with_twist(messages)
        self.assertEqual([result.header.stamp for result in results], [stamp(i) for i in range(PAIRS) if i != 4])
        self.assertIn("2 messages dropped: no message with a matching stamp", printed)  # pose and load
        found = {round((result.header.stamp.to_sec() - 1) * 1e3): result for result in results}
        for i, reason in ((5, "twist: linear is not finite"),
                          (6, "twist: frame_id is 'body', but must be 'track' (track/frame)"),
                          (8, "a velocity of the axle is not a number or beyond 1000 m/s or 10000 rad/s")):
            self.assertEqual((found[i].status, found[i].status_text), (WheelsetContact.INVALID_INPUT, reason))
        self.assertEqual((found[7].status, found[7].status_text),
                         (WheelsetContact.OK, "no creep forces: the speed is below 0.01 m/s"))
        self.assertEqual({(patch.creep.force_x, patch.creep.force_y) for patch in found[7].patches}, {(0, 0)})
        self.assertEqual((found[7].speed, found[7].left_wheel.friction_lateral_force), (0, 0))
        for i in 3, 9:
            self.assertEqual((found[i].status, found[i].status_text, found[i].speed), (WheelsetContact.OK, "", 20))
            self.assertLess(found[i].left_wheel.friction_lateral_force, -1e3, "spin pushes the rail inward")

    def test_reversing_vehicle_is_the_mirror_image(self):
        for method in "linear", "fastsim", "exact":
            forward, _ = self.with_twist({}, f"method: {method}", 12)
            back, _ = self.with_twist({i: twist(i, -20.0) for i in range(12)}, f"method: {method}", 12)
            self.assertEqual(len(back), 12)
            for one, other in zip(forward, back):
                self.assertEqual((one.status, other.status, one.speed, other.speed),
                                 (WheelsetContact.OK, WheelsetContact.OK, 20, -20))
                self.assertAlmostEqual(other.rotation, -one.rotation, delta=1e-4)
                for patch, image in zip(one.patches, other.patches):
                    force = math.hypot(patch.creep.force_x, patch.creep.force_y)
                    self.assertGreater(force, 100)
                    self.assertAlmostEqual(image.creep.force_x, -patch.creep.force_x, delta=0.005 * force)
                    self.assertAlmostEqual(image.creep.force_y, patch.creep.force_y, delta=0.005 * force)
                    self.assertAlmostEqual(image.creep.spin, -patch.creep.spin, delta=0.005 * abs(patch.creep.spin))

    def test_rotation_of_the_topic_drives_the_wheelset(self):
        drives = {i: twist(i, 20.0, 20.0 / 0.46 * (1 + 1e-3 * (i - 2))) for i in range(5)}
        results, _ = self.with_twist(drives, "method: fastsim, rotation: topic", 5)
        pulls = [result.rail_wrench.force.x for result in results]
        self.assertEqual(pulls, sorted(pulls), "the faster it turns, the more it pulls")
        self.assertTrue(pulls[0] < -5e3 and pulls[4] > 5e3, pulls)
        self.assertEqual([result.rotation for result in results], [drives[i].twist.angular.y for i in range(5)])

    def test_missing_topic_is_reported_with_its_name_and_type(self):
        config = self.config("track: {displacement: topic}\n")
        _, printed = self.replay(self.make_bag(5), "out.bag", "--config", config, status=1)
        self.assertIn("the bag has no topic /wheelset/rail_displacement; its topics of type "
                      "wheel_rail_contact/RailDisplacements: none", printed)
        config = self.config("track: {distance: topic}\n")
        bag = self.write("place.bag", lambda i: {"pose": pose(i), "load": load(i), "place": distance(i)})
        _, printed = self.replay(bag, "out.bag", "--config", config, status=1)
        self.assertIn("the bag has no topic /wheelset/distance; its topics of type geometry_msgs/PointStamped: "
                      "/wheelset/place", printed)

    def test_topic_of_a_wrong_type_is_refused(self):
        bag = self.write("in.bag", lambda i: {"pose": pose(i), "load": load(i), "rail_displacement": load(i)})
        _, printed = self.replay(bag, "out.bag", "--config", self.config("track: {displacement: topic}\n"), status=1)
        self.assertIn("topic /wheelset/rail_displacement is of type geometry_msgs/WrenchStamped, not "
                      "wheel_rail_contact/RailDisplacements", printed)

    def test_topics_that_are_not_required_have_no_effect(self):
        bag = self.write("in.bag", lambda i: {"pose": pose(i), "load": load(i), "distance": distance(i, math.nan),
                                              "rail_displacement": displacements(i, (1e-3, 0, 0))})
        out, printed = self.replay(bag)
        self.assertEqual(self.results(out), self.results(self.replay(self.make_bag(PAIRS), "plain.bag")[0]))
        self.assertNotIn("dropped", printed)
