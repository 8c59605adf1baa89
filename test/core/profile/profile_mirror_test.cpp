// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "profile_helpers.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
namespace
{
using test::changed;
using test::Folder;
using test::lines;
using test::Point;
using test::pointsOf;

ProfileReading mirrored(std::optional<double> smoothing = std::nullopt)
{
  ProfileReading reading;
  reading.smoothing = smoothing;
  reading.mirror = true;
  return reading;
}

const ProfileReading mirror = mirrored();

/// Points of a rail head with more wear on its gauge side [m].
std::vector<Point> wornRail()
{
  return changed(pointsOf(rail60E1()), [](const Point& p) { return Point{p.y, p.z * (p.y < 0 ? 1.02 : 1)}; });
}

Point negated(const Point& p)
{
  return {-p.y, p.z};
}

/// Expects the curves to be equal in every bit.
void expectSameCurve(const Profile& a, const Profile& b)
{
  ASSERT_EQ(a.length(), b.length());
  for (int i = 0; i <= 500; ++i)
  {
    const CurvePoint p = a.at(a.length() * i / 500), q = b.at(a.length() * i / 500);
    EXPECT_EQ(p.y, q.y);
    EXPECT_EQ(p.z, q.z);
    EXPECT_EQ(p.dy, q.dy);
    EXPECT_EQ(p.ddz, q.ddz);
  }
}

/// Text of a file in a format, from points in the profile frame [m].
struct Format
{
  const char* extension;
  ProfileKind kind;
  std::string (*text)(const std::vector<Point>& points);
};

std::string csv(const std::vector<Point>& points)
{
  return "y_m,z_m\n" + lines(points, ",");
}

std::string simpack(const std::vector<Point>& points, const char* type)
{
  return std::string("header.begin\n version = 1\n type = ") + type +
         "\nheader.end\nspline.begin\n approx.smooth = 0\n units.len.f = 1000\n point.begin\n" +
         lines(changed(points,
                       [](const Point& p) {
                         return Point{p.y * 1e3, -p.z * 1e3};
                       }),
               " ") +
         " point.end\nspline.end\n";
}

const Format formats[] = {
    {"csv", ProfileKind::wheel, csv},
    {"csv", ProfileKind::rail, csv},
    {"prw", ProfileKind::wheel, [](const std::vector<Point>& points) { return simpack(points, "1"); }},
    {"prr", ProfileKind::rail, [](const std::vector<Point>& points) { return simpack(points, "0"); }},
    {"whl", ProfileKind::wheel,
     [](const std::vector<Point>& points) {
       return lines(changed(points, [](const Point& p) { return Point{p.y * 1e3 + 70, -p.z * 1e3}; }), " ");
     }},
    {"ban", ProfileKind::rail, [](const std::vector<Point>& points) {
       return lines(changed(points, [](const Point& p) { return Point{-p.y * 1e3, p.z * 1e3}; }), " ");
     }}};
}  // namespace

// The sign of a number in the file does not affect its rounding, except that of a MiniProf wheel, whose X is counted
// from the flange back: 70 mm + y and 70 mm - y are written with twelve digits, to 1e-13 m.
TEST(MirroredProfile, IsTheProfileWrittenWithYNegated)
{
  const Folder folder;
  for (const Format& format : formats)
  {
    SCOPED_TRACE(format.extension);
    const std::vector<Point> points = format.kind == ProfileKind::wheel ? pointsOf(s1002Wheel()) : wornRail();
    const std::string name = std::string("given.") + format.extension;
    const Profile given = readProfile(folder.write(name, format.text(points)), format.kind);
    const std::string negated_name = std::string("negated.") + format.extension;
    const std::string path = folder.write(negated_name, format.text(changed(points, negated)));
    const Profile mirrored = readProfile(path, format.kind, mirror);
    EXPECT_EQ(mirrored.name(), negated_name);
    if (std::string(format.extension) == "whl")
    {
      EXPECT_NEAR(mirrored.length(), given.length(), 1e-9);
      EXPECT_LT(test::deviation(mirrored, pointsOf(given)), 1e-9) << "1e-13 m over 0.25 mm, smoothed";
    }
    else
    {
      expectSameCurve(mirrored, given);
    }
  }
}

TEST(MirroredProfile, OfAStandardNameIsRefused)
{
  const std::pair<std::string, ProfileKind> standards[] = {
      {"S1002", ProfileKind::wheel}, {"60E1", ProfileKind::rail}, {"UIC60_manchester", ProfileKind::rail}};
  for (const auto& [name, kind] : standards)
  {
    EXPECT_EQ(loadProfile(name, kind).name(), name);
    try
    {
      loadProfile(name, kind, mirror);
      ADD_FAILURE() << name << " was accepted";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("mirror"), std::string::npos) << error.what();
    }
  }
}

TEST(MirroredProfile, OfAWheelOfTheRightOrientationIsNotAWheel)
{
  const Folder folder;
  const std::vector<Point> wheel = pointsOf(s1002Wheel());
  const std::string given = folder.write("given.csv", csv(wheel));
  const std::string negated_file = folder.write("negated.csv", csv(changed(wheel, negated)));
  EXPECT_THROW(readProfile(given, ProfileKind::wheel, mirror), FileError);
  EXPECT_THROW(readProfile(negated_file, ProfileKind::wheel), FileError);
  EXPECT_NO_THROW(loadProfile(negated_file, ProfileKind::wheel, mirror));
}

TEST(MirroredProfile, IsSmoothedForTheSameNoise)
{
  const Folder folder;
  const std::vector<Point> rail = wornRail();
  const Profile given = readProfile(folder.write("given.csv", csv(rail)), ProfileKind::rail, {5e-6});
  const std::string path = folder.write("negated.csv", csv(changed(rail, negated)));
  expectSameCurve(readProfile(path, ProfileKind::rail, mirrored(5e-6)), given);
}
}  // namespace wheel_rail_contact::core
