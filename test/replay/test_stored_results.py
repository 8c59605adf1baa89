# SPDX-License-Identifier: BSD-3-Clause
"""The shipped bags give the stored results on every machine and with every compiler, within the estimated errors.

The stored tables were computed on Debian 12 with GCC 12. Compilers and processors round differently. The balance of the
wheelset and the choice of the grid may therefore end one step earlier or later. After a change of the solver, this command
writes the tables again:

  CONTACT_REPLAY=build/devel/lib/wheel_rail_contact/contact_replay python3 test/replay/test_stored_results.py write
"""

import csv
import pathlib
import sys

from replay_case import SHIPPED, ReplayCase

STORED = pathlib.Path(__file__).parent / "stored"
CONFIG = SHIPPED.parents[1] / "config"
BAGS = ("manchester_sweep", "paper")
TEXTS = ("result [-]", "status", "side")
NUMBERS = ("z [m]", "contact_angle [rad]", "normal_force [N]", "approach [m]", "area [m^2]", "max_pressure [Pa]",
           "error_estimate [-]")
LIGHT = 1e3  # normal force below which the pressure is not compared [N]: 1 % of the wheel load, as a patch that begins


def config_of(name):
    return CONFIG / ("manchester.yaml" if name == "manchester_sweep" else f"{name}.yaml")


class StoredResults(ReplayCase):
    def table(self, name):
        path = self.folder / f"{name}.csv"
        self.replay(SHIPPED.with_name(f"{name}.bag"), f"{name}.bag", "--config", config_of(name), "--csv", path)
        with open(path, encoding="utf-8") as file:
            return [{column: row[column] for column in TEXTS + NUMBERS} for row in csv.DictReader(file)]

    def test_replay_of_the_shipped_bags_gives_the_stored_results(self):
        for name in BAGS:
            rows = self.table(name)
            with open(STORED / f"{name}.csv", encoding="utf-8") as file:
                stored = list(csv.DictReader(file))
            self.assertEqual([[row[column] for column in TEXTS] for row in rows],
                             [[row[column] for column in TEXTS] for row in stored], name)
            self.assertGreater(len(rows), 60)
            for row, other in zip(rows, stored):
                with self.subTest(bag=name, result=row["result [-]"], side=row["side"]):
                    self.compare(row, other)

    def compare(self, row, other):
        if not row["max_pressure [Pa]"]:  # no result, or no contact
            self.assertEqual(other["max_pressure [Pa]"], "")
            return
        new, old = ({column: float(table[column]) for column in NUMBERS} for table in (row, other))
        estimates = new["error_estimate [-]"] + old["error_estimate [-]"]
        if old["normal_force [N]"] < LIGHT:
            self.assertLess(new["normal_force [N]"], 2 * LIGHT)
            return
        self.assertLess(estimates, 0.1)
        for column in ("max_pressure [Pa]", "area [m^2]", "approach [m]", "normal_force [N]"):
            self.assertLessEqual(abs(new[column] / old[column] - 1), estimates, column)
        # The height is accurate to the same share of the approach, the angle to this share of 1 rad.
        self.assertLessEqual(abs(new["z [m]"] - old["z [m]"]), estimates * old["approach [m]"])
        self.assertLessEqual(abs(new["contact_angle [rad]"] - old["contact_angle [rad]"]), estimates)


def write():
    """Writes the stored tables, with nine digits."""
    case = StoredResults()
    case.setUp()
    STORED.mkdir(exist_ok=True)
    for name in BAGS:
        rows = [{key: value if key in TEXTS or not value else f"{float(value):.9g}" for key, value in row.items()}
                for row in case.table(name)]
        with open(STORED / f"{name}.csv", "w", encoding="utf-8", newline="") as file:
            table = csv.DictWriter(file, TEXTS + NUMBERS, lineterminator="\n")
            table.writeheader()
            table.writerows(rows)
    case.doCleanups()


if __name__ == "__main__" and sys.argv[1:] == ["write"]:
    write()
