// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/curve/spline.h"
#include "profile_helpers.h"
#include "section_scenes.h"

namespace wheel_rail_contact::core
{
namespace
{
using Edits = std::map<std::string, std::string>;

/// Text of a Simpack file, as written by the program. `edits` replaces or adds settings.
std::string simpack(ProfileKind kind, const std::string& points, const Edits& edits = {})
{
  Edits settings = {{"approx.smooth", "+0.000000000000000e+00"},
                    {"file", "'it is 50 % worn! (measured)'"},
                    {"units.len.f", "+1.000000000000000e+03"},
                    {"bound.y.min", "1"},
                    {"bound.y.max", "0"}};
  for (const auto& [key, value] : edits)
  {
    settings[key] = value;
  }
  std::string text =
      "! *** SIMPACK Rail-Wheel Profile ***\n\n  header.begin\n    version = 1  ! Version flag\n    type = ";
  text += kind == ProfileKind::wheel ? "1" : "0";
  text += "  ! 0=rail profile, 1=wheel profile\n  header.end\n  spline.begin\n";
  for (const auto& [key, value] : settings)
  {
    text += "    " + key + "  =  " + value + "  ! remark\n";
  }
  return text + "! units.len = 'mm'\n    point.begin\n    ! y z weight\n" + points +
         "    point.end\n  spline.end\n! End\n";
}

/// Converts points from the profile frame to the axes of Simpack [mm].
std::vector<Point> toSimpack(const std::vector<Point>& points)
{
  return scaled(points, 1e3, -1e3);
}

class SimpackProfile : public testing::Test
{
 protected:
  SimpackProfile() : rail_(pointsOf(rail60E1())), listed_(toSimpack(rail_)) {}

  /// Reads the points of the rail, after `change`, from a file with the edits that reverse the change.
  Profile read(const std::function<Point(const Point&)>& change, const Edits& edits)
  {
    return readProfile(
        folder_.write("rail.prr", simpack(ProfileKind::rail, lines(changed(listed_, change), "  "), edits)),
        ProfileKind::rail);
  }

  /// Expects that the edits reverse the change.
  void expectRail(const std::function<Point(const Point&)>& change, const Edits& edits)
  {
    EXPECT_LT(deviation(read(change, edits), rail_), 1e-12) << edits.begin()->first;
  }

  void expectRejected(const std::string& text, const std::string& reason, bool in_a_line,
                      ProfileKind kind = ProfileKind::rail)
  {
    SCOPED_TRACE(reason);
    const std::string path = folder_.write(kind == ProfileKind::rail ? "bad.prr" : "bad.prw", text);
    const auto error = thrownBy<FileError>([&] { readProfile(path, kind); });
    EXPECT_TRUE(contains(error.reason(), reason));
    EXPECT_EQ(error.line() > 0, in_a_line) << error.what();
  }

  Folder folder_;
  std::vector<Point> rail_;    ///< profile frame [m]
  std::vector<Point> listed_;  ///< axes of Simpack [mm]
};

TEST_F(SimpackProfile, ZOfARailPointsDown)
{
  const Profile profile = read([](const Point& p) { return p; }, {});
  EXPECT_EQ(profile.name(), "rail.prr");
  EXPECT_LT(deviation(profile, rail_), 1e-12);
  EXPECT_LT(profile.at(0.0).y, 0.0);
}

TEST_F(SimpackProfile, MirrorAndInversionOfTheBenchmarkWheelAreApplied)
{
  const std::vector<Point> wheel = pointsOf(s1002Wheel());
  const std::vector<Point> listed = scaled(wheel, -1e3, -1e3);
  const std::string path = folder_.write(
      "wheel.prw", simpack(ProfileKind::wheel, lines(listed, "\t"), {{"mirror.y", "1"}, {"inversion", "1"}}));
  EXPECT_LT(deviation(readProfile(path, ProfileKind::wheel), wheel), 1e-12);
}

TEST_F(SimpackProfile, EveryEditIsApplied)
{
  const double c = std::cos(0.02), s = std::sin(0.02);
  // The rotation about x turns y towards z.
  const auto turned = [&](const Point& p) { return Point{c * p.y + s * p.z, -s * p.y + c * p.z}; };
  expectRail([](const Point& p) { return Point{p.y - 5.0, p.z + 3.0}; }, {{"shift.y", "5"}, {"shift.z", "-3"}});
  expectRail(turned, {{"rotate", "0.02"}});
  expectRail(turned, {{"rotate", "1.1459155902616465"}, {"units.ang.f", "57.29577951308232"}});
  expectRail([](const Point& p) { return Point{-p.y, p.z}; }, {{"mirror.y", "1"}});
  expectRail([](const Point& p) { return Point{p.y, -p.z}; }, {{"mirror.z", "1"}});
  expectRail([](const Point& p) { return p; }, {{"inversion", "1"}});
  expectRail([](const Point& p) { return Point{p.y * 1e-3, p.z * 1e-3}; }, {{"units.len.f", "1"}});
}

TEST_F(SimpackProfile, EditsAreAppliedInTheOrderOfSimpack)
{
  // The file applies shift, rotation and mirror, in this order. They are reversed here in the opposite order.
  const double c = std::cos(-0.3), s = std::sin(-0.3);
  const auto undone = [&](const Point& p)
  {
    const Point unmirrored{-p.y, p.z};
    const Point unturned{c * unmirrored.y + s * unmirrored.z, -s * unmirrored.y + c * unmirrored.z};
    return Point{unturned.y - 10.0, unturned.z + 20.0};
  };
  expectRail(undone, {{"shift.y", "10"}, {"shift.z", "-20"}, {"rotate", "-0.3"}, {"mirror.y", "1"}});

  // Bounds apply after the rotation and before the mirror, in the unit of the file.
  const Profile cut = read(
      [](const Point& p) {
        return Point{-p.y, p.z};
      },
      {{"mirror.y", "1"}, {"bound.y.min", "-30"}, {"bound.y.max", "20"}, {"bound.z.min", "-1"}, {"bound.z.max", "30"}});
  EXPECT_NEAR(cut.at(0.0).y, -20.0 * mm, 0.3 * mm);
  EXPECT_NEAR(cut.at(cut.length()).y, 30.0 * mm, 0.3 * mm);
  EXPECT_GE(cut.at(0.0).y, -20.0 * mm);

  // The least distance applies before all other edits, in the unit of the file.
  const Profile thin = read([](const Point& p) { return p; }, {{"point.dist.min", "0.6"}});
  EXPECT_NEAR(static_cast<double>(rail_.size()) / static_cast<double>(thin.discontinuities().size()), 3.0, 0.05);
}

TEST_F(SimpackProfile, WeightsAndSmoothingAreApplied)
{
  std::ostringstream weighted;
  weighted << std::setprecision(12);
  for (std::size_t i = 0; i < listed_.size(); ++i)
  {
    const bool outlier = i % 50 == 25;
    weighted << listed_[i].y << " " << listed_[i].z - (outlier ? 1.0 : 0.0) << (outlier ? " 0\n" : " 1.0\n");
  }
  const Profile without =
      readProfile(folder_.write("a.prr", simpack(ProfileKind::rail, weighted.str())), ProfileKind::rail);
  std::vector<Point> kept;
  for (std::size_t i = 0; i < rail_.size(); ++i)
  {
    if (i % 50 != 25)
    {
      kept.push_back(rail_[i]);
    }
  }
  EXPECT_LT(deviation(without, kept), 1e-12);

  const Profile smooth = read([](const Point& p) { return p; }, {{"approx.smooth", "0.005"}});
  EXPECT_GT(deviation(smooth, rail_), 5e-6);
  EXPECT_LT(deviation(smooth, rail_), 50e-6);
}

TEST_F(SimpackProfile, InclinedBenchmarkRailKeepsItsPosition)
{
  // The rail as in the file of the benchmark: inclined 1:40, crown at (-7.4917, 0.0937) mm.
  const double c = std::cos(std::atan(1.0 / 40));
  const double s = std::sin(std::atan(1.0 / 40));
  const std::vector<Point> inclined =
      changed(pointsOf(railUic60Manchester()),
              [&](const Point& p) {
                return Point{c * p.y - s * p.z - 7.4917 * mm, s * p.y + c * p.z - 0.0937 * mm};
              });
  const std::string path = folder_.write("inclined.prr", simpack(ProfileKind::rail, lines(toSimpack(inclined), " ")));
  EXPECT_LT(deviation(readProfile(path, ProfileKind::rail), inclined), 1e-12);
}

TEST_F(SimpackProfile, ProfileOfTheOtherKindIsRejected)
{
  const std::string wheel = lines(toSimpack(pointsOf(s1002Wheel())), " ");
  expectRejected(simpack(ProfileKind::wheel, wheel), "wheel profile; a rail profile is required", true);
  expectRejected(simpack(ProfileKind::rail, lines(listed_, " ")), "rail profile; a wheel profile is required", true,
                 ProfileKind::wheel);
  expectRejected(simpack(ProfileKind::rail, wheel), "not a rail", false);
}

TEST_F(SimpackProfile, TruncatedFilesAreRejected)
{
  const std::string whole = simpack(ProfileKind::rail, lines(listed_, " "));
  expectRejected(whole.substr(0, whole.find("point.end")), "before point.end: truncated", true);
  expectRejected(whole.substr(0, whole.find("spline.end")), "before spline.end: truncated", true);
  expectRejected(whole.substr(0, whole.find("spline.begin")), "before point.end: truncated", true);
  expectRejected(whole.substr(0, whole.find("header.begin")), "is empty", false);
  expectRejected(whole.substr(0, whole.find("point.end") - 30) + "\n", "truncated", true);
}

TEST_F(SimpackProfile, DamagedFilesAreRejected)
{
  const std::string points = lines(listed_, " ");
  const auto with = [&](const Edits& edits) { return simpack(ProfileKind::rail, points, edits); };
  expectRejected(simpack(ProfileKind::rail, "1.0\n" + points), "not a point", true);
  expectRejected(simpack(ProfileKind::rail, "1 2 3 4\n" + points), "not a point", true);
  expectRejected(simpack(ProfileKind::rail, "1 nan\n" + points), "'nan' is not a finite number", true);
  expectRejected(simpack(ProfileKind::rail, "1 2 -1\n" + points), "weight is negative", true);
  expectRejected(with({{"mirror.y", "2"}}), "mirror.y is neither 0 nor 1", false);
  expectRejected(with({{"units.len.f", "0"}}), "units.len.f is not positive", false);
  expectRejected(with({{"point.dist.min", "-1"}}), "point.dist.min is negative", false);
  expectRejected(with({{"approx.smooth", "1"}}), "approx.smooth is above", false);
  expectRejected(with({{"shift.y", "left"}}), "value of 'shift.y' is not a number", true);
  expectRejected(with({{"shift.x", "0"}}), "unknown keyword 'shift.x'", true);
  expectRejected(with({{"units.len.f", "1"}}), "wrong unit", false);
  expectRejected(with({{"shift.y", "1e308"}, {"units.len.f", "1e-308"}}), "too large", true);
  expectRejected(with({}) + "  spline.begin\n    point.begin\n", "second block of points", true);
  expectRejected("  point.begin\n" + points, "out of place", true);
  expectRejected("y_mm,z_mm\n" + points, "the points are a profile by y: inward or outward, z: down", false);
  std::string text = with({});
  text.replace(text.find("version = 1"), 11, "version = 2");
  expectRejected(text, "version is not 1", true);
  text = with({});
  text.replace(text.find("type = 0"), 8, "type = 7");
  expectRejected(text, "neither 0 (rail) nor 1 (wheel)", true);
  text = with({});
  text.replace(text.find("type = 0"), 8, "kind = 0");
  expectRejected(text, "unknown keyword 'kind'", true);
}

// Slices files: rails whose profile changes along the line.
using section_scenes::profileOf;

/// Rounding of 12 digits, and of the unit [m].
constexpr double slice_rounding = 1e-12;

/// Text of a slice: y to the field side, z down, in units of `unit` [m].
std::string twoColumns(const Profile& profile, double unit)
{
  return lines(scaled(pointsOf(profile), 1 / unit, -1 / unit), " ");
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
    SCOPED_TRACE(text);
    const auto error = thrownBy<FileError>([&] { read(text); });
    EXPECT_EQ(error.line(), line) << error.what();
    EXPECT_TRUE(contains(error.reason(), reason));
  }

  const Profile a_ = profileOf({}), b_ = profileOf({0.003, 0.001, 0.033});
  const std::string head_ = "0 1000\n2\n0 0 0\n1\n";  ///< four lines: two slices, places in metres
  Folder folder_;
};

TEST_F(SlicesTest, PlacesAndProfilesAreReadBack)
{
  const RailSeries series = read(
      "% slices of a rail\n\n  0.0  1000.0   U_OFFSET, S_SCALE\n  2   % NSLC\n0 0 0\n 1\n\n"
      "-1.5 'a.txt' % it's the first\n0.25 'b.txt'\n");
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].x, -1.5);
  EXPECT_EQ(series[1].x, 0.25);
  EXPECT_LT(deviation(*series[0].profile, pointsOf(a_)), slice_rounding);
  EXPECT_LT(deviation(*series[1].profile, pointsOf(b_)), slice_rounding);
  EXPECT_TRUE(series[0].places.empty());
  // The scale is that of the places in millimetres.
  const RailSeries scaled_places = read("0 1\n2\n0 0 0\n1\n-1500 'a.txt'\n250 'b.txt'\n");
  EXPECT_DOUBLE_EQ(scaled_places[0].x, -1.5);
  EXPECT_DOUBLE_EQ(scaled_places[1].x, 0.25);
}

// A curve less than 1 wide is in metres, any other in millimetres.
TEST_F(SlicesTest, SlicesAreInMetresOrMillimetres)
{
  folder_.write("metres.txt", "% y z\n" + twoColumns(a_, 1.0));
  folder_.write("other.csv", "y_mm,z_mm\n" + lines(scaled(pointsOf(a_), 1e3, 1e3), ","));
  const RailSeries series = read("0 1000\n2\n0 0 0\n1\n0 'metres.txt'\n1 'other.csv'\n");
  EXPECT_LT(deviation(*series[0].profile, pointsOf(a_)), slice_rounding);
  EXPECT_LT(deviation(*series[1].profile, pointsOf(a_)), slice_rounding) << "a format of readProfile() has z up";
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
  EXPECT_NEAR(series[1].profile->at(0).y, -b_.at(b_.length()).y, slice_rounding);
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
  auto points = scaled(pointsOf(a_), 1e3, -1e3);
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
  expectRefused("0 much\n2\n0 0 0\n1\n" + slices, 1, "'much' is not a finite number");
  expectRefused("0 1000\n2.5\n0 0 0\n1\n" + slices, 2, "'2.5' is not a number of slices");
  expectRefused("0 1000\n-2\n0 0 0\n1\n" + slices, 2, "'-2' is not a number of slices");
  expectRefused("0 1000\n1e9\n0 0 0\n1\n" + slices, 2, "'1e9' is not a number of slices");
  expectRefused("0 1000\n0\n0 0 0\n1\n", 2, "must not be 0");
  expectRefused("0 1000\n2\n0 0\n1\n" + slices, 3, "numbers of features, kinks and accelerations");
  expectRefused("0 1000\n2\n0 0 x\n1\n" + slices, 6, "'x' is not a finite number");
  expectRefused(head_ + "0 'a.txt'\n0 'b.txt'\n", 6, "must increase");
  expectRefused(head_ + "0 'a.txt'\n% the end\n", 6, "ends before a place and a file name");
  expectRefused(head_ + "0 a.txt\n1 'b.txt'\n", 5, "must be in quotes");
  expectRefused(head_ + "0 'a.txt\n1 'b.txt'\n", 5, "must be in quotes");
  expectRefused(head_ + "nan 'a.txt'\n1 'b.txt'\n", 5, "'nan' is not a finite number");
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
}  // namespace
}  // namespace wheel_rail_contact::core
