// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/placement.h"

#include <Eigen/Geometry>

#include "../../manchester_scene.h"
#include "../../refusal.h"
#include "../../seeded.h"
#include "core/track/contact_search.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double rounding = 1e-14;  ///< rounding error of sums of lengths below 1 m [m]

/// Highest and innermost point of a placed rail, from dense samples.
struct RailSamples
{
  explicit RailSamples(const PlacedRail& rail, double gauge_depth = 0.014)
  {
    const int count = 400000;
    for (int i = 0; i <= count; ++i)
    {
      const PlanePoint point = rail.at(rail.profile().length() * i / count);
      top = std::max(top, point.z);
      gauge_side = point.z >= -gauge_depth ? std::min(gauge_side, point.y) : gauge_side;
    }
  }
  double top = -std::numeric_limits<double>::infinity();        ///< z of the highest point [m]
  double gauge_side = std::numeric_limits<double>::infinity();  ///< y of the innermost point above the gauge depth [m]
};

Eigen::Vector3d axleDirection(const WheelsetPose& pose)
{
  return Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()) *
         (Eigen::AngleAxisd(pose.roll, Eigen::Vector3d::UnitX()) * Eigen::Vector3d::UnitY());
}

class PlacementTest : public testing::Test
{
 protected:
  /// Small pose, with height. The yaw is at most 0.06 rad: the contact locus then exists up to slopes of 1/tan(0.06) =
  /// 17, far above that of the flank of S1002 (70 degrees).
  WheelsetPose randomPose()
  {
    return {0.02 * random_.unit(), 0.46 + 0.01 * random_.unit(), 0.06 * random_.unit(), 0.05 * random_.unit()};
  }

  Seeded random_{20111U};
  ContactModelConfig scene_ = manchesterScene();
};

// Values of the benchmark: the origin of the rail file is 760.53145 mm from the track centre, the crown in the file at
// -7.4917 mm. First touch is 0.18213 mm above the height at which the running circle is in the plane of the rail tops
// (the reference code CONTACT prints 0.1821), at -7.28 mm on the rail and +3.25 mm on the wheel. The rails are inclined
// by exactly 1:40.
TEST_F(PlacementTest, FirstTouchOfTheManchesterBenchmarkAgreesWithTheReference)
{
  scene_.track.rail_inclination = std::atan(1.0 / 40);
  const PlacedRail rail(scene_.rail_profile.left, scene_.track, Side::left);
  const PlanePoint crown = rail.place({0, 0, 1, 0, 0, 0});
  // 2 um: the reference measures the gauge on the samples of the file, connected by chords up to 1 um inside the R13
  // arc.
  EXPECT_NEAR(crown.y, (760.53145 - 7.4917) * 1e-3, 2e-6);
  EXPECT_NEAR(crown.z, -0.0937e-3, 0.00005e-3);  // all printed digits

  ContactSearch search(*scene_.wheel_profile.left, *scene_.rail_profile.left);
  search.setRail(rail);
  search.setWheel(
      {*scene_.wheel_profile.left, scene_.wheelset, Side::left, {0, scene_.wheelset.rolling_radius.left, 0, 0}});
  InitialContact touch;
  ASSERT_TRUE(search.nearest(touch));
  EXPECT_NEAR(touch.separation, 0.18213e-3, 0.00001e-3);  // all printed digits
  // 5 um: the printed positions have two decimals in mm; plus the 2 um above.
  EXPECT_NEAR(touch.y, (760.53145 - 7.28) * 1e-3, 7e-6);
  EXPECT_NEAR(scene_.wheel_profile.left->at(touch.wheel_u).y, 3.25e-3, 7e-6);
}

TEST_F(PlacementTest, RailTopsAreInTheTrackPlaneAndGaugeFacesAtGauge)
{
  for (const double gauge : {1.42, 1.435, 1.47})
  {
    for (const double inclination : {0.0, 0.025, 0.05})
    {
      const PlacedRail rail(std::make_shared<Profile>(rail60E1()), {gauge, 0.014, inclination}, Side::left);
      const RailSamples samples(rail);
      // Error of samples 0.5 um apart: 1e-16 m at the top of R300, 0.5 um / 20 at a gauge point on the 1:20 side.
      EXPECT_NEAR(samples.top, 0, 1e-12);
      EXPECT_NEAR(samples.gauge_side, 0.5 * gauge, 3e-8);
      EXPECT_NEAR(rail.angle(), inclination, rounding);
    }
  }
}

// By hand: at 14.3 mm below the crown, the side of 60E1 is 35.9998 mm from the axis. The side of an upright rail is
// nearly vertical (1:20).
TEST_F(PlacementTest, AxisOfAnUprightHeadIsHalfOfItOutsideTheGaugeAndInclinationTurnsItInward)
{
  const PlacedRail rail(std::make_shared<Profile>(rail60E1()), {1.435, 0.0143, 0}, Side::left);
  const PlanePoint crown = rail.place({0, 0, 1, 0, 0, 0});
  EXPECT_NEAR(crown.y, 0.7175 + 0.0359998, 1e-7);  // half of the last digit of 35.9998 mm
  EXPECT_NEAR(crown.z, 0, rounding);
  const PlacedRail upright(scene_.rail_profile.left, {1.435, 0.014, 0}, Side::left);
  const PlacedRail inclined(scene_.rail_profile.left, {1.435, 0.014, 0.025}, Side::left);
  const double middle = 0.5 * scene_.rail_profile.left->length();
  EXPECT_NEAR(upright.at(middle).dz / upright.at(middle).dy, 0, 1e-12);
  EXPECT_NEAR(inclined.at(middle).dz / inclined.at(middle).dy, std::tan(0.025), 1e-12);
}

TEST_F(PlacementTest, RailThatEndsAboveTheGaugeDepthIsRejected)
{
  const auto place = [&] { PlacedRail(scene_.rail_profile.left, {1.435, 0.2, 0.025}, Side::left); };
  EXPECT_TRUE(contains(refusalOf(place), "track/gauge_depth"));
}

TEST_F(PlacementTest, DeflectionMovesTheReferencePointAndTurnsTheHeadAboutIt)
{
  const PlacedRail rest(scene_.rail_profile.left, scene_.track, Side::left);
  for (int i = 0; i < 100; ++i)
  {
    const RailDeflection given{random_.within(-5e-3, 5e-3), random_.within(-2e-3, 2e-3), random_.within(-0.03, 0.03)};
    const PlacedRail bent = rest.deflected(given);
    const PlanePoint before = rest.referencePoint();
    const PlanePoint after = bent.referencePoint();
    EXPECT_NEAR(after.y - before.y, given.lateral, rounding);
    EXPECT_NEAR(after.z - before.z, given.vertical, rounding);
    // The crown is 14 mm above the reference point, on the axis of the rail. Outward roll moves it outward.
    const PlanePoint crown = bent.place({0, 0, 1, 0, 0, 0});
    EXPECT_NEAR(crown.y - after.y, 0.014 * std::sin(given.roll - scene_.track.rail_inclination.left), rounding);
    EXPECT_NEAR(crown.z - after.z, 0.014 * std::cos(given.roll - scene_.track.rail_inclination.left), rounding);
    const double u = random_.within(0, scene_.rail_profile.left->length());
    EXPECT_NEAR(std::hypot(bent.at(u).y - after.y, bent.at(u).z - after.z),
                std::hypot(rest.at(u).y - before.y, rest.at(u).z - before.z), rounding);
  }
}

// Definition of a surface of revolution: the distance of a point from the axle equals the radius of the profile at the
// position of the point along the axle.
TEST_F(PlacementTest, SectionAndLocusAreAtTheRadiusOfTheProfileFromTheAxle)
{
  for (int i = 0; i < 2000; ++i)
  {
    const WheelsetPose pose = randomPose();
    const PlacedWheel wheel(*scene_.wheel_profile.left, scene_.wheelset, Side::left, pose);
    const CurvePoint point = scene_.wheel_profile.left->at(random_.within(0, scene_.wheel_profile.left->length()));
    const double x = random_.within(-0.05, 0.05);
    PlanePoint section;
    SpacePoint locus{};
    ASSERT_TRUE(wheel.section(point, x, section));
    const Eigen::Vector3d axle = axleDirection(pose);
    const Eigen::Vector3d centre(0, pose.y, pose.z);
    const auto expectOnWheel = [&](const Eigen::Vector3d& surface)
    {
      const double along = (surface - centre).dot(axle);
      EXPECT_NEAR(along, scene_.wheelset.halfBase() + point.y, 1e-13);  // rounding of a few products below 1 m
      EXPECT_NEAR((surface - centre - along * axle).norm(), scene_.wheelset.rolling_radius.left - point.z, 1e-13);
    };
    expectOnWheel({x, section.y, section.z});
    const double steepest = std::hypot(axle.y(), axle.z()) / std::abs(axle.x());
    ASSERT_EQ(wheel.locus(point, locus), std::abs(point.slope()) < steepest);
    if (std::abs(point.slope()) < steepest)
    {
      expectOnWheel({locus.x, locus.y, locus.z});
    }
  }
}

TEST_F(PlacementTest, DerivativesOfASectionAgreeWithDifferences)
{
  const Profile& profile = *scene_.wheel_profile.left;
  // Error of the central difference: third derivative times step², about 1e-9. Rounding: 1e-16 / step = 1e-10.
  const double step = 1e-6;
  for (int i = 0; i < 1000; ++i)
  {
    const PlacedWheel wheel(profile, scene_.wheelset, Side::left, randomPose());
    const double u = random_.within(0.001, profile.length() - 0.001);
    const double x = random_.within(-0.05, 0.05);
    const bool near_discontinuity =
        std::any_of(profile.discontinuities().begin(), profile.discontinuities().end(),
                    [&](double discontinuity) { return std::abs(u - discontinuity) < 2 * step; });
    PlanePoint here, before, after;
    ASSERT_TRUE(wheel.section(profile.at(u), x, here));
    ASSERT_TRUE(wheel.section(profile.at(u - step), x, before));
    ASSERT_TRUE(wheel.section(profile.at(u + step), x, after));
    if (!near_discontinuity)
    {
      EXPECT_NEAR(here.dy, (after.y - before.y) / (2 * step), 1e-7);
      EXPECT_NEAR(here.dz, (after.z - before.z) / (2 * step), 1e-7);
    }
  }
}

TEST_F(PlacementTest, RightWheelIsTheMirrorImageOfTheLeftOne)
{
  for (int i = 0; i < 200; ++i)
  {
    const WheelsetPose pose = randomPose();
    const WheelsetPose seen = toSide(Side::right, pose);
    const WheelsetPose back = toSide(Side::right, seen);
    EXPECT_EQ(back.y, pose.y);
    EXPECT_EQ(back.yaw, pose.yaw);
    EXPECT_EQ(back.roll, pose.roll);
    EXPECT_EQ(toSide(Side::left, pose).y, pose.y);

    const PlacedWheel wheel(*scene_.wheel_profile.left, scene_.wheelset, Side::left, seen);
    const CurvePoint point = scene_.wheel_profile.left->at(random_.within(0, scene_.wheel_profile.left->length()));
    PlanePoint section;
    ASSERT_TRUE(wheel.section(point, 0.01, section));
    // In the track frame the right wheel is on the negative end of the axle.
    const Eigen::Vector3d surface(0.01, -section.y, section.z);
    const Eigen::Vector3d axle = axleDirection(pose);
    const Eigen::Vector3d centre(0, pose.y, pose.z);
    const double along = (surface - centre).dot(axle);
    EXPECT_NEAR(along, -(scene_.wheelset.halfBase() + point.y), 1e-13);
    EXPECT_NEAR((surface - centre - along * axle).norm(), scene_.wheelset.rolling_radius.left - point.z, 1e-13);
  }
}

/// Lower envelope of curves, at given positions across the track. Neighbouring points of a curve are connected by
/// chords.
class LowestOutline
{
 public:
  explicit LowestOutline(const Eigen::ArrayXd& places)
      : places_(places), z_(Eigen::ArrayXd::Constant(places.size(), std::numeric_limits<double>::infinity()))
  {
  }
  void startCurve() { has_before_ = false; }
  void add(bool exists, double y, double z)
  {
    for (Eigen::Index k = 0; exists && has_before_ && k < places_.size(); ++k)
    {
      const double share = (places_[k] - y_before_) / (y - y_before_);
      if (share >= 0 && share <= 1)
      {
        z_[k] = std::min(z_[k], z_before_ + share * (z - z_before_));
      }
    }
    has_before_ = exists;
    y_before_ = y;
    z_before_ = z;
  }
  const Eigen::ArrayXd& z() const { return z_; }

 private:
  Eigen::ArrayXd places_, z_;
  bool has_before_ = false;
  double y_before_ = 0, z_before_ = 0;
};

// Compares the outline of the locus with the outline of the wheel by brute force: the lower envelope of sections at
// constant x, 0.4 mm apart, over the whole wheel.
//
// The positions are at least 5 mm inside the ends of the profile, because the edges at the ends have their own
// outlines. (The roll moves the lowest points laterally by radius times roll.) Tolerance: the error of chords of 0.1 mm
// on arcs of 13 mm is 0.1 um; that of sections half a step beside the lowest one is (0.2 mm)² / (2 * 460 mm) = 0.04 um.
// Both are along the normal. On the flank (70 degrees), they are three times as large in z.
TEST(WheelOutlineTest, LocusIsTheLowestOutlineAlongTheTrack)
{
  Seeded random(20111U);
  const Profile profile = s1002Wheel();
  const WheelsetConfig wheelset;
  std::vector<CurvePoint> points;
  for (double u = 0; u < profile.length(); u += 1e-4)
  {
    points.push_back(profile.at(u));
  }
  for (const double yaw : {0.0, 0.01, -0.03, 0.06, -0.06})
  {
    const WheelsetPose pose{0.01 * random.unit(), 0.46, yaw, 0.02 * random.unit()};
    const PlacedWheel wheel(profile, wheelset, Side::left, pose);
    const Eigen::ArrayXd places = Eigen::ArrayXd::LinSpaced(40, 0.685, 0.803) + (pose.y + 0.46 * pose.roll);
    LowestOutline locus_outline(places);
    for (const CurvePoint& point : points)
    {
      SpacePoint locus{};
      const bool exists = wheel.locus(point, locus);
      locus_outline.add(exists, locus.y, locus.z);
    }
    LowestOutline section_outline(places);
    for (double x = -0.2; x <= 0.2; x += 4e-4)
    {
      section_outline.startCurve();
      for (const CurvePoint& point : points)
      {
        PlanePoint section{};
        const bool exists = wheel.section(point, x, section);
        section_outline.add(exists, section.y, section.z);
      }
    }
    EXPECT_LT((locus_outline.z() - section_outline.z()).abs().maxCoeff(), 5e-7) << "yaw " << yaw;
  }
}
}  // namespace
