# SPDX-License-Identifier: BSD-3-Clause
"""contact_states: text files as simulation tools export them, with their encodings, separators, decimal signs and comments."""

from states_case import StatesCase

TITLES = ("time [s]", "y [mm]", "Q_left [kN]", "Q_right [kN]")
ROWS = (("0.005", "1.25", "60.5", "59.5"), ("0.010", "-1.30", "61.5", "58.5"))


def table(separator, decimal=".", titles=TITLES, rows=ROWS, end="\n"):
    """Text of a table with one line for the titles and one for each row."""
    lines = [separator.join(titles), *(separator.join(row).replace(".", decimal) for row in rows)]
    return "".join(line + end for line in lines)


class Tables(StatesCase):
    def assert_is_read(self, text, *options):
        """The table has the values of ROWS."""
        states, printed = self.convert(text, *options)
        self.assertEqual([state.time_ns for state in states], [5000000, 10000000])
        for state, row in zip(states, ROWS):
            y, left, right = (1e3 * float(cell) for cell in row[1:])
            self.assertAlmostEqual(state.y, 1e-6 * y, delta=1e-15)
            self.assertAlmostEqual(state.force_z, -(left + right), delta=1e-9)
            self.assertAlmostEqual(state.torque_x, 0.75 * (right - left), delta=1e-9)
        self.assertTrue(printed.endswith("2 states\n"), printed)
        self.assertNotIn("ignored", printed)

    def test_separators_and_decimal_signs(self):
        for separator in (",", ";", "\t", ", ", "; ", " ", "   ", " \t "):
            with self.subTest(separator=separator):
                self.assert_is_read(table(separator))
        for separator in (";", "\t", " "):
            with self.subTest(separator=separator, decimal=","):
                self.assert_is_read(table(separator, ","))

    def test_comma_in_titles_and_numbers_is_no_separator_beside_semicolons(self):
        state, = self.states_of("time [s];y [mm];gap, left [-]\n1;2;0,5\n")
        self.assertEqual((state.time_ns, state.y), (10**9, 0.002))

    def test_encodings(self):
        text = table(";", ",")
        for encoding in ("utf-8", "utf-8-sig", "utf-16", "latin-1"):
            with self.subTest(encoding=encoding):
                self.assert_is_read(text.encode(encoding))
        self.assert_is_read(b"\xfe\xff" + text.encode("utf-16-be"))

    def test_bytes_that_are_no_utf8_are_latin1(self):
        for mark in (b"", b"\xef\xbb\xbf"):
            for byte in (b"\xff", b"\xed\xa0\x80", b"\xe0\x80\x80", b"\xf4\x90\x80\x80", b"\xc3"):
                with self.subTest(mark=mark, byte=byte):
                    (state,), _ = self.convert(mark + b"time [s];y [mm];" + byte + b"\n1;3;7\n")
                    self.assertEqual(state.y, 0.003)

    def test_signs_of_degree_and_micrometre_in_each_encoding(self):
        for micro, encodings in (("\u00b5", ("utf-8", "utf-16", "latin-1")), ("\u03bc", ("utf-8", "utf-16"))):
            text = f"time [s];yaw [°];y [{micro}m];Größe [%]\n1;0.5;250;3\n"
            for encoding in encodings:
                with self.subTest(micro=micro, encoding=encoding):
                    (state,), printed = self.convert(text.encode(encoding))
                    self.assertAlmostEqual(state.yaw, 0.5 * 3.141592653589793 / 180, delta=1e-15)
                    self.assertAlmostEqual(state.y, 250e-6, delta=1e-15)
                    self.assertIn("ignored columns: Größe [%];", printed)

    def test_line_ends_and_empty_lines(self):
        for end in ("\r\n", "\r", "\n\n", "\r\n \r\n"):
            with self.subTest(end=end):
                self.assert_is_read(table(",", end=end))
        self.assert_is_read(table(",").rstrip("\n"))

    def test_comments(self):
        for sign in ("#", "%", "!", "//", "  # "):
            with self.subTest(sign=sign):
                first, second, third = table(",").splitlines()
                lines = (f"{sign} 1,2", first, f"{sign}remark; y", second, sign, third, f"{sign}0,0,0,0")
                self.assert_is_read("\n".join(lines))

    def test_titles_in_a_comment_above_the_numbers(self):
        self.assert_is_read("# 12 March, run 3\n# " + table(","))
        self.assert_is_read("% run 3\n% " + table(" "))
        titles, rows = table(";").split("\n", 1)
        self.assert_is_read(f"# {titles}\n# on 12 March run\n{rows}")  # as many words as columns
        units = "% time y Q_left Q_right\n% s mm kN kN\n"
        self.assert_is_read(units + table(" ").split("\n", 1)[1])

    def test_units_in_a_row_of_their_own(self):
        names = ("time", "y", "Q_left", "Q_right")
        for units in (("s", "mm", "kN", "kN"), ("[s]", "[mm]", "[kN]", "[kN]"), ("(s)", "(mm)", "(kN)", "(kN)")):
            for separator in (",", ";", "\t", " "):
                with self.subTest(units=units, separator=separator):
                    self.assert_is_read(table(separator, titles=names, rows=(units, *ROWS)))
        states, printed = self.convert("time,y,x_in,n,z\ns,mm,m/s2,-,m\n1,2,3,4,5\n")
        self.assertEqual((states[0].y, states[0].z, states[0].x), (0.002, 5, 0))
        self.assertIn("ignored columns: x_in [m/s2], n;", printed)

    def test_fortran_exponents_and_plain_numbers(self):
        rows = (("5.0D-03", "+.125D+01", "605.E-1", "0.595d2"), ("1.e-2", "-1.3", "61.5", "585e-1"))
        for separator in (",", ";", " "):
            self.assert_is_read(table(separator, rows=rows))
        self.assert_is_read(table(";", ",", rows=rows))
        self.assert_is_read(table(",").replace("-1.30", "\u22121.30"))

    def test_quoted_cells(self):
        def quoted(cells):
            return [f'"{cell}"' for cell in cells]
        for separator, decimal in ((",", "."), (",", ","), (";", ","), ("\t", ",")):
            with self.subTest(separator=separator, decimal=decimal):
                self.assert_is_read(table(separator, decimal, quoted(TITLES), map(quoted, ROWS)))
        self.assert_is_read(table(" ", titles=quoted(TITLES)))

    def test_trailing_separators_and_empty_columns(self):
        for separator in (",", ";", "\t"):
            empty = [(*row, "") for row in ROWS]
            self.assert_is_read(table(separator, titles=(*TITLES, ""), rows=empty))
            self.assert_is_read(table(separator, rows=empty))
            self.assert_is_read(table(separator, titles=(*TITLES, "", ""), rows=[*empty, [""] * 6, [""] * 3]))

    def test_first_line_for_excel_names_the_separator(self):
        self.assert_is_read("sep=;\r\n" + table(";", ",", end="\r\n"))

    def test_lines_above_the_titles_are_reported(self):
        states, printed = self.convert("Results of run A\n" + table(";"))
        self.assertEqual(len(states), 2)
        self.assertIn("line 1, above the titles, is ignored: Results of run A\n", printed)

    def test_comma_that_may_separate_thousands_is_refused(self):
        rows = (("1,005", "1,250", "60,500", "59,500"), ("1,010", "-1,300", "61,500", "58,500"))
        text = table(";", rows=rows)
        self.assertIn("'1,005' has a decimal comma or a separator of thousands; --decimal-comma selects", self.error_of(text))
        states = self.states_of(text, "--decimal-comma")
        self.assertEqual([state.time_ns for state in states], [1005000000, 1010000000])
        self.assertAlmostEqual(states[1].y, -1.3e-3, delta=1e-15)
        # A comma before other than three digits, or after a zero, is a decimal sign.
        for sure in ("0,005", "1,0050"):
            self.states_of(text.replace("1,005", sure))

    def test_tables_with_unclear_numbers_are_refused(self):
        for text, reason in (
                (table(",", ","), ":2: number of columns is 8, must be 4; with decimal commas, columns must be separated by"),
                (table(";").replace("1.25", "1,25"), "has a decimal point and '1,25' a comma"),
                (table(";").replace("60.5", "1,060.5"), ":2: column 'Q_left [kN]': '1,060.5' is not a finite number"),
                (table(";").replace("60.5", "1.060,5"), ":2: column 'Q_left [kN]': '1.060,5' is not a finite number"),
                (table(";").replace("61.5", "x"), ":3: column 'Q_left [kN]': 'x' is not a finite number"),
                (table(";").replace("61.5", "Inf"), ":3: column 'Q_left [kN]': 'Inf' is not a finite number"),
                (table(";").replace("61.5", "1_0"), ":3: column 'Q_left [kN]': '1_0' is not a finite number"),
                (table(";").replace("61.5", "1e999"), ":3: column 'Q_left [kN]': '1e999' is not a finite number"),
                (table(",").replace("61.5", "61.5,1"), ":3: number of columns is 5, must be 4"),
                (table(" ").replace("61.5", ""), ":3: number of columns is 3, must be 4"),
                (table(",") + "end\n", ":4: column 'time [s]': 'end' is not a finite number"),
                (table(",") + '"0.015,1,2,3\n', ":4: a quotation mark is not closed at the end of a cell"),
                ('time [s];y [mm];note;place\n0;1;"a;1;"b;5\n', ":2: a quotation mark is not closed at the end of a cell"),
                ('time [s],y [mm]\n"0.015,1\n', ":2: a quotation mark is not closed at the end of a cell")):
            with self.subTest(text=text):
                self.assertIn(reason, self.error_of(text))

    def test_files_that_are_not_tables_are_refused(self):
        for text, reason in (("", "is empty"), ("# remark\n", "is empty"), ("sep=;\n", "column 'time' is missing"),
                (table(",").encode("utf-16-le"), "contains binary data"), (b"PK\3\4\0\0", "contains binary data"),
                (b"\xff\xfe1", "is empty"), (table(",").split("\n", 1)[1], "has no titles"),
                (table(",", rows=()), "has no row with numbers")):
            with self.subTest(text=text):
                self.assertIn(f"in.csv: {reason}", self.error_of(text))

    def test_ending_of_a_table_is_free(self):
        self.write(table("\t"))
        for ending in ("txt", "dat", "CSV"):
            (self.folder / "in.csv").rename(self.folder / f"in.{ending}")
            self.run_states(f"in.{ending}", f"{ending}.bag")
            (self.folder / f"in.{ending}").rename(self.folder / "in.csv")
