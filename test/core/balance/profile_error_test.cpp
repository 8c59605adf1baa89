// SPDX-License-Identifier: BSD-3-Clause
// Results with profiles from files: what noise and missing points leave open.
#include "core/balance/patch_result.h"
#include "round_bodies.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double mm = 1e-3;  ///< [m]
constexpr unsigned seed = 43;

/// Points of a profile for a file.
struct Sampling
{
  double noise = 0;                    ///< standard deviation across the curve [m]
  int decimals = 6;                    ///< of the coordinates in mm
  double gap_first = 0, gap_last = 0;  ///< range of y of the crown in which points are missing [m]
};

/// Profile that is written to a table every 0.25 mm, and read.
std::shared_ptr<const Profile> readBack(const Profile& profile, ProfileKind kind, const Sampling& sampling,
                                        const ProfileReading& reading = {})
{
  const std::string path = testing::TempDir() + "profile_error.csv";
  std::ofstream file(path);
  file << "y_mm,z_mm\n";
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  for (double u = 0; u < profile.length(); u += 0.25 * mm)
  {
    const CurvePoint p = profile.at(u);
    const double across = sampling.noise * normal(random) / std::hypot(p.dy, p.dz);
    char row[100];
    std::snprintf(row, sizeof row, "%.*f,%.*f\n", sampling.decimals, (p.y - across * p.dz) / mm, sampling.decimals,
                  (p.z + across * p.dy) / mm);
    if (!(p.z > -14 * mm && p.y > sampling.gap_first && p.y < sampling.gap_last))
    {
      file << row;
    }
  }
  file.close();
  return std::make_shared<const Profile>(readProfile(path, kind, reading));
}

ContactModelConfig standards()
{
  ContactModelConfig config;
  config.wheel_profile = std::make_shared<const Profile>(s1002Wheel());
  config.rail_profile = std::make_shared<const Profile>(rail60E1());
  return config;
}

/// Patch of a side with the largest force.
const PatchResult& mainPatch(const WheelsetResult& result, Side side)
{
  const auto less = [side](const PatchResult& a, const PatchResult& b)
  { return (a.side == side ? a.normal_force : 0) < (b.side == side ? b.normal_force : 0); };
  return *std::max_element(result.patches.begin(), result.patches.end(), less);
}
}  // namespace

// A laser loses the shiny running band: 12 mm of the left rail, 1.435 m apart at 14 mm below the top.
TEST(MissingPointsTest, ContactWherePointsAreMissingIsReported)
{
  ContactModelConfig config = standards();
  config.rail_profile.left = readBack(rail60E1(), ProfileKind::rail, {0, 6, -12 * mm, 0});
  WheelsetContact contact(config);
  const WheelsetResult& result = okResult(contact, stateAt(0, 1e5));
  EXPECT_TRUE(result.points_missing);
  EXPECT_EQ(result.reason, "points of a profile are missing at a contact: its shape is not known there");
  EXPECT_GE(mainPatch(result, Side::left).error_estimate, 1);
  EXPECT_LT(mainPatch(result, Side::right).error_estimate, 0.1);
}

TEST(MissingPointsTest, ContactBesideThemIsNotReported)
{
  ContactModelConfig config = standards();
  config.rail_profile = readBack(rail60E1(), ProfileKind::rail, {0, 6, 12 * mm, 24 * mm});
  WheelsetContact contact(config), exact(standards());
  const WheelsetResult& result = okResult(contact, stateAt(0, 1e5));
  EXPECT_FALSE(result.points_missing);
  EXPECT_TRUE(result.reason.empty()) << result.reason;
  const double pressure = mainPatch(exact.evaluate(stateAt(0, 1e5)), Side::left).max_pressure;
  EXPECT_NEAR(mainPatch(result, Side::left).max_pressure / pressure, 1, 0.02);
}

// Three decimals of a millimetre move the unsmoothed pressure by up to 30 %: the estimate must contain this.
TEST(ShapeEffectTest, CoversWhatNoiseDoesToThePressure)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  ProfileReading unsmoothed;
  unsmoothed.smoothing = 0;
  struct Case
  {
    Sampling sampling;
    ProfileReading reading;
    double least, most;  ///< of the largest error
  };
  const Case cases[] = {{{0, 3}, unsmoothed, 0.1, 0.5}, {{0, 3}, {}, 0, 0.08}, {{5e-6, 6}, {}, 0, 0.3}};
  for (const Case& item : cases)
  {
    ContactModelConfig config = standards();
    config.rail_profile = readBack(rail60E1(), ProfileKind::rail, item.sampling, item.reading);
    config.wheel_profile = readBack(s1002Wheel(), ProfileKind::wheel, item.sampling, item.reading);
    WheelsetContact contact(config), exact(standards());
    double largest = 0;
    int outside = 0, count = 0;
    for (double y = -4 * mm; y <= 4 * mm; y += 0.5 * mm)
    {
      for (const Side side : sides)
      {
        const PatchResult patch = mainPatch(contact.evaluate(stateAt(y, 1e5)), side);
        const double error =
            std::abs(patch.max_pressure / mainPatch(exact.evaluate(stateAt(y, 1e5)), side).max_pressure - 1);
        largest = std::max(largest, error);
        outside += error > 1.5 * patch.error_estimate ? 1 : 0;
        ++count;
      }
    }
    EXPECT_GT(largest, item.least) << "the case must show an error";
    EXPECT_LT(largest, item.most);
    EXPECT_LE(outside, count / 20) << "of " << count;
  }
}

TEST(ShapeEffectTest, IsNothingForStandardProfiles)
{
  WheelsetContact contact(standards());
  for (const PatchResult& patch : contact.evaluate(stateAt(0, 1e5)).patches)
  {
    EXPECT_LE(patch.error_estimate, contact.config().contact.tolerance);
  }
}

TEST(ModelError, GrowsWithTheRatioAndIsLargerForParallelNormals)
{
  double turned = 0, parallel = 0;
  for (const double ratio : {0.0, 0.1, 0.2, 0.4, 0.5})
  {
    EXPECT_GT(modelError(ratio, true), turned);
    EXPECT_GT(modelError(ratio, false), parallel);
    turned = modelError(ratio, true);
    parallel = modelError(ratio, false);
    EXPECT_GE(parallel, turned);
  }
  EXPECT_EQ(modelError(0.6, true), 1) << "beyond the contacts that were compared";
  EXPECT_EQ(modelError(std::nan(""), true), 1);
}

// A cylinder or cone on one arc is a Hertz contact. Required accuracy of pressure and approach: 0.1 %. The mesh of 128²
// cells adds 2 * (1 / 116)² = 1.5e-4 to the pressure (curvature of the ellipsoid's top over a cell), and less to the
// approach. The area is determined to a fraction of a cell along its edge: 0.5 %.
TEST(HertzChainTest, ConesOnAnArcHaveThePressureAndApproachOfHertz)
{
  for (const double slope : {0.0, 0.025, 0.05})
  {
    ContactModelConfig scene = round_bodies::scene(slope);
    scene.contact = {NormalMethod::conjugate_gradient, 0.01, 128, 128};
    WheelsetContact contact(scene);
    const double load = 1e5;
    const WheelsetResult& result = okResult(contact, stateAt(0, load));
    ASSERT_EQ(result.patches.size(), 2U);
    const PatchResult& patch = result.patches.front();
    EXPECT_NEAR(patch.contact_angle, std::atan(slope), 1e-4);

    const HertzContact hertz = round_bodies::exactContact(scene, slope, 0, load);
    EXPECT_NEAR(patch.normal_force, load * std::hypot(1, slope), 1e-4 * load);
    // Half-width over the radius of the rail. The centres of the outermost of the 116 loaded columns lie within one
    // cell of the edge.
    EXPECT_NEAR(patch.half_space_ratio, hertz.semi_axis_y / round_bodies::crown_radius,
                0.02 * hertz.semi_axis_y / round_bodies::crown_radius);
    EXPECT_EQ(patch.model_error, modelError(patch.half_space_ratio, false));  // the normals turn by less than 0.2 rad
    EXPECT_NEAR(patch.max_pressure, hertz.max_pressure, 1.15e-3 * hertz.max_pressure);
    EXPECT_NEAR(patch.approach, hertz.approach, 1e-3 * hertz.approach);
    EXPECT_NEAR(patch.area, hertz.area, 5e-3 * hertz.area);
    if (slope == 0)  // a cylinder touches the crown at its rolling radius: the axle moves down by the approach
    {
      EXPECT_NEAR(scene.wheelset.rolling_radius.left - result.z, hertz.approach, 1e-3 * hertz.approach);
    }
  }
}
