// SPDX-License-Identifier: BSD-3-Clause
// Noise of the points of a file, and points that are missing.
#include "core/profile/noise/noise.h"
#include "profile_helpers.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr unsigned seed = 43;

/// Points of a profile, displaced across it by normal noise [m].
std::vector<SampledPoint> noisy(const Profile& profile, double noise, double spacing)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<SampledPoint> points;
  for (double u = 0; u <= profile.length(); u += spacing)
  {
    const CurvePoint p = profile.at(u);
    const double across = noise * normal(random), length = std::hypot(p.dy, p.dz);
    points.push_back({p.y - across * p.dz / length, p.z + across * p.dy / length});
  }
  return points;
}

/// Text of a table in mm with a number of decimals.
std::string table(const std::vector<SampledPoint>& points, int decimals)
{
  std::string text = "y_mm,z_mm\n";
  for (const SampledPoint& p : points)
  {
    char row[100];
    std::snprintf(row, sizeof row, "%.*f,%.*f\n", decimals, 1e3 * p.y, decimals, 1e3 * p.z);
    text += row;
  }
  return text;
}

/// Rail that is read from a table of points in mm.
DescribedProfile railOf(const std::vector<SampledPoint>& points, int decimals, const ProfileReading& reading = {})
{
  return describedProfile(Folder().write("rail.csv", table(points, decimals)), ProfileKind::rail, reading);
}

/// Largest deviation of the curvature on the crown of a rail, |y| < 8 mm, from that of 60E1 [1/m].
double crownError(const Profile& profile)
{
  double largest = 0;
  for (double y = -8 * mm; y <= 8 * mm; y += 0.1 * mm)
  {
    largest = std::max(largest, std::abs(profile.at(parameterAt(profile, y)).curvature() + 1 / 0.3));
  }
  return largest;
}

/// Points without those in a range of y [m].
std::vector<SampledPoint> without(std::vector<SampledPoint> points, double y_first, double y_last)
{
  points.erase(std::remove_if(points.begin(), points.end(),
                              [=](const SampledPoint& p) { return p.y > y_first && p.y < y_last && p.z > -0.014; }),
               points.end());
  return points;
}
}  // namespace

TEST(NoiseEstimate, IsThatOfThePoints)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const Profile& profile : {rail60E1(), s1002Wheel()})
  {
    for (const double spacing : {0.1 * mm, 0.25 * mm, 0.5 * mm})
    {
      for (const double noise : {1e-7, 1e-6, 5e-6, 2e-5})
      {
        // The largest of 2 to 20 medians of 60 residuals, each of which is known within 25 % (2 standard deviations).
        const double estimate = estimatedNoise(noisy(profile, noise, spacing)).value().largest;
        EXPECT_GT(estimate, 0.9 * noise) << profile.name() << ", " << spacing << " m";
        EXPECT_LT(estimate, 2.2 * noise) << profile.name() << ", " << spacing << " m";
      }
      EXPECT_LT(estimatedNoise(noisy(profile, 0, spacing)).value().largest, 2e-8) << "corners are no noise";
    }
  }
}

/// Largest noise that is found in a rail whose heights have noise [m] up to a distance from its middle [m].
double noiseOfHeights(double noise, double reach)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, noise);
  std::vector<SampledPoint> points = noisy(rail60E1(), 0, 0.25 * mm);
  for (SampledPoint& p : points)
  {
    p.z += std::abs(p.y) < reach ? normal(random) : 0;
  }
  return estimatedNoise(points).value().largest;
}

TEST(NoiseEstimate, OfAPartIsThatOfThisPartAndOfFewPointsIsNotKnown)
{
  EXPECT_NEAR(noiseOfHeights(4e-6, 1), 5e-6, 1.5e-6) << "seed " << seed;
  // A scanner may see a worn and shiny running band less well than the rest.
  EXPECT_NEAR(noiseOfHeights(5e-6, 12 * mm), 5e-6, 2e-6) << "seed " << seed;
  EXPECT_FALSE(estimatedNoise(noisy(rail60E1(), 0, 12 * mm)).has_value());
}

TEST(NoiseEstimate, CountsTheDigitsOfAFile)
{
  // Rounding to a multiple of q has the standard deviation q/sqrt(12): 2.9 um for 2 decimals.
  const std::pair<int, double> cases[] = {{2, 2.88e-6}, {3, 0.288e-6}, {4, 0.0288e-6}};
  for (const auto& [decimals, noise] : cases)
  {
    const ProfileReport report = railOf(noisy(rail60E1(), 0, 0.3 * mm), decimals).report;
    EXPECT_GT(report.noise.value(), noise) << decimals << " decimals";
    EXPECT_LT(report.noise.value(), 2 * noise) << decimals << " decimals";
    EXPECT_EQ(report.smoothing, decimals == 4 ? 0 : report.noise);
  }
  // Steps of many points with the same rounded height are not taken for a smooth curve, nor a few points for exact
  // ones.
  for (const double spacing : {0.06 * mm, 12 * mm})
  {
    EXPECT_GE(railOf(noisy(rail60E1(), 0, spacing), 2).report.noise.value(), 2.88e-6) << spacing;
  }
  // 0.001 in.
  std::string inches = "y_in,z_in\n";
  for (const SampledPoint& p : noisy(rail60E1(), 0, 0.5 * mm))
  {
    char row[100];
    std::snprintf(row, sizeof row, "%.3f,%.3f\n", p.y / 0.0254, p.z / 0.0254);
    inches += row;
  }
  const ProfileReport report = describedProfile(Folder().write("rail.csv", inches), ProfileKind::rail).report;
  EXPECT_GT(report.smoothing, 7.3e-6);
  EXPECT_LT(report.smoothing, 14e-6);
  // Whole millimetres do not determine a curvature.
  EXPECT_THROW(railOf(noisy(rail60E1(), 0, 1 * mm), 0), FileError);
}

TEST(Smoothing, IsEstimatedUnlessStated)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::vector<SampledPoint> points = noisy(rail60E1(), 5e-6, 0.25 * mm);
  ProfileReading reading;
  const DescribedProfile estimated = railOf(points, 6);
  EXPECT_NEAR(estimated.report.smoothing, 6e-6, 1.5e-6);
  EXPECT_LT(crownError(estimated.profile), 2.0);
  reading.smoothing = 0;
  const DescribedProfile none = railOf(points, 6, reading);
  EXPECT_GT(crownError(none.profile), 100);
  EXPECT_NEAR(none.report.noise.value(), 6e-6, 1.5e-6) << "reported all the same";
  reading.smoothing = 20e-6;
  EXPECT_EQ(railOf(points, 6, reading).report.smoothing, 20e-6);
}

TEST(Smoothing, AveragesACloudOfPoints)
{
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 20e-6);
  const Folder folder;
  for (const bool wheel : {false, true})
  {
    const Profile profile = wheel ? s1002Wheel() : rail60E1();
    std::vector<Point> cloud;
    for (int i = 0; i < 25000; ++i)
    {
      const CurvePoint p = profile.at(std::uniform_real_distribution<double>(0, profile.length())(random));
      cloud.push_back({p.y + noise(random), p.z + noise(random)});
    }
    const DescribedProfile read =
        describedProfile(folder.write("cloud.csv", csv(cloud)), wheel ? ProfileKind::wheel : ProfileKind::rail);
    EXPECT_TRUE(contains(read.report.text, "25000 points, in any order, averaged over 0.1 mm"));
    EXPECT_LT(*read.report.noise, 15e-6);          // 17 points in a mean: 5 um, in the noisiest stretch more
    std::vector<Point> inner = pointsOf(profile);  // the ends are where the last points are
    inner.erase(inner.begin(), inner.begin() + 8);
    inner.resize(inner.size() - 8);
    EXPECT_LT(deviation(read.profile, inner), 20e-6);
  }
  // A head beside the lip of its groove, which is 40 mm deep, and two strokes 3 mm apart.
  const Profile head = rail60E1();
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Point> grooved, twice;
  for (int i = 0; i < 22000; ++i)
  {
    const CurvePoint p = head.at(head.length() * share(random));
    const double s = 92.8e-3 * share(random);  // along lip, wall and floor
    twice.push_back({p.y, p.z - (i % 2) * 3e-3});
    grooved.push_back(i % 2 == 0  ? Point{p.y, p.z}
                      : s < 20e-3 ? Point{s - 90e-3, 0}
                      : s < 60e-3 ? Point{-70e-3, 20e-3 - s}
                                  : Point{s - 130e-3, -40e-3});
  }
  const DescribedProfile running = describedProfile(folder.write("grooved.csv", csv(grooved)), ProfileKind::rail);
  EXPECT_TRUE(contains(running.report.text, "omitted what lies beside the head"));
  std::vector<Point> crown = pointsOf(head);
  crown.erase(std::remove_if(crown.begin(), crown.end(), [](const Point& p) { return p.z < -12e-3; }), crown.end());
  EXPECT_LT(deviation(running.profile, crown), 20e-6);
  EXPECT_THROW(readProfile(folder.write("twice.csv", csv(twice)), ProfileKind::rail), FileError);
}

TEST(ShapeError, CoversTheErrorOfTheCurvature)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const double noise : {1e-6, 5e-6})
  {
    const Profile profile = railOf(noisy(rail60E1(), noise, 0.25 * mm), 6).profile;
    const Profile exact = rail60E1();
    int outside = 0, places = 0;
    for (double y = -34 * mm; y <= 34 * mm; y += 0.5 * mm)
    {
      const double u = parameterAt(profile, y);
      const double error = profile.at(u).curvature() - exact.at(parameterAt(exact, y)).curvature();
      outside += std::abs(error) > 2 * profile.errorAt(u).curvature ? 1 : 0;
      ++places;
    }
    // Errors within two standard deviations: 95 %. Neighbouring places are not independent.
    EXPECT_LE(outside, places / 10) << noise;
  }
}

TEST(ShapeError, IsZeroForStandardProfiles)
{
  const ShapeError error = s1002Wheel().errorWithin(0, s1002Wheel().length());
  EXPECT_EQ(error.position, 0);
  EXPECT_EQ(error.curvature, 0);
  EXPECT_FALSE(error.missing);
}

// The second derivative of an interpolating spline on equal sections has 6 times the noise over h².
TEST(ShapeError, OfAnInterpolationIsThatOfItsNoise)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  const double spacing = 0.5 * mm;
  const Profile profile = railOf(noisy(rail60E1(), 1e-6, spacing), 6, {0.0}).profile;
  double squares = 0;
  int places = 0;
  for (const double u : profile.discontinuities())
  {
    const CurvePoint p = profile.at(u);
    if (std::abs(p.y) < 9 * mm)
    {
      squares += std::pow(p.curvature() + 1 / 0.3, 2);
      ++places;
    }
  }
  const double error = profile.errorAt(parameterAt(profile, 0)).curvature;
  EXPECT_NEAR(std::sqrt(squares / places), error, 0.4 * error) << places << " places";
  EXPECT_NEAR(error, 6 * 1e-6 / (spacing * spacing), 0.3 * error);
}

TEST(MissingPoints, AreKnownByTheDistancesOfTheFile)
{
  const DescribedProfile read = railOf(without(noisy(rail60E1(), 0, 0.2 * mm), -10 * mm, 2 * mm), 6);
  EXPECT_TRUE(read.profile.errorAt(parameterAt(read.profile, -4 * mm)).missing);
  EXPECT_FALSE(read.profile.errorAt(parameterAt(read.profile, -11 * mm)).missing);
  EXPECT_FALSE(read.profile.errorAt(parameterAt(read.profile, 3 * mm)).missing);
  EXPECT_NE(read.report.text.find("points missing over 12."), std::string::npos) << read.report.text;
  EXPECT_NE(read.report.text.find(" mm from y = -10"), std::string::npos) << read.report.text;
}

TEST(MissingPoints, AreFoundInSmoothedProfiles)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  const Profile read = railOf(without(noisy(rail60E1(), 2e-6, 0.2 * mm), -10 * mm, 2 * mm), 6).profile;
  EXPECT_TRUE(read.errorAt(parameterAt(read, -4 * mm)).missing);
  EXPECT_FALSE(read.errorAt(parameterAt(read, 5 * mm)).missing);
}

// A drawing gives a straight line by its ends. A tread that a laser did not see may be hollow.
TEST(MissingPoints, OfAStraightLineAreThoseOfAMeasurement)
{
  const Folder folder;
  std::vector<SampledPoint> wheel = noisy(s1002Wheel(), 0, 0.2 * mm);
  wheel.erase(
      std::remove_if(wheel.begin(), wheel.end(), [](const SampledPoint& p) { return p.y > 36 * mm && p.y < 55 * mm; }),
      wheel.end());
  const std::string path = folder.write("wheel.csv", table(wheel, 9));
  const Profile measured = readProfile(path, ProfileKind::wheel), drawn = readProfile(path, ProfileKind::wheel, {0.0});
  EXPECT_TRUE(measured.errorAt(parameterAt(measured, 45 * mm)).missing);
  EXPECT_FALSE(drawn.errorWithin(0, drawn.length()).missing);
}

TEST(MissingPoints, AreThoseOfAFileThatIsTooCoarseUnlessItIsEvenlyCoarse)
{
  const Profile read = railOf(noisy(rail60E1(), 0, 6 * mm), 9).profile;
  EXPECT_TRUE(read.errorAt(parameterAt(read, 0)).missing);
  const Profile even = railOf(noisy(rail60E1(), 0, 3 * mm), 9).profile;
  EXPECT_FALSE(even.errorWithin(0, even.length()).missing);
}

// One bad point makes a peak of the pressure. Corners of the profile, and a kink, are no bad points.
TEST(Outliers, AreOmittedAndReported)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const double noise : {0.0, 2e-6})
  {
    for (const double spacing : {0.05 * mm, 0.25 * mm, 1 * mm})
    {
      for (const std::size_t count : {1, 2})
      {
        std::vector<SampledPoint> points = noisy(rail60E1(), noise, spacing);
        const auto at = static_cast<std::size_t>(
            std::find_if(points.begin(), points.end(), [](const SampledPoint& p) { return p.y > -1 * mm; }) -
            points.begin());
        for (std::size_t k = 0; k < count; ++k)
        {
          points[at + k].z += k == 0 ? 0.1 * mm : -0.1 * mm;
        }
        const DescribedProfile read = railOf(points, 7);
        const std::string what = std::to_string(count) + " points, noise " + std::to_string(noise * 1e6) +
                                 " um, spacing " + std::to_string(spacing / mm) + " mm: " + read.report.text;
        EXPECT_NE(read.report.text.find("off the curve of the neighbours"), std::string::npos) << what;
        EXPECT_LT(crownError(read.profile), noise == 0 ? 0.5 : 2.5) << what;
      }
    }
  }
}

TEST(Outliers, AreNotFoundOnStandardProfiles)
{
  for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail})
  {
    for (const std::string& name : standardProfileNames(kind))
    {
      const Profile profile = loadProfile(name, kind);
      for (const double spacing : {0.05 * mm, 0.25 * mm, 1 * mm})
      {
        const Folder folder;
        const ProfileReport report =
            describedProfile(folder.write("profile.csv", table(noisy(profile, 0, spacing), 7)), kind).report;
        EXPECT_EQ(report.remark, "") << name << ", " << spacing / mm << " mm";
      }
    }
  }
}

TEST(Outliers, ThatAreManyAreRefused)
{
  std::vector<SampledPoint> points = noisy(rail60E1(), 0, 0.25 * mm);
  for (std::size_t i = 20; i < points.size() - 20; i += 25)
  {
    points[i].z += 0.05 * mm;
  }
  EXPECT_THROW(railOf(points, 7), FileError);
}
}  // namespace wheel_rail_contact::core
