// SPDX-License-Identifier: BSD-3-Clause
// Slices files: rails whose profile changes along the line.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "profile_helpers.h"
#include "section_scenes.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
namespace
{
using section_scenes::profileOf;
using namespace test;

/// Rounding of 12 digits, and of the unit [m].
constexpr double rounding = 1e-12;

/// Text of a slice: y to the field side, z down, in units of `unit` [m].
std::string twoColumns(const Profile& profile, double unit)
{
  return lines(changed(pointsOf(profile), [unit](const Point& p) { return Point{p.y / unit, -p.z / unit}; }), " ");
}

ProfileReading mirrored()
{
  ProfileReading reading;
  reading.mirror = true;
  return reading;
}

class SlicesTest : public testing::Test
{
 protected:
  SlicesTest()
  {
    folder_.write("a.txt", twoColumns(a_, mm));
    folder_.write("b.txt", twoColumns(b_, mm));
    folder_.write("same.txt", twoColumns(b_, mm));
  }

  RailSeries read(const std::string& text, const ProfileReading& reading = {}) const
  {
    return readRailSlices(folder_.write("rail.slcs", text), reading);
  }

  /// Expects a file to be refused at a line, 0 for the file as a whole.
  void expectRefused(const std::string& text, std::size_t line, const std::string& reason) const
  {
    try
    {
      read(text);
      FAIL() << "accepted: " << text;
    }
    catch (const FileError& error)
    {
      EXPECT_EQ(error.line(), line) << error.what();
      EXPECT_NE(error.reason().find(reason), std::string::npos) << error.what();
    }
  }

  const Profile a_ = profileOf({}), b_ = profileOf({0.003, 0.001, 0.033});
  const std::string head_ = "0 1000\n2\n0 0 0\n1\n";  ///< four lines: two slices, places in metres
  Folder folder_;
};
}  // namespace

TEST_F(SlicesTest, PlacesAndProfilesAreReadBack)
{
  const RailSeries series = read(
      "% slices of a rail\n\n  0.0  1000.0   U_OFFSET, S_SCALE\n  2   % NSLC\n0 0 0\n 1\n\n"
      "-1.5 'a.txt' % it's the first\n0.25 'b.txt'\n");
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].x, -1.5);
  EXPECT_EQ(series[1].x, 0.25);
  EXPECT_LT(deviation(*series[0].profile, pointsOf(a_)), rounding);
  EXPECT_LT(deviation(*series[1].profile, pointsOf(b_)), rounding);
  EXPECT_TRUE(series[0].places.empty());
}

TEST_F(SlicesTest, ScaleIsThatOfThePlacesInMillimetres)
{
  const RailSeries series = read("0 1\n2\n0 0 0\n1\n-1500 'a.txt'\n250 'b.txt'\n");
  EXPECT_DOUBLE_EQ(series[0].x, -1.5);
  EXPECT_DOUBLE_EQ(series[1].x, 0.25);
}

// A curve less than 1 wide is in metres, any other in millimetres.
TEST_F(SlicesTest, SlicesAreInMetresOrMillimetres)
{
  folder_.write("metres.txt", "% y z\n" + twoColumns(a_, 1.0));
  folder_.write("other.csv", "y_mm,z_mm\n" + lines(changed(pointsOf(a_),
                                                           [](const Point& p) {
                                                             return Point{p.y / mm, p.z / mm};
                                                           }),
                                                   ","));
  const RailSeries series = read("0 1000\n2\n0 0 0\n1\n0 'metres.txt'\n1 'other.csv'\n");
  EXPECT_LT(deviation(*series[0].profile, pointsOf(a_)), rounding);
  EXPECT_LT(deviation(*series[1].profile, pointsOf(a_)), rounding) << "a format of readProfile() has z up";
}

TEST_F(SlicesTest, WhatWasUnderstoodOfEachFileIsNoted)
{
  std::vector<std::string> notes;
  readRailSlices(folder_.write("rail.slcs", head_ + "0 'a.txt'\n1 'b.txt'\n"), {}, notes);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0].substr(0, 14), "a.txt: table, ");
  EXPECT_NE(notes[1].find("unit mm, y outward, z down"), std::string::npos) << notes[1];
}

TEST_F(SlicesTest, EqualSlicesShareOneProfile)
{
  const RailSeries series = read("0 1000\n4\n0 0 0\n1\n0 'b.txt'\n1 'same.txt'\n2 'a.txt'\n3 'b.txt'\n");
  EXPECT_EQ(series[0].profile, series[1].profile) << "another file with the same points";
  EXPECT_NE(series[1].profile, series[2].profile);
  EXPECT_EQ(series[0].profile, series[3].profile) << "the same file";
}

TEST_F(SlicesTest, MirrorChangesTheSignOfY)
{
  const RailSeries series = read(head_ + "0 'a.txt'\n1 'b.txt'\n", mirrored());
  EXPECT_NEAR(series[1].profile->at(0).y, -b_.at(b_.length()).y, rounding);
  EXPECT_LT(series[1].profile->at(0).y, series[1].profile->at(series[1].profile->length()).y);
}

TEST_F(SlicesTest, FeaturesAreLengthsAlongTheCurve)
{
  const std::string slices = "0 1000\n2\n2 0 0\n1\n0 'a.txt'\n1 'b.txt'\n", features = "0 16 60.5\n1 -1 70\n";
  const RailSeries series = read(slices + features);
  ASSERT_EQ(series[0].places.size(), 2U);
  EXPECT_DOUBLE_EQ(series[0].places[0], 0.016);
  EXPECT_DOUBLE_EQ(series[0].places[1], 0.0605);
  EXPECT_TRUE(std::isnan(series[1].places[0])) << "negative: the slice has no such feature";
  EXPECT_DOUBLE_EQ(series[1].places[1], 0.070);

  const RailSeries other = read(slices + features, mirrored());
  const double length = other[0].profile->length();
  EXPECT_DOUBLE_EQ(other[0].places[0], length - 0.0605) << "the curve now begins at the other end";
  EXPECT_DOUBLE_EQ(other[0].places[1], length - 0.016);
  EXPECT_TRUE(std::isnan(other[1].places[1]));
}

TEST_F(SlicesTest, FeaturesAreCountedFromTheFirstPointOfTheFile)
{
  auto points = changed(pointsOf(a_), [](const Point& p) { return Point{p.y / mm, -p.z / mm}; });
  std::reverse(points.begin(), points.end());
  folder_.write("reversed.txt", lines(points, " "));
  const RailSeries series = read("0 1000\n1\n2 0 0\n1\n0 'reversed.txt'\n0 16 20\n");
  const double length = series[0].profile->length();
  EXPECT_DOUBLE_EQ(series[0].places[0], length - 0.020);
  EXPECT_DOUBLE_EQ(series[0].places[1], length - 0.016);
}

TEST_F(SlicesTest, KinksAndAccelerationsAreSkipped)
{
  EXPECT_EQ(read("0 1000\n2\n1 2 1\n1\n0 'a.txt'\n1 'b.txt'\n1 2\n3\n0 16\n1 17\n")[1].places.at(0), 0.017);
}

TEST_F(SlicesTest, EachMistakeIsRefusedWithItsLine)
{
  const std::string slices = "0 'a.txt'\n1 'b.txt'\n";
  expectRefused("", 0, "is empty");
  expectRefused("0\n2\n0 0 0\n1\n" + slices, 1, "must contain U_OFFSET and the scale");
  expectRefused("0.5 1000\n2\n0 0 0\n1\n" + slices, 1, "U_OFFSET = 0.5: must be 0");
  expectRefused("0 0\n2\n0 0 0\n1\n" + slices, 1, "scale of the places = 0: must be positive");
  expectRefused("0 -1000\n2\n0 0 0\n1\n" + slices, 1, "must be positive");
  expectRefused("0 much\n2\n0 0 0\n1\n" + slices, 1, "'much' is not a number");
  expectRefused("0 1000\n2.5\n0 0 0\n1\n" + slices, 2, "'2.5' is not a number of slices");
  expectRefused("0 1000\n-2\n0 0 0\n1\n" + slices, 2, "'-2' is not a number of slices");
  expectRefused("0 1000\n1e9\n0 0 0\n1\n" + slices, 2, "'1e9' is not a number of slices");
  expectRefused("0 1000\n0\n0 0 0\n1\n", 2, "must not be 0");
  expectRefused("0 1000\n2\n0 0\n1\n" + slices, 3, "numbers of features, kinks and accelerations");
  expectRefused("0 1000\n2\n0 0 x\n1\n" + slices, 6, "'x' is not a number");
  expectRefused(head_ + "0 'a.txt'\n0 'b.txt'\n", 6, "must increase");
  expectRefused(head_ + "0 'a.txt'\n% the end\n", 6, "ends before a place and a file name");
  expectRefused(head_ + "0 a.txt\n1 'b.txt'\n", 5, "must be in quotes");
  expectRefused(head_ + "0 'a.txt\n1 'b.txt'\n", 5, "must be in quotes");
  expectRefused(head_ + "nan 'a.txt'\n1 'b.txt'\n", 5, "'nan' is not a number");
  expectRefused(head_ + "0\n1 'b.txt'\n", 5, "must contain a place and a file name");
  expectRefused("0 1000\n2\n2 0 0\n1\n" + slices + "0 16\n", 7, "the position of each feature");
  expectRefused("0 1000\n2\n2 0 0\n1\n" + slices + "0.5 16 20\n", 7, "must be those of the slices");
  expectRefused("0 1000\n2\n2 0 0\n1\n" + slices + "0 20 16\n", 7, "'16': the positions of the features must increase");
  expectRefused("0 1000\n2\n2 0 0\n1\n" + slices + "0 20 500\n", 7, "up to the length of the curve");
  expectRefused("0 1000\n2\n2 0 0\n1\n" + slices + "0 16 20\n", 7, "ends before a place and the position");
}

TEST_F(SlicesTest, MistakesInASliceAreThoseOfItsFile)
{
  expectRefused(head_ + "0 'missing.txt'\n1 'b.txt'\n", 0, "no such file");
  folder_.write("three.txt", "0 0\n1 2 3\n");
  expectRefused(head_ + "0 'three.txt'\n1 'b.txt'\n", 2, "number of columns is 3, must be 2");
  folder_.write("short.txt", "0 0\n1 0\n");
  expectRefused(head_ + "0 'short.txt'\n1 'b.txt'\n", 0, "number of points is 2");
  folder_.write("wheel.whl", "0 0\n");
  expectRefused(head_ + "0 'wheel.whl'\n1 'b.txt'\n", 0, "does not belong to a rail profile");
}
}  // namespace wheel_rail_contact::core
