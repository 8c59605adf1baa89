# SPDX-License-Identifier: BSD-3-Clause
"""contact_states: conversion of tables to bags and back, in all units and axes, without loss."""
import filecmp
import math
import pathlib
import subprocess
import sys
from unittest import mock

import rosbag
from geometry_msgs.msg import PoseStamped, WrenchStamped
from states_case import StatesCase
from commands import error_without_space
from wheel_rail_contact.states.command_line import main
from wheel_rail_contact.states.state import State, read_bag, stamp_of, write_bag

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"


class States(StatesCase):
    def test_units_are_converted_to_si(self):
        state, = self.states_of("time [ms];y [mm];yaw [deg];force_z [kN];torque_x [kN m];Y_left [kN]\n"
                                "1500.25; -2.5; 0.5; -200; 3; 4.5\n")
        self.assertEqual(state.time_ns, 1500250000)
        for value, expected in ((state.y, -2.5e-3), (state.yaw, math.radians(0.5)), (state.force_z, -200e3),
                                (state.torque_x, 3e3), (state.left_lateral_force, 4.5e3)):
            self.assertAlmostEqual(value, expected, delta=1e-12 * abs(expected))
        self.assertIsNone(state.right_lateral_force)

    def test_railway_axes_are_right_and_down(self):
        state, = self.states_of("time [s],x [m],y [mm],z [mm],roll [mrad],yaw [mrad],force_z [kN],torque_x [kN m],"
                                "Y_right [kN],pitch [rad]\n1,7,3,-460,0.2,1.5,200,5,9,-2.8\n", "--axes", "railway")
        got = (state.x, state.y, state.z, state.roll, state.yaw, state.force_z, state.torque_x, state.right_lateral_force,
               state.pitch)
        for value, expected in zip(got, (7, -3e-3, 0.46, 0.2e-3, -1.5e-3, -200e3, 5e3, 9e3, 2.8)):
            self.assertAlmostEqual(value, expected, delta=1e-12 * abs(expected))

    def test_displacements_of_the_rails_are_outward_and_down_in_railway_axes(self):
        table = ("time [s],y [mm],rail_lateral_left [mm],rail_vertical_left [mm],rail_roll_left [mrad],rail_lateral_right [mm],"
                 "rail_vertical_right [mm],rail_roll_right [mrad],distance [m]\n1,0,1,2,3,-4,-5,-6,1234.5\n")
        for axes, down in ("rep103", 1), ("railway", -1):
            state, = self.states_of(table, "--axes", axes)
            for side, expected in ("left", (1e-3, 2e-3 * down, 3e-3)), ("right", (-4e-3, -5e-3 * down, -6e-3)):
                for name, value in zip(("lateral", "vertical", "roll"), expected):
                    self.assertAlmostEqual(getattr(state, f"{side}_rail_{name}"), value, delta=1e-15, msg=(axes, side, name))
            self.assertEqual(state.distance, 1234.5)

    def test_velocities_are_those_of_the_twist_and_of_the_rails(self):
        table = ("time [s],y [mm],speed [km/h],lateral_velocity [mm/s],vertical_velocity [mm/s],roll_rate [mrad/s],"
                 "rotation [rad/s],yaw_rate [mrad/s],rail_vertical_velocity_left [mm/s]\n1,0,72,3,4,5,43,6,7\n")
        for axes, down in ("rep103", 1), ("railway", -1):
            self.states_of(table, "--axes", axes)
            with rosbag.Bag(str(self.folder / "out.bag")) as bag:
                messages = {topic: message for topic, message, _ in bag.read_messages()}
            message = messages["/wheelset/twist"]
            self.assertEqual((message.header.frame_id, message.header.stamp.to_nsec()), ("track", 10**9))
            for vector, expected in ((message.twist.linear, (20, 3e-3 * down, 4e-3 * down)),
                                     (message.twist.angular, (5e-3, 43 * down, 6e-3 * down))):
                for value, wanted in zip((vector.x, vector.y, vector.z), expected):
                    self.assertAlmostEqual(value, wanted, delta=1e-14)
            self.assertAlmostEqual(messages["/wheelset/rail_displacement"].left.vertical_velocity, 7e-3 * down, delta=1e-15)
        self.assertIn("yaw_rate requires speed", self.error_of("time [s],y [mm],yaw_rate [rad/s]\n1,0,1\n"))

    def test_several_tables_are_wheelsets_of_one_bag_in_the_order_of_their_times(self):
        for name, y in ("front", 1), ("rear", 2):
            (self.folder / f"{name}.csv").write_text(f"time [s],y [mm]\n0,{y}\n{y},{y}\n")
        tables = [self.folder / "front.csv", self.folder / "rear.csv"]
        names = ["--wheelset", "front", "--wheelset", "/rear"]
        printed = self.run_command(main, *tables, self.folder / "out.bag", *names, "--start", "10")
        self.assertIn("4 states", printed)
        with rosbag.Bag(str(self.folder / "out.bag")) as bag:
            written = [(topic, message.pose.position.y, at.to_sec()) for topic, message, at in bag.read_messages()]
        self.assertEqual(written, [("/front/wheelset/pose", 1e-3, 10), ("/rear/wheelset/pose", 2e-3, 10),
                                   ("/front/wheelset/pose", 1e-3, 11), ("/rear/wheelset/pose", 2e-3, 12)])
        for options, reason in ((names, "several tables require --start"), (names[:2], "2 times IN, but 1 wheelsets"),
                                (names[:2] * 2, "--wheelset front is given twice")):
            self.assertIn(reason, self.run_command(main, *tables, self.folder / "no.bag", *options, status=2))

    def test_displacements_and_distance_are_written_only_if_they_are_given(self):
        without, = self.states_of("time [s],y [mm]\n1,0\n")
        self.assertEqual((without.left_rail_lateral, without.right_rail_roll, without.distance), (None, None, None))
        self.states_of("time [s],y [mm],rail_vertical_right [um]\n1,0,250\n")
        with rosbag.Bag(str(self.folder / "out.bag")) as bag:
            messages = {topic: message for topic, message, _ in bag.read_messages()}
        self.assertEqual(set(messages), {"/wheelset/pose", "/wheelset/rail_displacement"})
        displacements = messages["/wheelset/rail_displacement"]
        self.assertEqual(displacements.header.stamp.to_nsec(), 10**9)
        self.assertAlmostEqual(displacements.right.vertical, 250e-6, delta=1e-18)
        self.assertEqual((displacements.left.lateral, displacements.left.vertical, displacements.right.roll), (0, 0, 0))

    def test_wheel_loads_are_converted_to_force_and_moment(self):
        # Q = -force.z / 2 -+ torque.x / (2 b), b = 0.75 m.
        state, = self.states_of("time [s],y [mm],Q_left [kN],Q_right [kN]\n1,0,120,90\n")
        self.assertAlmostEqual(-state.force_z / 2 - state.torque_x / 1.5, 120e3, delta=1e-6)
        self.assertAlmostEqual(-state.force_z / 2 + state.torque_x / 1.5, 90e3, delta=1e-6)

    def test_conversion_to_a_table_and_back_is_exact(self):
        # Without angles: their conversion to a quaternion has rounding errors, 1e-16 rad.
        states = [State(10**9 + i * 1234567, 0.1 * i, math.sin(i) / 300, 0.46, 0.0, 0.0, -2e5 / 3 * (i + 1), math.pi * i,
                        1e4 / (i + 1), -1e4 * (i + 1), *(1e-3 * math.cos(i + k) for k in range(6)), 1e3 + i / 7,
                        *(math.cos(i + k) for k in range(12))) for i in range(20)]
        write_bag(self.folder / "a.bag", states, "/front")
        for axes in ("rep103", "railway"):
            self.run_states("a.bag", f"{axes}.csv", "--axes", axes, "--wheelset", "front")
            self.run_states(f"{axes}.csv", f"{axes}.bag", "--axes", axes, "--wheelset", "/front/")
            self.assertTrue(filecmp.cmp(self.folder / "a.bag", self.folder / f"{axes}.bag", shallow=False))
        self.assertEqual(read_bag(self.folder / "rep103.bag", "/front"), states)

    def test_angles_are_restored_except_for_rounding(self):
        write_bag(self.folder / "a.bag", [State(10**9, roll=-2e-3, yaw=0.01), State(2 * 10**9, roll=0.1, yaw=-0.2)])
        for state, (roll, yaw) in zip(read_bag(self.folder / "a.bag"), ((-2e-3, 0.01), (0.1, -0.2))):
            self.assertAlmostEqual(state.roll, roll, delta=1e-15)
            self.assertAlmostEqual(state.yaw, yaw, delta=1e-15)

    def test_axes_of_a_table_from_a_bag_are_those_of_its_first_line(self):
        write_bag(self.folder / "a.bag", [State(10**9, y=0.003, yaw=0.25)])
        self.run_states("a.bag", "a.csv", "--axes", "railway")
        self.run_states("a.csv", "b.bag")
        self.assertEqual(read_bag(self.folder / "b.bag")[0].y, 0.003)
        self.assertIn("'# axes: railway' contradicts --axes rep103",
                      self.run_states("a.csv", "c.bag", "--axes", "rep103", status=1))
        self.assertIn("contradicts --axes rep103 or railway", self.error_of("# axes: z up\ntime [s],y [m]\n1,0\n"))

    def test_messages_of_a_bag_that_are_left_out_are_counted(self):
        with rosbag.Bag(str(self.folder / "a.bag"), "w") as bag:
            for topic, message, stamps in (("pose", PoseStamped, (0, 0, 10**9, 10**9)), ("load", WrenchStamped, (0, 10**9 + 1))):
                for stamp in stamps:
                    message_of = message()
                    message_of.header.stamp = stamp_of(stamp)
                    if topic == "pose":
                        message_of.pose.orientation.w = 1
                    bag.write(f"/wheelset/{topic}", message_of, stamp_of(10**9))
        printed = self.run_states("a.bag", "a.csv")
        for line in ("2 left out, pose: stamp 0", "1 left out, pose: stamp of another pose", "1 left out, load: stamp 0",
                     "1 left out, load: no pose with the same stamp"):
            self.assertIn(line, printed)

    def test_one_of_the_files_must_be_a_bag(self):
        for names in (("a.csv", "b.csv"), ("a.bag", "b.bag"), ("a.bag", "b.txt"), ("a", "b"), ("a.bag", "b.csv", "c.csv")):
            self.assertIn("one of IN and OUT must be a bag", self.run_states(*names, status=2))

    def test_existing_file_is_not_overwritten(self):
        (self.folder / "in.csv").write_text("time [s],y [mm]\n1,0\n")
        (self.folder / "out.bag").write_text("precious")
        self.assertIn("already exists", self.run_states("in.csv", "out.bag", status=1))
        self.assertEqual((self.folder / "out.bag").read_text(), "precious")

    def test_full_disk_is_reported_with_the_name_of_the_file_and_leaves_no_file(self):
        # The disk is full at the end of a bag with poses, and in the middle of a larger one with loads.
        for force in (None, -2e5):
            states = [State(10**9 + i, y=1e-3 / (i + 1), force_z=force and force - i) for i in range(5000)]
            for name in ("in.bag", "in.csv"):
                (self.folder / name).unlink(missing_ok=True)
            write_bag(self.folder / "in.bag", states)
            self.run_states("in.bag", "in.csv")
            for source, target in (("in.bag", "out.csv"), ("in.csv", "out.bag")):
                paths = self.folder / source, self.folder / target
                error = error_without_space(2**16, sys.executable, SCRIPTS / "contact_states", *paths)
                self.assertEqual(error.splitlines()[-1], f"contact_states: {paths[1]}: File too large")
                self.assertNotIn("Traceback", error)
                self.assertFalse(paths[1].exists())

    def test_interruption_leaves_no_file(self):
        self.write("time [s],y [mm],force_z [N]\n1,0,-1\n")

        def interrupted(path, *_):
            pathlib.Path(path).write_text("a part")
            raise KeyboardInterrupt
        with mock.patch("wheel_rail_contact.states.command_line.write_wheelsets", interrupted):
            self.run_states("in.csv", "out.bag", status=130)
        self.assertFalse((self.folder / "out.bag").exists())

    def test_paths_that_cannot_be_written_are_reported(self):
        (self.folder / "in.csv").write_text("time [s],y [mm],force_z [N]\n1,0,-1\n")
        for target in ("/sys/out.bag", self.folder / "nowhere" / "out.bag"):  # not even root can create files in /sys
            printed = self.run_states("in.csv", target, status=1)
            self.assertIn(f"contact_states: {target}: ", printed)
            self.assertEqual(printed.count("\n"), 1, printed)

    def test_unreadable_bags_are_reported_in_one_sentence(self):
        (self.folder / "text.bag").write_text("no bag at all\n")
        write_bag(self.folder / "whole.bag", [State(10**9 + i) for i in range(100)])
        whole = (self.folder / "whole.bag").read_bytes()
        (self.folder / "cut.bag").write_bytes(whole[:len(whole) // 2])
        for name in ("text.bag", "cut.bag"):
            printed = self.run_states(name, "out.csv", status=1)
            self.assertIn(name, printed)
            self.assertEqual(printed.count("\n"), 1, printed)
            self.assertFalse((self.folder / "out.csv").exists())

    def test_long_inputs_show_their_progress(self):
        self.write("time [s],y [mm]\n" + "".join(f"{1 + i},0\n" for i in range(5)))
        with mock.patch("wheel_rail_contact.progress.STEP", 3), mock.patch("wheel_rail_contact.states.command_line.PERIOD", 0):
            printed = self.run_states("in.csv", "out.bag") + self.run_states("out.bag", "out.csv")
        for progress in ("50 %  line 3 of 6", "60 %  state 3 of 5", "60 %  message 3 of 5"):
            self.assertIn(progress, printed)

    def test_bag_that_expands_beyond_the_limit_is_refused(self):
        write_bag(self.folder / "in.bag", [State(10**9 + i) for i in range(5000)])
        with mock.patch("wheel_rail_contact.bags.LEAST_LIMIT", 0), mock.patch("wheel_rail_contact.bags.EXPANSION", 1):
            self.assertIn("its chunks expand to 0 MiB", self.run_states("in.bag", "out.csv", status=1))

    def test_hunting_example_follows_klingel_and_all_its_results_are_ok(self):
        subprocess.run([sys.executable, SCRIPTS / "make_hunting_states", self.folder / "hunting.csv"], check=True)
        self.run_states("hunting.csv", "hunting.bag")
        states = read_bag(self.folder / "hunting.bag")
        for before, state, after in zip(states, states[1:], states[2:]):
            # Pure rolling: the yaw is the slope of the path. 0.03 %: central difference, step 0.1 m, wavelength 16.5 m.
            slope = (after.y - before.y) / (after.x - before.x)
            self.assertAlmostEqual(slope, state.yaw, delta=3e-4 * 1.53e-3)
        out = self.replayed(self.folder / "hunting.bag", "--no-grids")
        with rosbag.Bag(str(out)) as bag:
            results = [message for _, message, _ in bag.read_messages()]
        self.assertEqual({result.status for result in results}, {0})
        # The wheel on the side of the lateral displacement carries more load.
        for result in results:
            more_left = result.left_rail.vertical_force - result.right_rail.vertical_force
            self.assertTrue(more_left * result.wheelset.position.y >= 0, result.header.stamp)
