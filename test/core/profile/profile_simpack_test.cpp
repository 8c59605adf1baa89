// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/profile/curve/spline.h"
#include "profile_helpers.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
namespace
{
using test::changed;
using test::deviation;
using test::Folder;
using test::lines;
using test::mm;
using test::Point;
using test::pointsOf;

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

/// Converts a point from the profile frame to the axes of Simpack [mm].
Point toSimpack(const Point& p)
{
  return {p.y * 1e3, -p.z * 1e3};
}

class SimpackProfile : public testing::Test
{
 protected:
  SimpackProfile() : rail_(pointsOf(rail60E1())), listed_(changed(rail_, toSimpack)) {}

  /// Reads the points of the rail, after `change`, from a file with the edits that reverse the change.
  Profile read(const std::function<Point(const Point&)>& change, const Edits& edits)
  {
    return readProfile(
        folder_.write("rail.prr", simpack(ProfileKind::rail, lines(changed(listed_, change), "  "), edits)),
        ProfileKind::rail);
  }

  void expectRejected(const std::string& text, const std::string& reason, bool in_a_line,
                      ProfileKind kind = ProfileKind::rail)
  {
    SCOPED_TRACE(reason);
    try
    {
      readProfile(folder_.write(kind == ProfileKind::rail ? "bad.prr" : "bad.prw", text), kind);
      ADD_FAILURE() << "the file was accepted";
    }
    catch (const FileError& error)
    {
      EXPECT_NE(error.reason().find(reason), std::string::npos) << error.what();
      EXPECT_EQ(error.line() > 0, in_a_line) << error.what();
    }
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
  const std::vector<Point> listed = changed(wheel, [](const Point& p) { return Point{-p.y * 1e3, -p.z * 1e3}; });
  const std::string path = folder_.write(
      "wheel.prw", simpack(ProfileKind::wheel, lines(listed, "\t"), {{"mirror.y", "1"}, {"inversion", "1"}}));
  EXPECT_LT(deviation(readProfile(path, ProfileKind::wheel), wheel), 1e-12);
}

TEST_F(SimpackProfile, EveryEditIsApplied)
{
  const double c = std::cos(0.02);
  const double s = std::sin(0.02);
  EXPECT_LT(deviation(read(
                          [](const Point& p) {
                            return Point{p.y - 5.0, p.z + 3.0};
                          },
                          {{"shift.y", "5"}, {"shift.z", "-3"}}),
                      rail_),
            1e-12);
  // The rotation about x turns y towards z.
  EXPECT_LT(deviation(read(
                          [&](const Point& p) {
                            return Point{c * p.y + s * p.z, -s * p.y + c * p.z};
                          },
                          {{"rotate", "0.02"}}),
                      rail_),
            1e-12);
  EXPECT_LT(deviation(read(
                          [&](const Point& p) {
                            return Point{c * p.y + s * p.z, -s * p.y + c * p.z};
                          },
                          {{"rotate", "1.1459155902616465"}, {"units.ang.f", "57.29577951308232"}}),
                      rail_),
            1e-12);
  EXPECT_LT(deviation(read([](const Point& p) { return Point{-p.y, p.z}; }, {{"mirror.y", "1"}}), rail_), 1e-12);
  EXPECT_LT(deviation(read([](const Point& p) { return Point{p.y, -p.z}; }, {{"mirror.z", "1"}}), rail_), 1e-12);
  EXPECT_LT(deviation(read([](const Point& p) { return p; }, {{"inversion", "1"}}), rail_), 1e-12);
  EXPECT_LT(deviation(read(
                          [](const Point& p) {
                            return Point{p.y * 1e-3, p.z * 1e-3};
                          },
                          {{"units.len.f", "1"}}),
                      rail_),
            1e-12);
}

TEST_F(SimpackProfile, EditsAreAppliedInTheOrderOfSimpack)
{
  // The file applies shift, rotation and mirror, in this order. They are reversed here in the opposite order.
  const double c = std::cos(-0.3);
  const double s = std::sin(-0.3);
  const auto undone = [&](const Point& p)
  {
    const Point unmirrored{-p.y, p.z};
    const Point unturned{c * unmirrored.y + s * unmirrored.z, -s * unmirrored.y + c * unmirrored.z};
    return Point{unturned.y - 10.0, unturned.z + 20.0};
  };
  EXPECT_LT(
      deviation(read(undone, {{"shift.y", "10"}, {"shift.z", "-20"}, {"rotate", "-0.3"}, {"mirror.y", "1"}}), rail_),
      1e-12);

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
  const std::string path =
      folder_.write("inclined.prr", simpack(ProfileKind::rail, lines(changed(inclined, toSimpack), " ")));
  EXPECT_LT(deviation(readProfile(path, ProfileKind::rail), inclined), 1e-12);
}

TEST_F(SimpackProfile, ProfileOfTheOtherKindIsRejected)
{
  const std::string wheel = lines(changed(pointsOf(s1002Wheel()), toSimpack), " ");
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
  expectRejected(simpack(ProfileKind::rail, "1 nan\n" + points), "'nan' is not a number", true);
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
}  // namespace
}  // namespace wheel_rail_contact::core
