// SPDX-License-Identifier: BSD-3-Clause
// Parameter track/rail_inclination: an angle, or a ratio 1:N.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "parameter_helpers.h"

using namespace wheel_rail_contact;

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

TEST(RailInclination, FormerNameIsRefusedWithTheNewName)
{
  for (const char* yaml : {"track: {cant: 0.025}", "track: {cant: 0.025, rail_inclination: 0.025}"})
  {
    const std::string message = refusal(with(yaml));
    EXPECT_TRUE(contains(message, "/contact_node/track/cant = 0.025") && contains(message, "track/rail_inclination"))
        << yaml << "\n  gave: " << message;
  }
}
