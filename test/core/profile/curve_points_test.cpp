// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/curve_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "profile_helpers.h"
#include "wheel_rail_contact/core/profile_reader.h"

using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::test;

namespace
{
constexpr double same = 1e-7;  ///< tolerance of a curve that is read again [m]

std::string table(const std::vector<Point>& points)
{
  return "y_mm,z_mm\n" + lines(changed(points, [](const Point& p) { return Point{p.y / mm, p.z / mm}; }), ",");
}

class ReadAgain : public testing::Test
{
 protected:
  DescribedProfile again(const Profile& profile, ProfileKind kind)
  {
    std::vector<Point> points;
    for (const ProfilePlace& p : pointsAlong(profile))
    {
      points.push_back({p.y, p.z});
    }
    return describedProfile(folder_.write("again.csv", table(points)), kind);
  }
  void expectSame(const Profile& profile, ProfileKind kind)
  {
    const DescribedProfile read = again(profile, kind);
    EXPECT_EQ(read.report.omitted, 0U);
    EXPECT_EQ(read.report.smoothing, 0);
    EXPECT_LT(largestDistance(read.profile, profile), same);
    EXPECT_LT(largestDistance(profile, read.profile), same);
  }
  Folder folder_;
};

/// Points of a profile 0.25 mm apart, with noise across the curve [m].
std::vector<Point> noisyPoints(const Profile& profile, double deviation, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, deviation);
  const int count = static_cast<int>(profile.length() / (0.25 * mm));
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i)
  {
    const CurvePoint p = profile.at(profile.length() * i / count);
    const double shift = noise(random) / std::hypot(p.dy, p.dz);
    points.push_back({p.y - shift * p.dz, p.z + shift * p.dy});
  }
  return points;
}

Profile read(const Folder& folder, const std::vector<Point>& points, ProfileKind kind)
{
  return readProfile(folder.write("first.csv", table(points)), kind);
}
}  // namespace

TEST_F(ReadAgain, CurveThroughPointsIsTheSame)
{
  expectSame(read(folder_, pointsOf(rail60E1()), ProfileKind::rail), ProfileKind::rail);
  expectSame(read(folder_, pointsOf(s1002Wheel()), ProfileKind::wheel), ProfileKind::wheel);
}

TEST_F(ReadAgain, CurveThroughSparsePointsIsTheSame)
{
  std::vector<Point> points;
  for (double u = 0; u < rail60E1().length(); u += 2.3 * mm)
  {
    points.push_back({rail60E1().at(u).y, rail60E1().at(u).z});
  }
  expectSame(read(folder_, points, ProfileKind::rail), ProfileKind::rail);
}

TEST_F(ReadAgain, SmoothedCurveIsTheSame)
{
  for (const auto& [profile, kind] :
       {std::pair{rail60E1(), ProfileKind::rail}, std::pair{s1002Wheel(), ProfileKind::wheel}})
  {
    const DescribedProfile first =
        describedProfile(folder_.write("first.csv", table(noisyPoints(profile, 10e-6, 11))), kind);
    ASSERT_GT(first.report.smoothing, 5e-6);
    expectSame(first.profile, kind);
  }
}

TEST_F(ReadAgain, MissingPointsAreMissingAgain)
{
  for (const double noise : {0.0, 5e-6})
  {
    std::vector<Point> points = noisyPoints(rail60E1(), noise, 12);
    points.erase(
        std::remove_if(points.begin(), points.end(), [](const Point& p) { return p.y > -12 * mm && p.y < 8 * mm; }),
        points.end());
    const Profile first = read(folder_, points, ProfileKind::rail);
    ASSERT_TRUE(first.errorAt(parameterAt(first, -2 * mm)).missing);
    const Profile second = again(first, ProfileKind::rail).profile;
    EXPECT_TRUE(second.errorAt(parameterAt(second, -2 * mm)).missing);
    EXPECT_FALSE(second.errorAt(parameterAt(second, 9 * mm)).missing);
    EXPECT_LT(largestDistance(second, first), same) << noise;
  }
}

TEST_F(ReadAgain, StandardRailIsTheSame)
{
  expectSame(rail60E1(), ProfileKind::rail);
}

TEST(PointsAlong, AreAtMostAFifthOfAMillimetreApart)
{
  const std::vector<ProfilePlace> points = pointsAlong(s1002Wheel());
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const double distance = std::hypot(points[i].y - points[i - 1].y, points[i].z - points[i - 1].z);
    EXPECT_LT(distance, 0.201 * mm);
    EXPECT_GT(distance, 0.05 * mm);
  }
}

TEST(LargestDistance, IsThatOfParallelCurves)
{
  const Profile line{"", {{LineSection{-50 * mm, 0, 1, 0}, 100 * mm}}};
  const Profile above{"", {{LineSection{-50 * mm, 1 * mm, 1, 0}, 100 * mm}}};
  EXPECT_NEAR(largestDistance(line, above), 1 * mm, 1e-12);
}
