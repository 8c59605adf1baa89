// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/curve/spline.h"
#include "profile_helpers.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr unsigned point_seed = 7;

/// Points of a profile, about `spacing` [m] apart, with white noise of standard deviation `noise` [m] across and along
/// the curve.
std::vector<SampledPoint> sample(const Profile& profile, double spacing, double noise)
{
  std::mt19937 generator(point_seed);
  std::normal_distribution<double> deviation(0.0, 1.0);
  std::vector<SampledPoint> points;
  const int count = static_cast<int>(profile.length() / spacing);
  for (int i = 0; i <= count; ++i)
  {
    const CurvePoint p = profile.at(profile.length() * i / count);
    const double speed = std::hypot(p.dy, p.dz);
    const double across = noise * deviation(generator) / speed;
    const double along = noise * deviation(generator) / speed;
    points.push_back({p.y - across * p.dz + along * p.dy, p.z + across * p.dy + along * p.dz});
  }
  return points;
}

/// Deviations of a curve from a profile.
struct Deviation
{
  double value = 0;              ///< largest deviation across the curve [m]
  double curvature = 0;          ///< root mean square deviation of the curvature [1/m]
  double largest_curvature = 0;  ///< largest deviation of the curvature [1/m]
};

Deviation compare(const Profile& truth, const Profile& curve, double y_from, double y_to)
{
  Deviation deviation;
  const int count = 400;
  for (int i = 0; i <= count; ++i)
  {
    const double y = y_from + (y_to - y_from) * i / count;
    const CurvePoint expected = truth.at(parameterAt(truth, y));
    const CurvePoint found = curve.at(parameterAt(curve, y));
    const double bend = found.curvature() - expected.curvature();
    deviation.value = std::max(deviation.value, std::abs(found.z - expected.z) / std::hypot(1.0, expected.slope()));
    deviation.curvature += bend * bend / count;
    deviation.largest_curvature = std::max(deviation.largest_curvature, std::abs(bend));
  }
  deviation.curvature = std::sqrt(deviation.curvature);
  return deviation;
}

TEST(InterpolatingSpline, CurvePassesSmoothlyThroughThePoints)
{
  const std::vector<SampledPoint> points = sample(rail60E1(), 0.7 * mm, 0.0);
  const Profile curve("spline", interpolatingSpline(points));
  ASSERT_EQ(curve.discontinuities().size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double u = curve.discontinuities()[i];
    const CurvePoint after = curve.at(u);
    EXPECT_NEAR(after.y, points[i].y, 1e-16);
    EXPECT_NEAR(after.z, points[i].z, 1e-16);
    const CurvePoint before = curve.at(std::nextafter(u, 0.0));
    EXPECT_NEAR(after.dy, before.dy, 1e-12);
    EXPECT_NEAR(after.dz, before.dz, 1e-12);
    EXPECT_NEAR(after.ddy, before.ddy, 1e-9);
    EXPECT_NEAR(after.ddz, before.ddz, 1e-9);
  }
}

TEST(InterpolatingSpline, StraightLineIsReproduced)
{
  const std::vector<SampledPoint> points = {{0.0, 0.0}, {0.003, 0.004}, {0.006, 0.008}, {0.0066, 0.0088}, {0.03, 0.04}};
  const Profile curve("line", interpolatingSpline(points));
  EXPECT_NEAR(curve.length(), 0.05, 1e-16);
  for (const double u : {0.001, 0.012, 0.04})
  {
    EXPECT_NEAR(curve.at(u).y, 0.6 * u, 1e-17);
    EXPECT_NEAR(curve.at(u).z, 0.8 * u, 1e-17);
    EXPECT_NEAR(curve.at(u).curvature(), 0.0, 1e-10);
  }
}

TEST(InterpolatingSpline, StandardProfilesAreReproduced)
{
  // At a distance of 2 mm (eight points) or more from the curvature discontinuities, the fourth-order error of the
  // spline is 1e-7 mm.
  const Profile rail = rail60E1();
  const Profile rail_spline("rail", interpolatingSpline(sample(rail, 0.25 * mm, 0.0)));
  const double rail_arcs[][2] = {{-35.3, -27.5}, {-24.0, -12.3}, {-8.1, 8.1}, {12.3, 24.0}, {27.5, 35.3}};
  for (const auto& arc : rail_arcs)
  {
    const Deviation deviation = compare(rail, rail_spline, arc[0] * mm, arc[1] * mm);
    const double curvature = std::abs(rail.at(parameterAt(rail, arc[0] * mm)).curvature());
    EXPECT_LT(deviation.value, 1e-7 * mm);
    EXPECT_LT(deviation.largest_curvature, 0.001 * curvature);
  }
  EXPECT_LT(compare(rail, rail_spline, -36.0 * mm, 36.0 * mm).value, 2e-4 * mm);

  const Profile wheel = s1002Wheel();
  const Profile wheel_spline("wheel", interpolatingSpline(sample(wheel, 0.25 * mm, 0.0)));
  EXPECT_LT(compare(wheel, wheel_spline, -24.0 * mm, 30.0 * mm).value, 1e-7 * mm);
  EXPECT_LT(compare(wheel, wheel_spline, -24.0 * mm, 30.0 * mm).largest_curvature, 0.02);
  // This range contains the step of 1.2e-4 mm at y = -35 mm that is in the standard.
  EXPECT_LT(compare(wheel, wheel_spline, -60.0 * mm, 58.0 * mm).value, 2e-4 * mm);
}

TEST(InterpolatingSpline, ErrorDecreasesWithTheFourthPowerOfTheSpacing)
{
  // Largest deviation from the radius of a circle, away from the ends. The leading term of the error is h^4 / R^3.
  const double radius = 13.0 * mm;
  const Profile circle("circle", {{ArcSection{0.0, 0.0, radius, 2.5, -1.0}, 25.0 * mm}});
  const auto error = [&](double spacing)
  {
    const Profile curve("spline", interpolatingSpline(sample(circle, spacing, 0.0)));
    double largest = 0.0;
    for (double u = 0.4 * curve.length(); u < 0.6 * curve.length(); u += 0.01 * mm)
    {
      largest = std::max(largest, std::abs(std::hypot(curve.at(u).y, curve.at(u).z) - radius));
    }
    return largest;
  };
  EXPECT_NEAR(error(0.4 * mm) / error(0.2 * mm), 16.0, 1.0);
}

TEST(SmoothingSpline, ShapeAndCurvatureOfNoisyProfilesAreReproduced)
{
  SCOPED_TRACE("seed " + std::to_string(point_seed));
  struct Range
  {
    double y_from, y_to;  ///< [mm]
    double value;         ///< largest deviation divided by the noise [-]
    double curvature;     ///< r.m.s. deviation [1/m]
  };
  // Ranges: crown (3.3 1/m), shoulder (12.5 1/m) and corner (77 1/m) of the rail; tread (3.3 1/m) and flange root
  // (77 1/m) of the wheel. Measured r.m.s. deviations of the curvature at 2 to 10 um of noise [1/m]: 0.28 to 0.59, 0.61
  // to 0.80, 1.7 to 3.2; 0.07 to 0.09, 1.1 to 1.5.
  const Range rail_ranges[] = {{-9.0, 9.0, 1.0, 0.8}, {-24.0, -12.0, 1.0, 1.0}, {-34.5, -27.5, 1.2, 4.0}};
  const Range wheel_ranges[] = {{-15.0, 15.0, 0.6, 0.15}, {-37.0, -28.0, 1.0, 2.0}};
  const Profile rail = rail60E1();
  const Profile wheel = s1002Wheel();
  for (const double noise : {2e-6, 5e-6, 10e-6})
  {
    const Profile rail_spline("rail", smoothingSpline(sample(rail, 0.25 * mm, noise), noise));
    for (const Range& range : rail_ranges)
    {
      const Deviation deviation = compare(rail, rail_spline, range.y_from * mm, range.y_to * mm);
      EXPECT_LT(deviation.value, range.value * noise);
      EXPECT_LT(deviation.curvature, range.curvature);
    }
    const Profile wheel_spline("wheel", smoothingSpline(sample(wheel, 0.25 * mm, noise), noise));
    for (const Range& range : wheel_ranges)
    {
      const Deviation deviation = compare(wheel, wheel_spline, range.y_from * mm, range.y_to * mm);
      EXPECT_LT(deviation.value, range.value * noise);
      EXPECT_LT(deviation.curvature, range.curvature);
    }
  }
}

TEST(SmoothingSpline, KinkLeavesTheCurveElsewhereSmooth)
{
  const double noise = 2e-6;
  std::vector<SampledPoint> points = sample(rail60E1(), 0.25 * mm, noise);
  const SampledPoint end = points.back();
  for (int i = 1; i <= 40; ++i)  // a chamfer of 10 mm at the lower corner of the head
  {
    points.push_back({end.y - 0.2 * mm * i, end.z - 0.15 * mm * i});
  }
  // As without the chamfer. A single penalty for the whole curve gives 23 1/m.
  EXPECT_LT(compare(rail60E1(), Profile("rail", smoothingSpline(points, noise)), -9.0 * mm, 9.0 * mm).curvature, 0.8);
}

TEST(SmoothingSpline, CurvatureIsMoreAccurateThanThatOfTheInterpolatingSpline)
{
  const Profile rail = rail60E1();
  const std::vector<SampledPoint> points = sample(rail, 0.25 * mm, 5e-6);
  const Profile through("through", interpolatingSpline(points));
  const Profile near("near", smoothingSpline(points, 5e-6));
  EXPECT_GT(compare(rail, through, -9.0 * mm, 9.0 * mm).curvature,
            100.0 * compare(rail, near, -9.0 * mm, 9.0 * mm).curvature);
}

TEST(SmoothingSpline, DeviationFromThePointsEqualsTheNoise)
{
  const double noise = 4e-6;
  const std::vector<SampledPoint> points = sample(s1002Wheel(), 0.3 * mm, noise);
  const Profile curve("wheel", smoothingSpline(points, noise));
  double u = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    u += i > 0 ? std::hypot(points[i].y - points[i - 1].y, points[i].z - points[i - 1].z) : 0.0;
    sum += std::pow(curve.at(u).y - points[i].y, 2) + std::pow(curve.at(u).z - points[i].z, 2);
  }
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(points.size())), noise, 1e-5 * noise);
}

TEST(SmoothingSpline, CurveRotatesAndMovesWithThePoints)
{
  const std::vector<SampledPoint> points = sample(rail60E1(), 0.3 * mm, 3e-6);
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  std::vector<SampledPoint> moved;
  for (const SampledPoint& p : points)
  {
    moved.push_back({c * p.y - s * p.z + 0.04, s * p.y + c * p.z - 0.07, 5.0});
  }
  const Profile here("here", smoothingSpline(points, 3e-6));
  const Profile there("there", smoothingSpline(moved, 3e-6));
  for (int i = 0; i <= 50; ++i)
  {
    const double share = i / 50.0;
    const CurvePoint p = here.at(share * here.length());
    const CurvePoint q = there.at(share * there.length());
    EXPECT_NEAR(q.y, c * p.y - s * p.z + 0.04, 1e-11);
    EXPECT_NEAR(q.z, s * p.y + c * p.z - 0.07, 1e-11);
    EXPECT_NEAR(q.curvature(), p.curvature(), 1e-4);
  }
}

TEST(SmoothingSpline, PointsOfLittleWeightHaveLittleInfluence)
{
  std::vector<SampledPoint> points = sample(rail60E1(), 0.25 * mm, 0.0);
  SampledPoint& outlier = points[points.size() / 2];
  outlier.z += 0.05 * mm;
  const Profile disturbed("disturbed", smoothingSpline(points, 1e-6));
  outlier.weight = 1e-6;
  const Profile relieved("relieved", smoothingSpline(points, 1e-6));
  EXPECT_GT(compare(rail60E1(), disturbed, -3.0 * mm, 3.0 * mm).value, 5e-6);
  EXPECT_LT(compare(rail60E1(), relieved, -3.0 * mm, 3.0 * mm).value, 1e-6);
}

TEST(Splines, InvalidInputIsRejected)
{
  const std::vector<SampledPoint> good = {{0.0, 0.0}, {0.01, 0.001}, {0.02, 0.0}, {0.03, -0.001}};
  EXPECT_NO_THROW(interpolatingSpline(good));
  EXPECT_NO_THROW(smoothingSpline(good, max_spline_noise));
  EXPECT_THROW(smoothingSpline(good, 0.0), std::invalid_argument);
  EXPECT_THROW(smoothingSpline(good, -1e-6), std::invalid_argument);
  EXPECT_THROW(smoothingSpline(good, 2.0 * max_spline_noise), std::invalid_argument);
  EXPECT_THROW(smoothingSpline(good, std::nan("")), std::invalid_argument);

  std::vector<std::vector<SampledPoint>> bad(6, good);
  bad[0].resize(3);
  bad[1][2] = bad[1][1];
  bad[2][1].y = std::nan("");
  bad[3][1].z = std::numeric_limits<double>::infinity();
  bad[4][2].weight = 0.0;
  bad[5][3].y = 20.0;
  for (const std::vector<SampledPoint>& points : bad)
  {
    EXPECT_THROW(interpolatingSpline(points), std::invalid_argument);
    EXPECT_THROW(smoothingSpline(points, 1e-6), std::invalid_argument);
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
