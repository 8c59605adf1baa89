# SPDX-License-Identifier: BSD-3-Clause
"""contact_states: titles of other programs, units, and the option --column."""
import math

from states_case import StatesCase


class Columns(StatesCase):
    def state_of(self, title, value, name, *options):
        """Field of the state that a column with this title sets."""
        state, = self.states_of(f"{'' if name == 'time_ns' else 'time [s];'}{'' if name == 'y' else 'y [m];'}{title}\n"
                                f"{'' if name == 'time_ns' else '2;'}{'' if name == 'y' else '3;'}{value}\n", *options)
        return getattr(state, name)

    def test_spellings_of_a_title(self):
        for title in ("y [mm]", "Y [mm]", " y[mm] ", "y (mm)", "y(mm)", "y / mm", "y/mm", "y_mm", "Y_MM", "y in mm"):
            with self.subTest(title=title):
                self.assertEqual(self.state_of(title, 4, "y"), 0.004)

    def test_spellings_of_names(self):
        for titles, name, expected in (
                (("time [s]", "Time [s]", "TIME [s]", "t [s]", "T (s)", "time_s", "Time [sec.]"), "time_ns", 4),
                (("s [m]", "S [m]", "Distance / m", "distance_m"), "distance", 4),
                (("yaw [rad]", "Yaw [rad]", "psi [rad]", "ψ [rad]", "Ψ [rad]"), "yaw", 0.1),
                (("roll [rad]", "phi [rad]", "φ [rad]"), "roll", 0.1),
                (("Y_left [N]", "Y_L [N]", "Yl [N]", "Y left [N]", "y-left / N", "Y.left_N"), "left_lateral_force", 4),
                (("Y_right [N]", "Y_r [N]", "YR [N]"), "right_lateral_force", 4),
                (("Rail lateral left [m]", "rail_lateral_l [m]"), "left_rail_lateral", 4)):
            for title in titles:
                with self.subTest(title=title):
                    value = self.state_of(title, expected, name) / (1e9 if name == "time_ns" else 1)
                    self.assertAlmostEqual(value, expected, delta=1e-15)

    def test_spellings_of_wheel_loads(self):
        for left, right in (("Q_left [N]", "Q_right [N]"), ("Q_L [N]", "Q_R [N]"), ("Q_l/N", "Q_r/N"), ("Ql (N)", "Qr (N)"),
                            ("Q left [N]", "Q right [N]"), ("QLEFT_N", "QRIGHT_N")):
            with self.subTest(left=left):
                state, = self.states_of(f"time [s],y [m],{right},{left}\n1,0,300,100\n")
                self.assertEqual((state.force_z, state.torque_x), (-400, 150))

    def test_units(self):
        # 1 in = 25.4 mm, 1 ft = 12 in, 1 lbf = 4.4482216152605 N (NIST SP 811), 1 kip = 1000 lbf.
        for unit, si in (("m", 1), ("cm", 0.01), ("mm", 1e-3), ("um", 1e-6), ("km", 1e3), ("in", 0.0254), ("inch", 0.0254),
                         ("ft", 0.3048)):
            with self.subTest(unit=unit):
                self.assertAlmostEqual(self.state_of(f"y [{unit}]", 1.5, "y"), 1.5 * si, delta=1e-15 * si)
        for unit, si in (("rad", 1), ("mrad", 1e-3), ("deg", math.pi / 180), ("°", math.pi / 180), ("Degrees", math.pi / 180)):
            with self.subTest(unit=unit):
                self.assertAlmostEqual(self.state_of(f"yaw [{unit}]", 1.5, "yaw"), 1.5 * si, delta=1e-15)
        for unit, si in (("N", 1), ("kN", 1e3), ("KN", 1e3), ("lbf", 4.4482216152605), ("kip", 4448.2216152605)):
            with self.subTest(unit=unit):
                self.assertAlmostEqual(self.state_of(f"Y_left [{unit}]", 1.5, "left_lateral_force"), 1.5 * si, delta=1e-12 * si)
        for unit, si in (("N m", 1), ("Nm", 1), ("N.m", 1), ("N*m", 1), ("N·m", 1), ("kN m", 1e3), ("kNm", 1e3), ("kN.m", 1e3),
                         ("lbf.ft", 1.3558179483314004), ("ft-lbf", 1.3558179483314004)):
            with self.subTest(unit=unit):
                state, = self.states_of(f"time [s],y [m],force_z [N],torque_x [{unit}]\n1,0,-9,1.5\n")
                self.assertAlmostEqual(state.torque_x, 1.5 * si, delta=1e-12 * si)
        for unit, nanoseconds in (("s", 1500000000), ("ms", 1500000), ("us", 1500), ("min", 90 * 10**9)):
            with self.subTest(unit=unit):
                self.assertEqual(self.state_of(f"time [{unit}]", 1.5, "time_ns"), nanoseconds)

    def test_loads_in_pounds(self):
        state, = self.states_of("time [s],y [in],Q_left [lbf],Q_right [lbf]\n0.5,0.05,13750,13750\n")
        self.assertAlmostEqual(state.y, 1.27e-3, delta=1e-15)
        self.assertAlmostEqual(-state.force_z, 122326.094, delta=1e-3)  # 27500 lbf
        self.assertEqual(state.torque_x, 0)

    def test_unit_decides_between_position_and_force(self):
        (state,), printed = self.convert("time [s],Y [kN],y [mm],T [°C],S [mm2],y_left [mm],X [kN]\n1,40,2,15,3,4,5\n")
        self.assertEqual((state.y, state.time_ns, state.x), (0.002, 10**9, 0))
        self.assertEqual((state.distance, state.left_lateral_force), (None, None))
        self.assertIn("ignored columns: Y [kN], T [°C], S [mm2], y_left [mm], X [kN]; no load", printed)
        self.assertIn("column 'y' is missing; the columns are time [s], Y [kN].", self.error_of("time [s],Y [kN]\n1,40\n"))

    def test_other_columns_are_ignored_and_listed_in_one_line(self):
        _, printed = self.convert("time [s],Car.x0 [m/s2],y [mm],comment,Q_left [kN],Q_right [kN],,wset1.z [m]\n"
                                  "1,0,2,any text,60,60,7,x\n")
        self.assertEqual(printed.count("ignored"), 1)
        self.assertIn("in.csv: ignored columns: Car.x0 [m/s2], comment, column 7, wset1.z [m]\n", printed)
        self.assertNotIn("no load", printed)

    def test_missing_load_is_reported_with_the_ignored_columns(self):
        for titles, remark in (("Q [N]", "ignored columns: Q [N]; no load was found (force_z, or Q_left and Q_right)\n"),
                               ("yawn [rad]", "ignored columns: yawn [rad]; no load was found"),
                               ("z [m]", "in.csv: no load was found")):
            with self.subTest(titles=titles):
                states, printed = self.convert(f"time [s],y [mm],{titles}\n1,2,3\n")
                self.assertIn(remark, printed)
                self.assertIsNone(states[0].force_z)

    def test_titles_without_units_are_refused_with_the_options_to_give_them(self):
        text = "Time,y,Q_left,Q_right\n0.005,1.25,60.5,59.5\n"
        printed = self.error_of(text)
        self.assertIn("columns without a unit: Time, y, Q_left, Q_right.", printed)
        options = ("--column time='Time [s]' --column y='y [mm]' --column Q_left='Q_left [kN]' "
                   "--column Q_right='Q_right [kN]'")
        self.assertIn(options, printed)
        state, = self.states_of(text, *options.replace("'", "").replace(" [", "[").split())
        self.assertEqual((state.time_ns, state.y, state.force_z), (5000000, 1.25e-3, -120e3))

    def test_option_names_a_column_by_its_title(self):
        text = "t [s];Wset.Y [mm];Wset.Yaw;F1 [kN];F2 [kN]\n1;2;3;60;70\n"
        state, = self.states_of(text, "--column", "y=Wset.Y [mm]", "--column", "yaw=Wset.Yaw [mrad]",
                                "--column", "Q_left=F1", "--column", "Q_right=f2 (kN)")
        self.assertEqual((state.y, state.force_z, state.torque_x), (0.002, -130e3, 7500))
        self.assertAlmostEqual(state.yaw, 0.003, delta=1e-15)
        # A column in place of the one that has the name, and one column for two quantities.
        text = "time [s],y [mm],x [m],lateral (left),lateral (right)\n1,2,3,4,5\n"
        state, = self.states_of(text, "--column", "y=lateral (right) [mm]", "--column", "distance=x [m]", "--column", "x=x")
        self.assertEqual((state.y, state.x, state.distance), (0.005, 3, 3))

    def test_option_without_a_title_ignores_a_column(self):
        text = "time [s],y [mm],yaw [m],force_z [kN],Q_left [kN],Q_right [kN]\n1,2,3,-4,5,6\n"
        (state,), printed = self.convert(text, "--column", "yaw=", "--column", "Q_left=", "--column", "Q_right=")
        self.assertEqual((state.yaw, state.force_z), (0, -4e3))
        self.assertIn("ignored columns: yaw [m], Q_left [kN], Q_right [kN]\n", printed)

    def test_options_that_fit_no_column_are_refused(self):
        text = "time [s],a [mm],a [mm],b [mm],c\n1,2,2,3,4\n"
        for option, reason in (("y=d [mm]", "no columns have this title: time [s], a [mm], a [mm], b [mm], c"),
                               ("y=a [mm]", "2 columns have this title: a [mm], a [mm]"),
                               ("y=b [m]", "the unit in the file is mm"),
                               ("y=c", "columns without a unit: c."), ("y=c [kN]", "kN is not a unit of y")):
            with self.subTest(option=option):
                self.assertIn(reason, self.error_of(text, "--column", option))

    def test_invalid_options_are_refused(self):
        for options, reason in ((("--column", "y"), "must be NAME='TITLE [UNIT]'"), (("--column", "Q=F [N]"), "must be NAME="),
                                (("--column", "y=a", "--column", "y=b"), "--column y is given twice")):
            with self.subTest(options=options):
                self.assertIn(reason, self.misuse_of(*options))

    def test_contradictory_columns_are_refused(self):
        for titles, reason in (("time [s]", "column 'y' is missing; the columns are time [s]. --column y='TITLE [mm]'"),
                ("y [m]", "column 'time' is missing"),
                ("time [s],y [kg]", "column 'y [kg]': kg is not a unit of y; valid units are m"),
                ("time [s],y [m],Yaw [mm]", "column 'Yaw [mm]': mm is not a unit of yaw"),
                ("time [s],y [m],y [mm]", "column 'y' is given twice, by 'y [m]' and 'y [mm]'"),
                ("time [s],t [s],y [m]", "column 'time' is given twice, by 'time [s]' and 't [s]'"),
                ("time [s],y [m],Q_left [N]", "must be given together"),
                ("time [s],y [m],Q_left [N],Q_right [N],force_z [N]", "the load must be given either"),
                ("time [s],y [m],torque_x [N m]", "torque_x requires force_z")):
            with self.subTest(titles=titles):
                self.assertIn(f"in.csv: {reason}" if reason.startswith("column") else reason,
                              self.error_of(f"{titles}\n{','.join('1' for _ in titles.split(','))}\n"))
