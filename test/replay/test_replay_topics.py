# SPDX-License-Identifier: BSD-3-Clause
"""contact_replay on bags whose input topics have other names (--pose, --load and others)."""

from geometry_msgs.msg import Point, PointStamped

from replay_case import MISUSED, ReplayCase, load, pairs, pose, stamp

PAIRS = 60


class Topics(ReplayCase):
    def write(self, pose_topic, load_topic, *further, name="named.bag"):
        return self.write_bag([(topic, message, stamp(i)) for i in range(PAIRS) for topic, message in
                               ((pose_topic, pose(i)), (load_topic, load(i)), *((f, load(i)) for f in further))], name)

    def test_inputs_of_other_names_give_the_same_results(self):
        expected = self.results(self.replay(self.make_bag(PAIRS), "plain.bag")[0])
        bag = self.write("/vehicle/axle_1/pose", "forces/load")  # rosbag record writes both with a slash, other tools do not
        for number, (pose_name, load_name) in enumerate((("/vehicle/axle_1/pose", "/forces/load"),
                                                         ("vehicle/axle_1/pose", "forces/load"))):
            out, _ = self.replay(bag, f"{number}.bag", "--pose", pose_name, "--load", load_name)
            self.assertEqual(self.results(out), expected)

    def test_names_without_a_slash_are_relative_to_the_namespace_of_each_wheelset(self):
        both = [*pairs(range(PAIRS), "/front/wheelset"), *pairs(range(40), "/rear/wheelset")]
        path = self.write_bag([(topic.replace("wheelset/pose", "axle"), message, at) for topic, message, at in both])
        out, _ = self.replay(path, "out.bag", "--wheelset", "front", "rear", "--pose", "axle")
        self.assertEqual([len(self.results(out, f"/{wheelset}/contact_node/contact")) for wheelset in ("front", "rear")],
                         [PAIRS, 40])
        out, _ = self.replay(path, "one.bag", "--wheelset", "rear", "--pose", "/front/axle")
        self.assertEqual(len(self.results(out, "/rear/contact_node/contact")), 40)
        _, printed = self.replay(path, "no.bag", "--wheelset", "front", "rear", "--pose", "/axle", status=MISUSED)
        self.assertIn("--pose = /axle: must not begin with a slash if there are several wheelsets", printed)

    def test_every_input_can_be_named(self):
        bag = self.write("/pose", "/load", "/left", "/right")
        places = [PointStamped(pose(i).header, Point(x=100 + i)) for i in range(PAIRS)]
        self.write_bag([("/place", place, place.header.stamp) for place in places], bag.name, "a")
        config = self.config("track: {distance: topic}\nrail_bending: {model: compliance, lateral_force: topic, "
                             "table: config/rails/pads_40_100.yaml}\n")
        out, _ = self.replay(bag, "out.bag", "--config", config, "--pose", "pose", "--load", "load",
                             "--left-rail-force", "left", "--right-rail-force", "/right", "--distance", "place")
        self.assertEqual([result.distance for result in self.results(out)], [100 + i for i in range(PAIRS)])

    def test_missing_topics_are_reported_with_those_of_their_type_and_the_option(self):
        bag = self.write("/vehicle/pose", "/vehicle/load")
        _, printed = self.replay(bag, status=1)
        self.assertIn("the bag has no topic /wheelset/pose; its topics of type geometry_msgs/PoseStamped: /vehicle/pose; "
                      "--pose names another topic", printed)
        self.assertIn("the bag has no topic /wheelset/load; its topics of type geometry_msgs/WrenchStamped: /vehicle/load; "
                      "--load names another topic", printed)

    def test_name_of_an_input_that_is_not_required_is_refused(self):
        bag = self.write("/wheelset/pose", "/wheelset/load")
        _, printed = self.replay(bag, "out.bag", "--distance", "/place", status=MISUSED)
        self.assertIn("--distance = /place: the parameters require no wheelset/distance", printed)

    def test_two_inputs_on_one_topic_are_refused(self):
        bag = self.write("/wheelset/pose", "/wheelset/load", "/force")
        config = self.folder / "my.yaml"
        config.write_text("rail_bending: {model: compliance, lateral_force: topic, table: config/rails/pads_40_100.yaml}\n")
        for topic, names, options in (("/force", ("--left-rail-force", "force", "--right-rail-force", "/force"),
                 "--left-rail-force and --right-rail-force"),
                ("/wheelset/load", ("--left-rail-force", "force", "--right-rail-force", "wheelset/load"),
                 "--load and --right-rail-force"),
                ("/wheelset/right_rail_force", ("--left-rail-force", "wheelset/right_rail_force"),
                 "--left-rail-force and --right-rail-force")):
            _, printed = self.replay(bag, "out.bag", "--config", config, *names, status=MISUSED)
            self.assertIn(f"topic {topic} is given for two inputs, {options}: each input requires a topic of its own", printed)
        _, printed = self.replay(bag, "out.bag", "--wheelset", "a", "a/b", "--pose", "b/x", "--load", "x", status=MISUSED)
        self.assertIn("topic /a/b/x is given for two inputs, --pose and --load", printed)

    def test_empty_name_of_a_topic_is_refused(self):
        bag = self.write("/wheelset/pose", "/wheelset/load")
        for name in ("", "/"):
            _, printed = self.replay(bag, "out.bag", "--load", name, status=MISUSED)
            self.assertIn(f'--load = "{name}": must be the name of a topic', printed)

    def test_topic_of_another_type_is_refused(self):
        bag = self.write("/wheelset/pose", "/wheelset/load")
        self.write_bag([("/other_pose", pose(0), stamp(0))], bag.name, "a")
        _, printed = self.replay(bag, "out.bag", "--load", "/other_pose", status=1)
        self.assertIn("topic /other_pose is of type geometry_msgs/PoseStamped, not geometry_msgs/WrenchStamped", printed)

    def test_replay_is_resumed_only_with_the_same_topics(self):
        bag = self.write("/wheelset/pose", "/load", "/other_load")
        out, _ = self.replay(bag, "out.bag", "--load", "/load")
        _, printed = self.replay(bag, out.name, "--load", "/other_load", "--resume", status=1)
        self.assertIn("cannot be resumed", printed)
        self.replay(bag, out.name, "--load", "/load", "--resume")
