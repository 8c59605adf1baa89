// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/result_text.h"

#include "result_scene.h"

using namespace wheel_rail_contact;

namespace
{
class ResultText : public ResultScene
{
 protected:
  ResultText()
  {
    output.status = WheelsetContact::OK;
    for (core::PatchResult& patch : result.patches)
    {
      patch.method = "hertz";
      patch.error_estimate = 0.012;
    }
  }

  std::vector<TextLine> lines() const { return resultLines(output, {core::Side::left, core::Side::right}); }
  /// The first line that contains a text; a line "none" without one.
  TextLine lineWith(const std::string& text) const
  {
    const std::vector<TextLine> all = lines();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const TextLine& line) { return line.text.find(text) != std::string::npos; });
    return found == all.end() ? TextLine{"none"} : *found;
  }
};
}  // namespace

TEST_F(ResultText, BeginsWithStatusTimeAndPose)
{
  output.header.stamp = ros::Time(12.34);
  EXPECT_EQ(lines().front().text, "OK at 12.340 s");
  EXPECT_EQ(lines().front().tone, Tone::normal);
  result.y = 4.6e-3;
  result.yaw = -2e-3;
  result.roll = 0.3e-3;
  EXPECT_EQ(lines().at(1).text, "y +4.60 mm, yaw -2.00 mrad, roll +0.30 mrad");
}

TEST_F(ResultText, EachPressureIsFollowedByItsOwnErrorWhichIsNotRoundedToZero)
{
  EXPECT_EQ(lineWith("patch").text, "  patch   982 MPa ± 1.2 %,  192 mm²,  100.0 kN at +0.0°, hertz");
  result.patches[0].error_estimate = 0.00031;
  EXPECT_NE(lineWith("patch").text.find("± 0.031 %"), std::string::npos) << lineWith("patch").text;
  result.patches[0].error_estimate = 1.5;
  EXPECT_NE(lineWith("patch").text.find("± 150.0 %"), std::string::npos) << lineWith("patch").text;
}

TEST_F(ResultText, WheelHasItsForcesAndTheHighestOfItsPressures)
{
  result.wheel.left = {101e3, 8.1e3};
  result.patches.push_back(makePatch(core::Side::left, 0.72));
  result.patches.back().max_pressure = 2408e6;
  result.patches.back().error_estimate = 0.003;
  EXPECT_EQ(lineWith("left").text, "left  wheel: Q 101.0 kN, Y +8.1 kN, highest pressure  2408 MPa ± 0.3 %");
}

TEST_F(ResultText, OnlyADisplacedRailAndAPatchWithStressesHaveLines)
{
  EXPECT_EQ(lineWith("rail").text, "none");
  result.rail.right.deflection = {1e-3, -2e-4, 0};
  EXPECT_EQ(lineWith("rail").text, "  rail moved +1.00 mm outward, -0.20 mm up, +0.0 mrad");
  EXPECT_EQ(lineWith("von Mises").text, "none");
  result.patches[1].wheel_stress.von_mises = {612e6, 0, 0, 2.94e-3};
  result.patches[1].rail_stress.von_mises = {598.6e6, 0, 1e-3, 3.1e-3};
  EXPECT_EQ(lineWith("von Mises").text, "    von Mises stress: wheel 612 MPa 2.9 mm deep, rail 599 MPa 3.1 mm deep");
}

TEST_F(ResultText, OnlyARollingWheelHasLinesForItsFriction)
{
  EXPECT_EQ(lineWith("friction").text, "none");
  result.speed = -20;
  result.wheel.left = {101e3, 8.1e3, 120, -2.9e3};
  result.patches[0].creep.creepage = {1e-4, -2e-3, -0.077};
  result.patches[0].creep.force = {-12, 24.6e3, -3};
  result.patches[0].creep.adhesion_share = 0.83;
  EXPECT_EQ(lineWith("of these").text, "  of these by friction: Q +0.1 kN, Y -2.9 kN");
  EXPECT_EQ(lineWith("spin").text,
            "    83 % of adhesion, creepage +0.10, -2.00 mm/m, spin -0.08 1/m, -0.0, +24.6 kN on the wheel");
}

TEST_F(ResultText, WarningsOfUsableResultsAreVisible)
{
  output.reason = "estimated error 3 % above the tolerance";
  EXPECT_EQ(lineWith("OK").tone, Tone::warning);
  EXPECT_EQ(lineWith("above the tolerance").tone, Tone::warning);
  output.status = WheelsetContact::LIFT_OFF;
  output.reason = "the right wheel carries no load";
  result.patches.pop_back();
  EXPECT_EQ(lineWith("LIFT_OFF").tone, Tone::warning);
  EXPECT_EQ(lineWith("carries no load").tone, Tone::warning);
  EXPECT_EQ(lineWith("right wheel: no contact").tone, Tone::warning);
  EXPECT_EQ(lineWith("left").tone, Tone::normal);
}

TEST_F(ResultText, UnusableResultHasStatusReasonAndPoseOnly)
{
  output.result = nullptr;
  output.status = WheelsetContact::OFF_PROFILE;
  output.reason = "beyond the profile";
  output.state.y = 0.06;
  output.state.z = 0.46;
  ASSERT_EQ(lines().size(), 3U);
  EXPECT_EQ(lines()[0].text, "OFF_PROFILE at 10.000 s");
  EXPECT_EQ(lines()[1].text, "beyond the profile");
  EXPECT_EQ(lines()[0].tone, Tone::error);
  EXPECT_EQ(lines()[1].tone, Tone::error);
  EXPECT_EQ(lines()[2].text.substr(0, 11), "y +60.00 mm");
  output.state = core::WheelsetState();
  EXPECT_EQ(lines().size(), 2U) << "a rejected input has no pose";
}

TEST_F(ResultText, LongReasonIsWrappedBetweenWords)
{
  output.result = nullptr;
  output.reason = "one two three incomprehensibilities four";
  std::vector<std::string> texts;
  for (const TextLine& line : statusLines(output, 13))
  {
    texts.push_back(line.text);
  }
  EXPECT_EQ(texts, (std::vector<std::string>{"OK", "one two three", "incomprehensibilities", "four"}));
}
