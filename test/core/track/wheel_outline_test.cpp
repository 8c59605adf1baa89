// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/track/placement.h"
#include "wheel_rail_contact/core/profile_reader.h"

using namespace wheel_rail_contact::core;

namespace
{
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
}  // namespace

// Compares the outline of the locus with the outline of the wheel by brute force: the lower envelope of sections at
// constant x, 0.4 mm apart, over the whole wheel.
//
// The positions are at least 5 mm inside the ends of the profile, because the edges at the ends have their own
// outlines. (The roll moves the lowest points laterally by radius times roll.) Tolerance: the error of chords of 0.1 mm
// on arcs of 13 mm is 0.1 um; that of sections half a step beside the lowest one is (0.2 mm)² / (2 * 460 mm) = 0.04 um.
// Both are along the normal. On the flank (70 degrees), they are three times as large in z.
TEST(WheelOutlineTest, LocusIsTheLowestOutlineAlongTheTrack)
{
  const unsigned seed = 20111U;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Profile profile = s1002Wheel();
  const WheelsetConfig wheelset;
  std::vector<CurvePoint> points;
  for (double u = 0; u < profile.length(); u += 1e-4)
  {
    points.push_back(profile.at(u));
  }
  for (const double yaw : {0.0, 0.01, -0.03, 0.06, -0.06})
  {
    const WheelsetPose pose{0.01 * unit(random), 0.46, yaw, 0.02 * unit(random)};
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
