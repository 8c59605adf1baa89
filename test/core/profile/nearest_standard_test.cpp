// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/nearest_standard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/profile/curve_search.h"
#include "core/profile/profile_measures.h"
#include "core/profile/shape_error.h"
#include "core/profile/smoothing_spline.h"
#include "profile_helpers.h"
#include "wheel_rail_contact/core/profile_reader.h"

using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::test;

namespace
{
/// Curve through the points of a profile after a motion.
Profile moved(const Profile& profile, const ProfileMotion& motion)
{
  const double c = std::cos(motion.rotation), s = std::sin(motion.rotation);
  std::vector<SampledPoint> points;
  for (const Point& p : pointsOf(profile))
  {
    points.push_back({c * p.y - s * p.z + motion.y, s * p.y + c * p.z + motion.z});
  }
  return {"moved", interpolatingSpline(points)};
}

/// Curve through the points of a profile after a change of their heights.
template <typename Height>
Profile worn(const Profile& profile, const Height& height)
{
  std::vector<SampledPoint> points;
  for (const Point& p : pointsOf(profile))
  {
    points.push_back({p.y, p.z + height(p.y)});
  }
  return {"worn", interpolatingSpline(points)};
}

/// Root mean square distance of the running surface of a rail from another rail, at points every 0.25 mm.
double rmsDistance(const Profile& rail, const Profile& other)
{
  const CurveFeet feet(other);
  const ParameterRange surface = runningSurface(rail, ProfileKind::rail);
  double squares = 0;
  int count = 0;
  for (double u = surface.begin; u < surface.end; u += 0.25 * mm, ++count)
  {
    const CurvePoint p = rail.at(u), q = other.at(feet.nearest(p.y, p.z));
    squares += std::pow(p.y - q.y, 2) + std::pow(p.z - q.z, 2);
  }
  return std::sqrt(squares / count);
}
}  // namespace

// The interpolating spline deviates by up to 0.2 um from the standard, near discontinuities of the curvature.
TEST(NearestStandard, OfAMovedRailIsThisRailWithItsMotion)
{
  for (const ProfileMotion motion :
       {ProfileMotion{0, 0, 0}, ProfileMotion{0.025, 2.1 * mm, -1.3 * mm}, ProfileMotion{-0.06, -7 * mm, 3 * mm}})
  {
    for (const Profile& rail : {rail60E1(), railUic60Manchester()})
    {
      const StandardFit fit = nearestStandard(moved(rail, motion), ProfileKind::rail);
      EXPECT_EQ(fit.name, rail.name());
      EXPECT_NEAR(fit.motion.rotation, motion.rotation, 1e-6);
      EXPECT_NEAR(fit.motion.y, motion.y, 1e-7);
      EXPECT_NEAR(fit.motion.z, motion.z, 1e-7);
      EXPECT_LT(fit.rms, 1e-7);
      EXPECT_LT(std::abs(fit.largest), 4e-7);
      EXPECT_GT(fit.share, 0.999);
    }
  }
}

TEST(NearestStandard, OfAMovedWheelIsFoundWithoutRotation)
{
  const StandardFit fit = nearestStandard(moved(s1002Wheel(), {0, 0.8 * mm, -0.5 * mm}), ProfileKind::wheel);
  EXPECT_EQ(fit.name, "S1002");
  EXPECT_EQ(fit.motion.rotation, 0);
  EXPECT_NEAR(fit.motion.y, 0.8 * mm, 1e-7);
  EXPECT_NEAR(fit.motion.z, -0.5 * mm, 1e-7);
  EXPECT_LT(fit.rms, 2e-7);
}

// A hollow of 1 mm: it is the largest distance, below the standard, less what the fit moves the standard down.
TEST(NearestStandard, DistanceShowsWear)
{
  const auto hollow = [](double y) { return -1 * mm * std::exp(-std::pow(y / (8 * mm), 2)); };
  const StandardFit fit = nearestStandard(worn(rail60E1(), hollow), ProfileKind::rail);
  EXPECT_NEAR(fit.y, 0, 1 * mm);
  EXPECT_LT(fit.largest, -0.5 * mm);
  EXPECT_NEAR(fit.largest, -1 * mm - fit.motion.z, 0.05 * mm);
  EXPECT_GT(fit.rms, 0.1 * mm);
}

// Least squares: no small motion makes the root mean square smaller.
TEST(NearestStandard, RootMeanSquareIsSmallest)
{
  const auto side_wear = [](double y) { return y < -20 * mm ? 0.2 * (y + 20 * mm) : 0; };
  const Profile rail = worn(rail60E1(), side_wear), standard = rail60E1();
  const StandardFit fit = standardFit(rail, ProfileKind::rail, standard, true);
  ASSERT_GT(fit.rms, 0.2 * mm);
  const double smallest = rmsDistance(rail, moved(standard, fit.motion));
  EXPECT_NEAR(smallest, fit.rms, 5e-3 * fit.rms);  // other points are compared
  for (const double step : {-1e-3, 1e-3})
  {
    for (const ProfileMotion by :
         {ProfileMotion{step, 0, 0}, ProfileMotion{0, 35 * mm * step, 0}, ProfileMotion{0, 0, 35 * mm * step}})
    {
      const ProfileMotion motion{fit.motion.rotation + by.rotation, fit.motion.y + by.y, fit.motion.z + by.z};
      EXPECT_GT(rmsDistance(rail, moved(standard, motion)), smallest) << by.rotation << ' ' << by.y << ' ' << by.z;
    }
  }
}

// Noise of 20 um (seed 5) has the same root mean square; a motion takes away only three of 400 degrees of freedom.
TEST(NearestStandard, DistanceOfNoiseIsTheNoise)
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 20e-6);
  const Profile rail = worn(rail60E1(), [&](double y) { return std::abs(y) < 30 * mm ? noise(random) : 0; });
  const StandardFit fit = nearestStandard(rail, ProfileKind::rail);
  EXPECT_GT(fit.rms, 10e-6);
  EXPECT_LT(fit.rms, 22e-6);
  EXPECT_NEAR(fit.motion.rotation, 0, 1e-3);
}

TEST(NearestStandard, RangesOfMissingPointsAreNotCompared)
{
  std::vector<SampledPoint> points;
  for (const Point& p : pointsOf(rail60E1()))
  {
    if (std::abs(p.y) > 10 * mm)
    {
      points.push_back({p.y, p.z});
    }
  }
  std::vector<ProfileSection> sections = interpolatingSpline(points);
  std::max_element(sections.begin(), sections.end(), [](const auto& a, const auto& b) { return a.length < b.length; })
      ->error.missing = true;
  const StandardFit fit = standardFit({"gap", sections}, ProfileKind::rail, rail60E1(), true);
  EXPECT_LT(std::abs(fit.largest), 1e-6);
}

TEST(NearestStandard, IsNoneIfNoPointOfTheRunningSurfaceIsKnown)
{
  std::vector<SampledPoint> points;
  for (const Point& p : pointsOf(rail60E1()))
  {
    points.push_back({p.y, p.z});
  }
  std::vector<ProfileSection> sections = interpolatingSpline(points);
  for (ProfileSection& section : sections)
  {
    section.error.missing = true;
  }
  const Profile rail("unknown", sections);
  const StandardFit fit = standardFit(rail, ProfileKind::rail, rail60E1(), true);
  EXPECT_EQ(fit.share, 0);
  EXPECT_TRUE(std::isinf(fit.rms)) << fit.rms;
  EXPECT_TRUE(std::isinf(nearestStandard(rail, ProfileKind::rail).rms));
}

// A crown R203 that is 66 mm wide, with missing points of the corners, fits badly: with whole steps of the least
// squares the motion never stays, and ends with a larger distance than without rotation.
TEST(NearestStandard, RotationDoesNotMakeTheDistanceLarger)
{
  std::vector<SampledPoint> points{{-36.83 * mm, -22.86 * mm}, {-36.58 * mm, -15.24 * mm}, {-35.56 * mm, -7.62 * mm}};
  for (int i = -40; i <= 40; ++i)
  {
    const double y = 0.8255 * mm * i, radius = 203.2 * mm;
    points.push_back({y, std::sqrt(radius * radius - y * y) - radius});
  }
  for (const std::size_t i : {2, 1, 0})
  {
    points.push_back({-points[i].y, points[i].z});
  }
  std::vector<ProfileSection> sections = interpolatingSpline(points);
  markMissing(points, false, sections);
  const Profile rail("crown", sections);
  const StandardFit shifted = standardFit(rail, ProfileKind::rail, rail60E1(), false);
  const StandardFit rotated = standardFit(rail, ProfileKind::rail, rail60E1(), true);
  EXPECT_GT(shifted.rms, 0.5 * mm);
  EXPECT_LE(rotated.rms, shifted.rms);
  EXPECT_NEAR(shifted.motion.y, 0, 1e-6);
}

// A head that is 30 mm wide at its flat top is no standard rail: most of its points are beyond the ends of none, and
// the distance is large.
TEST(NearestStandard, OfAnotherShapeIsFar)
{
  std::vector<SampledPoint> points;
  for (int i = -60; i <= 60; ++i)
  {
    points.push_back({0.5 * mm * i, std::abs(i) > 30 ? -1 * mm * (std::abs(i) - 30) : -1e-9 * i * i});
  }
  EXPECT_GT(nearestStandard({"plate", interpolatingSpline(points)}, ProfileKind::rail).rms, 0.5 * mm);
}
