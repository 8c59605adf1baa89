# SPDX-License-Identifier: BSD-3-Clause
"""contact_states: stamps from the times or distances of a table, and rows that are dropped."""

from states_case import StatesCase

TITLES = "time [s],y [mm],force_z [kN]\n"


class Times(StatesCase):
    def times_of(self, times, *options):
        """Stamps [ns] of a table with these times, and what contact_states prints."""
        states, printed = self.convert(TITLES + "".join(f"{time},{i},-100\n" for i, time in enumerate(times)), *options)
        return [state.time_ns for state in states], printed

    def test_times_that_begin_at_zero_or_before_are_moved_by_whole_seconds(self):
        for times, shift in ((("0", "0.005"), 1), (("-0.25", "0"), 1), (("-1", "5"), 2), (("-7.5", "-7.25"), 8)):
            with self.subTest(times=times):
                stamps, printed = self.times_of(times)
                self.assertEqual(stamps, [round(1e9 * (float(time) + shift)) for time in times])
                self.assertIn(f"{shift} s were added to all times", printed)
        stamps, printed = self.times_of(("0.000000001", "1"))
        self.assertEqual(stamps, [1, 10**9])
        self.assertNotIn("added", printed)

    def test_start_is_added_to_the_times(self):
        self.assertEqual(self.times_of(("0", "0.5"), "--start", "2.25")[0], [2250000000, 2750000000])
        self.assertEqual(self.times_of(("3", "4.5"), "--start", "-2.25")[0], [750000000, 2250000000])
        for times, start in ((("0", "0.5"), "0"), (("3", "4"), "-3")):
            self.assertIn("the first time, 0 s with --start, is not above 0",
                          self.error_of(f"{TITLES}{times[0]},1,1\n{times[1]},1,1\n", "--start", start))
        self.assertIn("--start nan: must be a finite number", self.misuse_of("--start", "nan"))

    def test_times_are_exact_to_the_nanosecond(self):
        self.assertEqual(self.times_of(("1700000000.123456789", "1700000000.123456790"))[0],
                         [1700000000123456789, 1700000000123456790])

    def test_last_row_of_equal_times_counts(self):
        states, printed = self.convert(TITLES + "1,1,-1\n2,2,-2\n2,3,-3\n2.0,4,-4\n3,5,-5\n4,6,-6\n4.0000000001,7,-7\n")
        self.assertEqual([state.time_ns // 10**9 for state in states], [1, 2, 3, 4])
        self.assertEqual([state.force_z for state in states], [-1e3, -4e3, -5e3, -7e3])
        self.assertIn("3 rows were dropped, because the next row has the same time (lines 3, 4, 7)\n", printed)
        self.assertTrue(printed.endswith("4 states; 3 of 7 rows were dropped\n"), printed)

    def test_times_that_decrease_are_refused_with_the_line(self):
        printed = self.error_of(TITLES + "1,0,0\n3,0,0\n2,0,0\n")
        self.assertIn(":4: its time is before that of line 3; times must not decrease", printed)
        # Rows that are dropped do not matter.
        self.assertEqual(self.times_of(("1", "NaN", "2"))[0], [10**9, 2 * 10**9])

    def test_rows_with_missing_values_are_dropped_and_counted(self):
        missing = ("", " ", "NaN", "nan", "-NaN", "NaN(ind)", "1.#QNAN", "#N/A", "NA", "null", "-")
        rows = [f"{i},{value},-100\n" for i, value in enumerate(missing, 1)]
        rows += [f"{i},1,-100\n" for i in range(20, 31)]
        states, printed = self.convert(TITLES + "".join(rows))
        self.assertEqual([state.time_ns // 10**9 for state in states], list(range(20, 31)))
        self.assertIn("11 rows were dropped, because a value is missing (lines 2, 3, 4, 5, 6, ...)\n", printed)
        self.assertTrue(printed.endswith("11 states; 11 of 22 rows were dropped\n"), printed)
        printed = self.convert(TITLES + "1,1,1\n2,2\n3,3,3\n")[1]
        self.assertIn("1 row was dropped, because a value is missing (line 3)\n", printed)

    def test_missing_value_in_an_ignored_column_does_not_matter(self):
        states, printed = self.convert("time [s],y [mm],gap [mm]\n1,1,\n2,2,NaN\n")
        self.assertEqual(len(states), 2)
        self.assertNotIn("dropped", printed)

    def test_more_dropped_than_used_rows_are_a_failure(self):
        for rows, total, dropped in (
                ("1,1,1\n2,,1\n3,NaN,1\n", 3, "2 rows were dropped, because a value is missing (lines 3, 4)"),
                ("1,1,1\n1,2,1\n1,3,1\n", 3, "2 rows were dropped, because the next row has the same time (lines 2, 3)"),
                ("1,,1\n", 1, "1 row was dropped"), ("0,1,1\n0,1,1\n0,,1\n", 3, "1 row was dropped, because a value")):
            with self.subTest(rows=rows):
                printed = self.error_of(TITLES + rows)
                self.assertIn(f"more than half of the {total} rows are unusable", printed)
                self.assertIn(dropped, printed)

    def test_time_from_distance_and_speed(self):
        text = "s [m],y [mm]\n0,1\n0.5,2\n1.25,3\n"
        self.assertIn("--speed V computes the time from the distance", self.error_of(text))
        states, printed = self.convert(text, "--speed", "25")
        self.assertEqual([state.time_ns for state in states], [10**9, 1020000000, 1050000000])
        self.assertEqual([state.distance for state in states], [0, 0.5, 1.25])
        self.assertIn("1 s were added to all times", printed)
        states = self.states_of("distance [km],y [mm]\n12.5,1\n12.4,2\n", "--speed", "-50")
        self.assertEqual([(state.time_ns, state.distance) for state in states], [(10**9, 12500), (3 * 10**9, 12400)])

    def test_speed_that_fits_no_table_is_refused(self):
        for text, speed, reason in (("s [m],y [mm]\n1,1\n0,1\n", 5, ":3: its time is before that of line 2"),
                                    ("x [m],y [mm]\n1,1\n", 5, "--speed requires a column 'distance'"),
                                    ("time [s],s [m],y [mm]\n1,1,1\n", 5, "--speed is for tables without time")):
            with self.subTest(text=text):
                self.assertIn(reason, self.error_of(text, "--speed", speed))
        for speed in ("0", "nan"):
            self.assertIn("must be a finite number other than 0", self.misuse_of("--speed", speed))

    def test_time_beyond_the_last_stamp_is_refused(self):
        self.assertEqual(self.times_of(("1", "4294967295.9"))[0][1], 4294967295900000000)
        self.assertIn("is beyond the last stamp", self.error_of(TITLES + "1,1,1\n4294967296,1,1\n"))
