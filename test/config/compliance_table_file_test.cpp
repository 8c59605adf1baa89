// SPDX-License-Identifier: BSD-3-Clause
#include "config/compliance_table_file.h"

#include "parameter_helpers.h"

using namespace wheel_rail_contact;

namespace
{
const char* const good_table = R"(
name: test rail
reference_depth: 0.014
lateral_lateral: 6.0e-08
lateral_roll: 3.0e-07
roll_roll: 2.6e-06
vertical_vertical: 5.6e-09
linear_range_lateral_to_vertical: 0.6
neighbours:
  - {distance: 1.8, lateral_lateral: 6.7e-09, lateral_roll: 3.3e-08, roll_roll: 2.9e-07, vertical_vertical: 0}
  - {distance: 2.5, lateral_lateral: 3.0e-09, lateral_roll: 1.5e-08, roll_roll: 1.3e-07, vertical_vertical: 0}
provenance: {source: made up}
)";

/// Reads the table with one passage of its text replaced.
ComplianceTableFile readWith(const std::string& passage, const std::string& replacement)
{
  std::string text = good_table;
  const auto place = text.find(passage);
  if (place == std::string::npos)
  {
    throw std::logic_error("the table of the test does not contain '" + passage + "'");
  }
  text.replace(place, passage.size(), replacement);
  const std::string file = testing::TempDir() + "table.yaml";
  std::ofstream(file) << text;
  return readComplianceTable(file);
}
}  // namespace

TEST(ComplianceTableFile, AllNumbersAreRead)
{
  const ComplianceTableFile file = readWith("made up", "made up");
  EXPECT_EQ(file.name, "test rail");
  const auto values = [](const core::ComplianceTable& table) {
    return std::vector<double>{table.lateral_lateral, table.lateral_roll, table.roll_roll, table.vertical_vertical};
  };
  EXPECT_EQ(values(file.table), (std::vector<double>{6.0e-8, 3.0e-7, 2.6e-6, 5.6e-9}));
  EXPECT_EQ(file.linear_range, 0.6);
  ASSERT_EQ(file.neighbours.size(), 2U);
  EXPECT_EQ(file.neighbours[0].distance, 1.8);
  EXPECT_EQ(file.neighbours[0].influence.lateral_lateral, 6.7e-9);
  EXPECT_EQ(file.neighbours[1].distance, 2.5);
  EXPECT_EQ(values(file.neighbours[1].influence), (std::vector<double>{3.0e-9, 1.5e-8, 1.3e-7, 0}));
  EXPECT_EQ(readWith("0.6", ".inf").linear_range, std::numeric_limits<double>::infinity());
}

TEST(ComplianceTableFile, ShippedTablesAreAccepted)
{
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(packageFile("config/rails")))
  {
    if (entry.path().extension() == ".yaml")
    {
      EXPECT_NO_THROW(readComplianceTable(entry.path().string())) << entry.path();
      ++count;
    }
  }
  EXPECT_GE(count, 2);
}

TEST(ComplianceTableFile, EachInvalidEntryIsRefusedWithFileAndKey)
{
  struct Mistake
  {
    const char *passage, *replacement, *key;
  };
  const std::vector<Mistake> mistakes{
      {"name: test rail", "", "name is missing"},
      {"reference_depth: 0.014", "reference_depth: 0.016", "reference_depth = 0.016"},
      {"reference_depth: 0.014", "", "reference_depth is missing"},
      {"lateral_lateral: 6.0e-08", "lateral_lateral: -6.0e-08", "lateral_lateral = -6.0e-08"},
      {"lateral_lateral: 6.0e-08", "lateral_lateral: soft", "lateral_lateral = soft"},
      {"lateral_roll: 3.0e-07", "lateral_roll: .nan", "lateral_roll = .nan"},
      {"lateral_roll: 3.0e-07", "lateral_roll: 4.0e-07", "lateral_roll = 4.0e-07"},
      {"roll_roll: 2.6e-06", "", "roll_roll is missing"},
      {"vertical_vertical: 5.6e-09", "vertical_vertical: 0", "vertical_vertical = 0"},
      {"linear_range_lateral_to_vertical: 0.6", "linear_range_lateral_to_vertical: 0", "linear_range"},
      {"linear_range_lateral_to_vertical: 0.6", "", "linear_range_lateral_to_vertical is missing"},
      {"distance: 2.5", "distance: 1.5", "neighbours/distance = 1.5"},
      {"distance: 2.5, ", "", "neighbours/distance is missing"},
      {"roll_roll: 2.9e-07", "rol_roll: 2.9e-07", "neighbours/roll_roll is missing"},
      {"{distance: 1.8", "{depth: 1, distance: 1.8", "neighbours/depth is unknown"},
      {"provenance: {source: made up}", "", "provenance is missing"},
      {"provenance", "stiffness: 3\nprovenance", "stiffness is unknown"},
      {"name: test rail", "name: [test rail", "table.yaml"},
  };
  for (const Mistake& mistake : mistakes)
  {
    const std::string message = refusalOf([&] { readWith(mistake.passage, mistake.replacement); });
    EXPECT_TRUE(contains(message, "table.yaml")) << mistake.replacement;
    EXPECT_TRUE(contains(message, mistake.key)) << mistake.replacement;
  }
}
