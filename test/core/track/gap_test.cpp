// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/gap.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "../../manchester_scene.h"
#include "bisection.h"

using namespace wheel_rail_contact::core;

namespace
{
/// Gap at one point of a plane, from the definition of the bodies alone: on the wheel the distance from the axle equals
/// the radius of the profile; the rail is the profile itself.
class DirectGap
{
 public:
  DirectGap(const PlacedWheel& wheel, const PlacedRail& rail, const WheelsetConfig& wheelset, const ContactPlane& plane)
      : wheel_(wheel), rail_(rail), wheelset_(wheelset), plane_(plane)
  {
    const WheelsetPose& pose = wheel.pose();
    centre_ = {0, pose.y, pose.z};
    axle_ = {-std::sin(pose.yaw) * std::cos(pose.roll), std::cos(pose.yaw) * std::cos(pose.roll), std::sin(pose.roll)};
  }

  double at(double x, double t) const { return wheelHeight(x, t) - railHeight(t); }

  double railHeight(double t) const
  {
    const double u = root([&](double at) { return PlaneAxes(plane_).t(rail_.at(at)) - t; }, plane_.rail_u + t - 3e-3,
                          plane_.rail_u + t + 3e-3);
    const PlanePoint point = rail_.at(u);
    return std::cos(plane_.angle) * (point.z - plane_.z) - std::sin(plane_.angle) * (point.y - plane_.y);
  }

 private:
  double wheelHeight(double x, double t) const
  {
    const double cosine = std::cos(plane_.angle);
    const double sine = std::sin(plane_.angle);
    return root(
        [&](double n)
        {
          const Eigen::Vector3d point(plane_.x + x, plane_.y + cosine * t - sine * n, plane_.z + sine * t + cosine * n);
          const double along = (point - centre_).dot(axle_);
          const double distance = (point - centre_ - along * axle_).norm();
          return distance - wheelset_.rolling_radius + profileHeight(along - wheelset_.halfBase());
        },
        -2e-3, 2e-3);
  }

  double profileHeight(double y) const
  {
    const Profile& profile = wheel_.profile();
    return profile.at(root([&](double u) { return profile.at(u).y - y; }, 0, profile.length())).z;
  }

  const PlacedWheel& wheel_;
  const PlacedRail& rail_;
  const WheelsetConfig& wheelset_;
  const ContactPlane& plane_;
  Eigen::Vector3d centre_, axle_;
};

class GapTest : public testing::Test
{
 protected:
  /// Places the wheel in first touch with the rail, at a lateral displacement [m] and yaw [rad].
  void touch(double y, double yaw)
  {
    WheelsetPose pose{y, 0.46, yaw, 0};
    search_.setRail(rail_);
    search_.setWheel({*config_.wheel_profile, config_.wheelset, pose});
    InitialContact contact;
    ASSERT_TRUE(search_.nearest(contact));
    pose.z -= contact.separation;
    wheel_ = PlacedWheel(*config_.wheel_profile, config_.wheelset, pose);
    plane_ = tangentPlane(wheel_, rail_, contact);
  }

  /// Places a point of the wheel flange on the point of the rail's gauge side with the same slope.
  void touchAt(double wheel_u, double yaw)
  {
    WheelsetPose pose{0.006, 0.46, yaw, 0};
    wheel_ = PlacedWheel(*config_.wheel_profile, config_.wheelset, pose);
    SpacePoint locus{};
    PlanePoint wheel{};
    ASSERT_TRUE(wheel_.locus(config_.wheel_profile->at(wheel_u), locus));
    ASSERT_TRUE(wheel_.section(config_.wheel_profile->at(wheel_u), locus.x, wheel));
    InitialContact contact;
    contact.wheel_u = wheel_u;
    contact.slope = wheel.dz / wheel.dy;
    const auto is_flatter = [&](double u)
    { return rail_.at(u).dy > 0 && rail_.at(u).dz / rail_.at(u).dy < contact.slope; };
    while (!is_flatter(contact.rail_u))
    {
      contact.rail_u += 1e-5;
    }
    pose.y += rail_.at(contact.rail_u).y - locus.y;
    pose.z += rail_.at(contact.rail_u).z - locus.z;
    wheel_ = PlacedWheel(*config_.wheel_profile, config_.wheelset, pose);
    plane_ = tangentPlane(wheel_, rail_, contact);
  }

  /// Grid of 16 × 32 cells about the first touch.
  Grid grid(double half_length, double half_width, bool symmetric) const
  {
    return {16, 32, half_length / 8, half_width / 16, -half_width * 31 / 32, symmetric};
  }

  /// Largest error of the gap on a grid against the direct solution [m].
  double worstError(const Grid& grid)
  {
    EXPECT_TRUE(buildGap(wheel_, rail_, plane_, grid, gap_, columns_));
    const DirectGap direct(wheel_, rail_, config_.wheelset, plane_);
    double worst = 0;
    for (int j = 0; j < grid.ny; ++j)
    {
      for (int i = 0; i < grid.rows(); ++i)
      {
        worst = std::max(worst, std::abs(gap_(i, j) - direct.at(grid.x(i), grid.y(j))));
      }
    }
    return worst;
  }

  ContactModelConfig config_ = manchesterScene();
  PlacedRail rail_{config_.rail_profile, config_.track};
  PlacedWheel wheel_{*config_.wheel_profile, config_.wheelset, {}};
  ContactSearch search_{*config_.wheel_profile, *config_.rail_profile};
  ContactPlane plane_;
  Eigen::ArrayXXd gap_;
  std::vector<GapColumn> columns_;
};
}  // namespace

// The error of the polynomial of degree four is of the order of l (l/R)^5: 3e-9 m at l = 20 mm on R = 460 mm, and twice
// as much at a contact angle of 60 degrees. With yaw, a column extends along the profile, whose curvature (13 mm in the
// flange root) adds terms of the fifth order: 7e-9 m were measured at 20 mrad. Bound: 1e-8 m, as stated for buildGap().
TEST_F(GapTest, EveryCellAgreesWithADirectSolution)
{
  for (const double y : {0.0, 0.003, 0.005, 0.006, 0.009})
  {
    for (const double yaw : {0.0, 0.02, -0.02})
    {
      touch(y, yaw);
      const double half_width = y > 0.008 ? 1e-3 : 2e-3;  // on the flange root alone
      EXPECT_LT(worstError(grid(20e-3, half_width, yaw == 0)), 1e-8) << "y " << y << " yaw " << yaw;
      EXPECT_LT(worstError(grid(5e-3, half_width, yaw == 0)), 5e-11) << "y " << y << " yaw " << yaw;
    }
  }
}

// On the flank, a yawed column crosses the boundary of the straight flank and the root arc (13 mm). No polynomial can
// represent this. Over the length l the column extends over l tan(yaw) of the profile. The error by the curvature jump
// is at most (l tan(yaw))² / (2 * 13 mm). Measured: an eighth to a quarter of this bound.
TEST_F(GapTest, ErrorOfAColumnAcrossACurvatureJumpIsBounded)
{
  for (const double yaw : {0.02, 0.06})
  {
    for (const double length : {2e-3, 5e-3, 10e-3})
    {
      touch(0.0065, yaw);
      EXPECT_GT(plane_.angle, 1.1);
      const double travel = length * std::tan(yaw);
      EXPECT_LT(worstError(grid(length, 2e-3, false)), travel * travel / (2 * 0.013))
          << "yaw " << yaw << " l " << length;
    }
  }
}

TEST_F(GapTest, SymmetricGridIsTheForwardHalfOfTheFullGrid)
{
  touch(0.002, 0);
  Eigen::ArrayXXd half;
  ASSERT_TRUE(buildGap(wheel_, rail_, plane_, grid(8e-3, 5e-3, true), half, columns_));
  ASSERT_TRUE(buildGap(wheel_, rail_, plane_, grid(8e-3, 5e-3, false), gap_, columns_));
  ASSERT_EQ(half.rows(), 8);
  ASSERT_EQ(gap_.rows(), 16);
  // The nodes of the polynomials differ: twice the error at l = 8 mm, l (l/R)^5 = 1e-11 m.
  EXPECT_LT((gap_.bottomRows(8) - half).abs().maxCoeff(), 2e-11);
  EXPECT_LT((gap_.topRows(8).colwise().reverse() - half).abs().maxCoeff(), 2e-11);
}

TEST_F(GapTest, BodiesInFirstTouchDoNotOverlap)
{
  for (const double y : {0.0, 0.003, 0.006, 0.009})
  {
    touch(y, 0.01);
    ASSERT_TRUE(buildGap(wheel_, rail_, plane_, grid(6e-3, 2e-3, false), gap_, columns_));
    EXPECT_GT(gap_.minCoeff(), -1e-10);  // first touch is accurate to 1e-11 m, columns to 1e-10 m
    EXPECT_LT(gap_.minCoeff(), 1e-6);    // a cell is within 0.4 mm along and 0.07 mm across of the touch
  }
}

// Forces and contact angles are computed from the data of the columns.
TEST_F(GapTest, ColumnsContainPositionAndMeanSlopeOfBothBodies)
{
  for (const double y : {0.0, 0.006, 0.009})
  {
    touch(y, 0);
    const Grid cells = grid(4e-3, 2e-3, true);
    ASSERT_TRUE(buildGap(wheel_, rail_, plane_, cells, gap_, columns_));
    const DirectGap direct(wheel_, rail_, config_.wheelset, plane_);
    const double step = 1e-5;
    for (int j = 0; j < cells.ny; ++j)
    {
      const GapColumn& column = columns_[static_cast<std::size_t>(j)];
      EXPECT_NEAR(PlaneAxes(plane_).t(rail_.at(column.rail_u)), cells.y(j), 1e-9);
      // Error of differences over 20 um: 10 um / 13 mm / 4 = 2e-4 where a radius of 13 mm begins within them; half of
      // 0.118 um / 20 um = 3e-3 at the step of 0.118 um between two sections of S1002.
      const double rail = (direct.railHeight(cells.y(j) + step) - direct.railHeight(cells.y(j) - step)) / (2 * step);
      const double gap = (direct.at(0, cells.y(j) + step) - direct.at(0, cells.y(j) - step)) / (2 * step);
      EXPECT_NEAR(column.slope, rail + 0.5 * gap, 3.2e-3);
      EXPECT_NEAR(column.rail_height, direct.railHeight(cells.y(j)), 1e-9);
    }
  }
}

// At the boundary at which the parameter of S1002 changes from arc length to y, dy/du jumps from 0.74 to 1. A
// search that mixes the expansion on one side with the profile on the other side can oscillate there.
TEST_F(GapTest, EveryColumnIsFoundAtADiscontinuityOfTheWheelParameter)
{
  const Profile& profile = *config_.wheel_profile;
  const auto changes = [&](double u) { return std::abs(profile.at(u + 1e-9).dy - profile.at(u - 1e-9).dy) > 0.1; };
  const auto discontinuity =
      std::find_if(profile.discontinuities().begin() + 1, profile.discontinuities().end() - 1, changes);
  ASSERT_NE(discontinuity, profile.discontinuities().end() - 1);
  const double wheel_u = *discontinuity + 1e-4;
  for (const double yaw : {0.0, 0.01, -0.01, 0.02})
  {
    touchAt(wheel_u, yaw);
    for (int i = 0; i < 600; ++i)
    {
      Grid across = grid((2 + 0.2 * (i % 40)) * 1e-3, (1 + i % 3) * 1e-3, yaw == 0);
      across.y0 += i / 600.0 * across.dy;
      ASSERT_TRUE(buildGap(wheel_, rail_, plane_, across, gap_, columns_));
      EXPECT_LT(gap_.row(0).maxCoeff(), no_body_gap) << "yaw " << yaw << ", grid " << i;
    }
  }
}

TEST_F(GapTest, PlaneTouchesBothBodiesAtTheContact)
{
  for (const double y : {0.0, 0.004, 0.009})
  {
    touch(y, 0.015);
    const DirectGap direct(wheel_, rail_, config_.wheelset, plane_);
    EXPECT_NEAR(direct.railHeight(0), 0, 1e-12);
    EXPECT_NEAR(direct.at(0, 0), 0, 1e-10);
    for (const double t : {-1e-5, 1e-5})
    {
      EXPECT_NEAR(direct.railHeight(t), 0, 4e-9);  // (10 um)² / (2 * 13 mm) = 3.85e-9 m
    }
  }
}

// Beyond the sides of the rail head there is no contact: the gap there must be large.
TEST_F(GapTest, CellsBesideTheRailHaveNoContact)
{
  touch(0, 0);
  const Grid wide{16, 64, 1e-3, 0.2 / 64, -0.1 + 0.1 / 64, true};
  ASSERT_TRUE(buildGap(wheel_, rail_, plane_, wide, gap_, columns_));
  for (int j = 0; j < wide.ny; ++j)
  {
    if (std::abs(wide.y(j)) > 0.038)
    {
      EXPECT_GT(gap_.col(j).minCoeff(), 0.02) << "at " << wide.y(j);
    }
  }
  EXPECT_EQ(gap_(0, 0), no_body_gap);  // beyond the flange back, where the wheel ends
}

TEST_F(GapTest, GridBesideTheWheelIsRejected)
{
  touch(0, 0);
  const Grid beside{16, 32, 1e-3, 1e-4, -0.1, true};
  EXPECT_FALSE(buildGap(wheel_, rail_, plane_, beside, gap_, columns_));
  EXPECT_TRUE((gap_ == no_body_gap).all());
}
