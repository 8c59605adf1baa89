// SPDX-License-Identifier: BSD-3-Clause
// The parameter track/line.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "parameter_helpers.h"

using namespace wheel_rail_contact;

namespace
{
class LineParameter : public testing::Test
{
 protected:
  LineParameter()
  {
    std::ofstream(testing::TempDir() + "line.csv") << "x [m], gauge [mm], alignment [mm]\n0, 1441, 2\n10, 1435, 0\n";
    std::ofstream(testing::TempDir() + "wrong.csv") << "# measured\nx [m], cant [mm]\n0, 1\n1, 2\n";
  }

  static NodeConfig read(const std::string& track) { return wheel_rail_contact::read(with("track: {" + track + "}")); }
  /// Lateral displacement of the left rail at the first station [mm], outward positive.
  static double leftAtBegin(const std::string& track)
  {
    return 1e3 * read(track).model.track.line->at(0).rail.left.lateral;
  }

  static void expectRefused(const std::string& track, const std::string& message)
  {
    const std::string refused = refusal(with("track: {" + track + "}"));
    EXPECT_TRUE(contains(refused, message)) << track << "\n  gave: " << refused;
  }
};

constexpr double rounding = 1e-9;  ///< of differences of gauges [mm]
}  // namespace

TEST_F(LineParameter, EmptyNameIsTheIdealTrack)
{
  EXPECT_EQ(read("").model.track.line, nullptr);
  EXPECT_EQ(read("line: ''").model.track.line, nullptr);
}

TEST_F(LineParameter, LineIsAFileOrAGroupWithItsAxes)
{
  EXPECT_NEAR(leftAtBegin("line: line.csv"), 3 + 2, rounding);
  EXPECT_NEAR(leftAtBegin("line: " + testing::TempDir() + "line.csv"), 3 + 2, rounding);
  EXPECT_NEAR(leftAtBegin("line: {file: line.csv}"), 3 + 2, rounding);
  EXPECT_NEAR(leftAtBegin("line: {file: line.csv, axes: rep103}"), 3 + 2, rounding);
  EXPECT_NEAR(leftAtBegin("line: {file: line.csv, axes: railway}"), 3 - 2, rounding);
}

TEST_F(LineParameter, GaugeOfTheFileIsComparedWithTheNominalGauge)
{
  EXPECT_NEAR(leftAtBegin("gauge: 1.431, line: line.csv"), 5 + 2, rounding);
  expectRefused("gauge: 1.0, line: line.csv", "line.csv:2: gauge = 1.441000 m: must be the whole gauge");
}

TEST_F(LineParameter, MistakesAreRefusedWithTheNameOfTheParameter)
{
  expectRefused("line: missing.csv", "/contact_node/track/line = missing.csv: ");
  expectRefused("line: .", "/contact_node/track/line = .: ");
  expectRefused("line: [line.csv]", "/contact_node/track/line");
  expectRefused("line: wrong.csv", "/contact_node/track/line = wrong.csv: ");
  expectRefused("line: wrong.csv", "wrong.csv:2: column 'cant': unknown quantity");
  expectRefused("line: {file: missing.csv}", "/contact_node/track/line/file = missing.csv: ");
  expectRefused("line: {axes: railway}", "/contact_node/track/line/file is missing");
  expectRefused("line: {file: line.csv, axes: down}", "/contact_node/track/line/axes = down");
  expectRefused("line: {file: line.csv, axes: down}", "rep103, railway");
  expectRefused("line: {file: line.csv, unit: mm}", "/contact_node/track/line/unit");
}
