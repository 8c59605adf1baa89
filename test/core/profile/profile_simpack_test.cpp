// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/profile/smoothing_spline.h"
#include "profile_helpers.h"
#include "wheel_rail_contact/core/profile_reader.h"
#include "wheel_rail_contact/core/standard_profiles.h"

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

/// Simpack file as its program writes it; `edits` replaces or adds settings.
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

/// From the profile frame to Simpack's axes in mm.
Point toSimpack(const Point& p)
{
  return {p.y * 1e3, -p.z * 1e3};
}

class SimpackProfile : public testing::Test
{
 protected:
  SimpackProfile() : rail_(pointsOf(rail60E1())), listed_(changed(rail_, toSimpack)) {}

  /// Reads the rail's points, changed as given, from a file with the edits that undo the change.
  Profile read(const std::function<Point(const Point&)>& change, const Edits& edits)
  {
    return readProfile(
        folder_.write("rail.prr", simpack(ProfileKind::rail, lines(changed(listed_, change), "  "), edits)),
        ProfileKind::rail);
  }

  void expectRefused(const std::string& text, const std::string& reason, bool in_a_line,
                     ProfileKind kind = ProfileKind::rail)
  {
    SCOPED_TRACE(reason);
    try
    {
      readProfile(folder_.write(kind == ProfileKind::rail ? "bad.prr" : "bad.prw", text), kind);
      ADD_FAILURE() << "was read";
    }
    catch (const ProfileError& error)
    {
      EXPECT_NE(error.reason().find(reason), std::string::npos) << error.what();
      EXPECT_EQ(error.line() > 0, in_a_line) << error.what();
    }
  }

  Folder folder_;
  std::vector<Point> rail_;    ///< profile frame [m]
  std::vector<Point> listed_;  ///< Simpack's axes [mm]
};

TEST_F(SimpackProfile, RailIsReadWithZDown)
{
  const Profile profile = read([](const Point& p) { return p; }, {});
  EXPECT_EQ(profile.name(), "rail.prr");
  EXPECT_LT(deviation(profile, rail_), 1e-12);
  EXPECT_LT(profile.at(0.0).y, 0.0);
}

TEST_F(SimpackProfile, WheelListedAsInTheBenchmarkFileIsMirroredAndInverted)
{
  const std::vector<Point> wheel = pointsOf(s1002Wheel());
  const std::vector<Point> listed = changed(wheel, [](const Point& p) { return Point{-p.y * 1e3, -p.z * 1e3}; });
  const std::string path = folder_.write(
      "wheel.prw", simpack(ProfileKind::wheel, lines(listed, "\t"), {{"mirror.y", "1"}, {"inversion", "1"}}));
  EXPECT_LT(deviation(readProfile(path, ProfileKind::wheel), wheel), 1e-12);
}

TEST_F(SimpackProfile, EveryEditIsHonoured)
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
  // Rotation about x turns y towards z.
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

TEST_F(SimpackProfile, EditsAreMadeInSimpacksOrder)
{
  // Shift, then rotation, then mirror: undone in the opposite order here.
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

  // Bounds count after the rotation and before the mirror, in the file's unit.
  const Profile cut = read(
      [](const Point& p) {
        return Point{-p.y, p.z};
      },
      {{"mirror.y", "1"}, {"bound.y.min", "-30"}, {"bound.y.max", "20"}, {"bound.z.min", "-1"}, {"bound.z.max", "30"}});
  EXPECT_NEAR(cut.at(0.0).y, -20.0 * mm, 0.3 * mm);
  EXPECT_NEAR(cut.at(cut.length()).y, 30.0 * mm, 0.3 * mm);
  EXPECT_GE(cut.at(0.0).y, -20.0 * mm);

  // The least distance counts before all other edits, in the file's unit.
  const Profile thin = read([](const Point& p) { return p; }, {{"point.dist.min", "0.6"}});
  EXPECT_NEAR(static_cast<double>(rail_.size()) / static_cast<double>(thin.discontinuities().size()), 3.0, 0.05);
}

TEST_F(SimpackProfile, WeightsAndSmoothingAreHonoured)
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

TEST_F(SimpackProfile, InclinedRailOfTheBenchmarkLiesWhereItWas)
{
  // As the benchmark stores its rail: turned by 1:40, crown at (-7.4917, 0.0937) mm.
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

TEST_F(SimpackProfile, RefusesTheOtherKind)
{
  const std::string wheel = lines(changed(pointsOf(s1002Wheel()), toSimpack), " ");
  expectRefused(simpack(ProfileKind::wheel, wheel), "profile of a wheel where a rail is wanted", true);
  expectRefused(simpack(ProfileKind::rail, lines(listed_, " ")), "profile of a rail where a wheel is wanted", true,
                ProfileKind::wheel);
  expectRefused(simpack(ProfileKind::rail, wheel), "not a rail", false);
}

TEST_F(SimpackProfile, RefusesWhatIsCutOff)
{
  const std::string whole = simpack(ProfileKind::rail, lines(listed_, " "));
  expectRefused(whole.substr(0, whole.find("point.end")), "before point.end: cut off", true);
  expectRefused(whole.substr(0, whole.find("spline.end")), "before spline.end: cut off", true);
  expectRefused(whole.substr(0, whole.find("spline.begin")), "before point.end: cut off", true);
  expectRefused(whole.substr(0, whole.find("header.begin")), "not a Simpack profile", false);
  expectRefused(whole.substr(0, whole.find("point.end") - 30) + "\n", "cut off", true);
}

TEST_F(SimpackProfile, RefusesWhatIsDamaged)
{
  const std::string points = lines(listed_, " ");
  const auto with = [&](const Edits& edits) { return simpack(ProfileKind::rail, points, edits); };
  expectRefused(simpack(ProfileKind::rail, "1.0\n" + points), "not a point", true);
  expectRefused(simpack(ProfileKind::rail, "1 2 3 4\n" + points), "not a point", true);
  expectRefused(simpack(ProfileKind::rail, "1 nan\n" + points), "'nan' is not a number", true);
  expectRefused(simpack(ProfileKind::rail, "1 2 -1\n" + points), "weight is negative", true);
  expectRefused(with({{"mirror.y", "2"}}), "mirror.y is neither 0 nor 1", false);
  expectRefused(with({{"units.len.f", "0"}}), "units.len.f is not positive", false);
  expectRefused(with({{"point.dist.min", "-1"}}), "point.dist.min is negative", false);
  expectRefused(with({{"approx.smooth", "1"}}), "approx.smooth is above", false);
  expectRefused(with({{"shift.y", "left"}}), "value of 'shift.y' is not a number", true);
  expectRefused(with({{"shift.x", "0"}}), "unknown keyword 'shift.x'", true);
  expectRefused(with({{"units.len.f", "1"}}), "wrong unit", false);
  expectRefused(with({{"shift.y", "1e308"}, {"units.len.f", "1e-308"}}), "beyond all numbers", true);
  expectRefused(with({}) + "  spline.begin\n    point.begin\n", "second block of points", true);
  expectRefused("  point.begin\n" + points, "out of place", true);
  expectRefused("y_mm,z_mm\n" + points, "not a Simpack profile", true);
  std::string text = with({});
  text.replace(text.find("version = 1"), 11, "version = 2");
  expectRefused(text, "version is not 1", true);
  text = with({});
  text.replace(text.find("type = 0"), 8, "type = 7");
  expectRefused(text, "neither 0 (rail) nor 1 (wheel)", true);
  text = with({});
  text.replace(text.find("type = 0"), 8, "kind = 0");
  expectRefused(text, "unknown keyword 'kind'", true);
}
}  // namespace
}  // namespace wheel_rail_contact::core
