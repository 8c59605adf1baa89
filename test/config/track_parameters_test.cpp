// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_helpers.h"

using namespace wheel_rail_contact;

TEST(LengthParameters, MillimetresAreRefusedWithTheRangeInMetres)
{
  expectRefused({
      {"track: {gauge: 1435}", "track/gauge = 1435", "must be from 0.2 to 3, in metres"},
      {"track: {gauge_depth: 14}", "track/gauge_depth = 14", "from 1e-05 to 0.1, in metres"},
      {"wheelset: {rolling_radius: 460}", "wheelset/rolling_radius = 460", "from 0.05 to 2, in metres"},
      {"wheel: {left: {rolling_radius: 459}}", "wheel/left/rolling_radius = 459", "in metres"},
      {"wheelset: {flange_back_distance: 1360}", "wheelset/flange_back_distance = 1360", "in metres"},
      {"wheelset: {tape_circle: 70}", "wheelset/tape_circle = 70", "from 0.005 to 0.5, in metres"},
  });
}

TEST(LengthParameters, DimensionsOfNarrowAndBroadGaugeAreAccepted)
{
  for (const char* yaml : {"{track: {gauge: 0.6}, wheelset: {flange_back_distance: 0.53, rolling_radius: 0.15}}",
                           "{track: {gauge: 1.676}, wheelset: {flange_back_distance: 1.6, rolling_radius: 0.7}}"})
  {
    EXPECT_EQ(refusal(with(yaml)), "accepted");
  }
}

// Parameter track/rail_inclination: an angle, or a ratio 1:N.
// "1:40" is the text that YAML 1.2 parsers and quotes give. 100 = 60 + 40 is the sexagesimal number that rosparam makes
// of an unquoted 1:40. Both give the same bits as atan(1/40).
TEST(RailInclination, IsAnAngleOrARatio)
{
  const auto inclination = [](const std::string& value)
  { return read(with("track: {rail_inclination: " + value + "}")).model.track.rail_inclination.left; };
  EXPECT_EQ(inclination("0.025"), 0.025);
  EXPECT_EQ(inclination("0"), 0);
  EXPECT_EQ(inclination("-0.025"), -0.025);
  EXPECT_EQ(inclination("'1:40'"), std::atan(1.0 / 40));
  EXPECT_EQ(inclination("1:40"), std::atan(1.0 / 40));
  EXPECT_EQ(inclination("1:20"), std::atan(1.0 / 20));
  EXPECT_EQ(inclination("1:40.5"), std::atan(1 / 40.5));
  EXPECT_EQ(inclination("1:100"), std::atan(1.0 / 100));
  EXPECT_EQ(inclination("100"), std::atan(1.0 / 40));
  EXPECT_EQ(inclination("80"), std::atan(1.0 / 20));
  EXPECT_EQ(inclination("100.5"), std::atan(1 / 40.5));
}

TEST(RailInclination, InvalidValueIsRefused)
{
  for (const char* text : {"1:0", "1:-3", "1:x", "'1:'", "1:.nan", "1:.inf", "1:40:0", "-1:40", "2:40", "1/40",
                           "'1:40 '", "' 1:40'", ".nan", ".inf", "[1, 40]"})
  {
    const std::string message = refusal(with(std::string("track: {rail_inclination: ") + text + "}"));
    EXPECT_TRUE(contains(message, "/contact_node/track/rail_inclination = ") &&
                contains(message, " must be a finite number [rad] or a ratio 1:N with a finite N > 0"))
        << text << "\n  gave: " << message;
  }
  // The core permits up to 0.2 rad, which is 1:4.93. 61 is the ratio 1:1. 60 and 120 are angles in radians.
  for (const char* text : {"1.4", "-0.3", "1:1", "61", "1:4", "64", "60", "120", "-100"})
  {
    const std::string message = refusal(with(std::string("track: {rail_inclination: ") + text + "}"));
    EXPECT_TRUE(contains(message, "/contact_node/track/rail_inclination = ") && contains(message, "0.2 rad"))
        << text << "\n  gave: " << message;
  }
}

// The parameter track/line.
namespace
{
class LineParameter : public testing::Test
{
 protected:
  LineParameter()
  {
    std::ofstream(testing::TempDir() + "line.csv") << "x [m], gauge [mm], alignment [mm]\n0, 1441, 2\n10, 1435, 0\n";
    std::ofstream(testing::TempDir() + "wrong.csv") << "# measured\nx [m], cant_left [mm]\n0, 1\n1, 2\n";
  }

  static NodeConfig read(const std::string& track) { return wheel_rail_contact::read(with("track: {" + track + "}")); }
  /// Lateral displacement of the left rail at the first station [mm], outward positive.
  static double leftAtBegin(const std::string& track)
  {
    return 1e3 * read(track).model.track.line->at(0).rail.left.lateral;
  }
};

constexpr double rounding = 1e-9;  ///< of differences of gauges [mm]
}  // namespace

TEST_F(LineParameter, LineIsAFileOrAGroupWithItsAxesOrNone)
{
  EXPECT_NEAR(leftAtBegin("line: line.csv"), 3 + 2, rounding);
  EXPECT_NEAR(leftAtBegin("line: " + testing::TempDir() + "line.csv"), 3 + 2, rounding);
  EXPECT_NEAR(leftAtBegin("line: {file: line.csv}"), 3 + 2, rounding);
  EXPECT_NEAR(leftAtBegin("line: {file: line.csv, axes: rep103}"), 3 + 2, rounding);
  EXPECT_NEAR(leftAtBegin("line: {file: line.csv, axes: railway}"), 3 - 2, rounding);
  EXPECT_EQ(read("line: line.csv, publish_track_frame: map").fixed_frame, "map");
  EXPECT_EQ(read("").model.track.line, nullptr);
  EXPECT_EQ(read("line: ''").model.track.line, nullptr);
}

TEST_F(LineParameter, GaugeOfTheFileIsComparedWithTheNominalGauge)
{
  EXPECT_NEAR(leftAtBegin("gauge: 1.431, line: line.csv"), 5 + 2, rounding);
  expectRefused(
      {{"track: {gauge: 1.0, line: line.csv}", "track/line", "line.csv:2: gauge = 1.441000 m: must be the whole"}});
}

TEST_F(LineParameter, MistakesAreRefusedWithTheNameOfTheParameter)
{
  expectValuesRefused("track/line: missing.csv | . | [line.csv] | wrong.csv\n");
  expectRefused({
      {"track: {line: wrong.csv}", "track/line = wrong.csv: ", "wrong.csv:2: column 'cant_left': unknown quantity"},
      {"track: {line: {file: missing.csv}}", "track/line/file = missing.csv: ", ""},
      {"track: {line: {axes: railway}}", "track/line/file is missing", ""},
      {"track: {line: {file: line.csv, axes: down}}", "track/line/axes = down", "rep103, railway"},
      {"track: {line: {file: line.csv, longest_gap: 0}}", "track/line/longest_gap = 0", ""},
      {"track: {line: {file: line.csv, repeat: true}}", "track/line",
       "line.csv: repeat: a step of -0.005 in rail_lateral_left (SI"},
      {"track: {publish_track_frame: map}", "track/publish_track_frame = ", ""},
      {"track: {line: line.csv, publish_track_frame: track}", "track/publish_track_frame = ", ""},
      {"track: {line: {file: line.csv, repeat: true}, publish_track_frame: map}", "track/publish_track_frame = ", ""},
      {"wheelset: {frame: /axle}", "wheelset/frame = ", ""},
      {"wheelset: {frame: track}", "wheelset/frame = ", ""},
      {"track: {line: {file: line.csv, unit: mm}}", "track/line/unit", ""},
  });
}
