// SPDX-License-Identifier: BSD-3-Clause
#include "replay/csv_rows.h"

#include "../usual_headers.h"

using namespace wheel_rail_contact;

namespace
{
std::vector<std::string> cellsOf(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream text(line.substr(0, line.find('\n')) + ",");
  for (std::string cell; std::getline(text, cell, ',');)
  {
    cells.push_back(cell);
  }
  return cells;
}

/// Names of the columns, from the first line of a new table.
std::vector<std::string> columns()
{
  const std::string path = testing::TempDir() + "csv_rows_test.csv";
  std::remove(path.c_str());
  CsvFile(path, false).finish(0);
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::remove(path.c_str());
  return cellsOf(line);
}

/// Expects numbers of a result by the names of their columns.
void expectCells(const WheelsetContact& result, const std::map<std::string, double>& expected)
{
  const std::vector<std::string> names = columns(), row = cellsOf(csvRows(result, 0, ""));
  for (const auto& [name, cell] : expected)
  {
    const auto column = std::find(names.begin(), names.end(), name);
    ASSERT_NE(column, names.end()) << name;
    EXPECT_EQ(std::stod(row.at(static_cast<std::size_t>(column - names.begin()))), cell) << name;
  }
}
}  // namespace

TEST(CsvRows, HeldAndImplausibleResultsAreMarkedBesideTheReason)
{
  WheelsetContact result;
  result.header.stamp.sec = 2;
  result.status_text = "a reason";
  EXPECT_EQ(csvRows(result, 7, "front").substr(0, 42), "7,front,2.000000000,OK,\"a reason\",0,0,0,0,");
  result.implausible_force = true;
  EXPECT_EQ(csvRows(result, 7, "front").substr(0, 42), "7,front,2.000000000,OK,\"a reason\",0,1,0,0,");
  result.held = true;
  EXPECT_EQ(csvRows(result, 7, "front").substr(0, 42), "7,front,2.000000000,OK,\"a reason\",1,1,0,0,");
}

TEST(CsvRows, RowsWithAndWithoutAPatchHaveACellForEachColumn)
{
  WheelsetContact result;
  EXPECT_EQ(cellsOf(csvRows(result, 0, "")).size(), columns().size());
  result.patches.resize(1);
  EXPECT_EQ(cellsOf(csvRows(result, 0, "")).size(), columns().size());
}

TEST(CsvRows, FrictionIsUnderItsColumns)
{
  WheelsetContact result;
  result.speed = 1;
  result.rotation = 2;
  result.left_wheel.friction_lateral_force = 3;
  result.right_rail.vertical_slope = 4;
  PatchCreep& creep = result.patches.emplace_back().creep;
  creep.spin = 5;
  creep.force_y = 6;
  creep.vertical_force = 7;
  creep.error_estimate = 8;
  expectCells(result, {{"speed [m/s]", 1},
                       {"rotation [rad/s]", 2},
                       {"left_wheel_friction_lateral_force [N]", 3},
                       {"right_vertical_slope [-]", 4},
                       {"creep_spin [1/m]", 5},
                       {"creep_force_y [N]", 6},
                       {"creep_vertical_force [N]", 7},
                       {"creep_error_estimate [-]", 8}});
}

TEST(CsvRows, StressOfBothBodiesIsUnderItsColumns)
{
  WheelsetContact result;
  ContactPatch& patch = result.patches.emplace_back();
  double value = 0;
  std::map<std::string, double> expected;
  for (const std::string body : {"wheel_", "rail_"})
  {
    PatchStress& stress = body == "wheel_" ? patch.wheel_stress : patch.rail_stress;
    expected[body + "von_mises [Pa]"] = stress.von_mises.value = ++value;
    expected[body + "von_mises_x [m]"] = stress.von_mises.x = ++value;
    expected[body + "von_mises_y [m]"] = stress.von_mises.y = ++value;
    expected[body + "von_mises_depth [m]"] = stress.von_mises.depth = ++value;
    expected[body + "shear [Pa]"] = stress.shear.value = ++value;
    expected[body + "shear_depth [m]"] = stress.shear.depth = ++value;
    expected[body + "load_factor [-]"] = stress.load_factor = ++value;
    expected[body + "shakedown_limit [-]"] = stress.shakedown_limit = ++value;
  }
  expectCells(result, expected);
}
