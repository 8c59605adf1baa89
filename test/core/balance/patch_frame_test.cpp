// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/balance/rail_support.h"
#include "core/track/contact_search.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
/// Distance of a point in side axes from a placed rail, by sampling and refinement [m].
double distanceFrom(const PlacedRail& rail, double y, double z)
{
  const auto distance = [&](double u) { return std::hypot(rail.at(u).y - y, rail.at(u).z - z); };
  double best = 0;
  double step = 1e-4;
  for (double u = 0; u < rail.profile().length(); u += step)
  {
    best = distance(u) < distance(best) ? u : best;
  }
  for (; step > 1e-12; step *= 0.5)
  {
    best = distance(best + step) < distance(best) ? best + step : best;
    best = distance(best - step) < distance(best) ? best - step : best;
  }
  return distance(best);
}

class PatchFrameTest : public testing::Test
{
 protected:
  PatchFrameTest()
  {
    scene_.rail_bending.model = RailBendingConfig::Model::prescribed;
    scene_.rail_bending.prescribed = {0.8e-3, -0.2e-3, 4e-3};
  }

  ContactModelConfig scene_ = manchesterScene();
};
}  // namespace

TEST_F(PatchFrameTest, OriginLiesOnThePlacedRail)
{
  WheelsetContact contact(scene_);
  const PlacedRail rail = restingRail(scene_, Side::left).deflected(scene_.rail_bending.prescribed);
  for (const double y : {0.0, 2e-3, -4e-3, 6e-3})
  {
    const WheelsetResult& result = contact.evaluate(stateAt(y, 8e4, 0.002));
    ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
    for (const PatchResult& patch : result.patches)
    {
      EXPECT_LT(distanceFrom(rail, sideSign(patch.side) * patch.pose.y, patch.pose.z), 1e-9);  // rounding: 1e-12 m
    }
  }
}

// The frame lies along the resultant of the pressure. At its origin the slope of the rail may differ by the turn of
// rail and wheel over the patch: half a width of 8 mm on 80 mm is 0.05 rad on the tread.
TEST_F(PatchFrameTest, NormalPointsOutOfTheRail)
{
  WheelsetContact contact(scene_);
  for (const double y : {0.0, 2e-3, -4e-3})
  {
    const WheelsetResult& result = contact.evaluate(stateAt(y, 8e4));
    ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
    for (const PatchResult& patch : result.patches)
    {
      EXPECT_EQ(patch.contact_angle, sideSign(patch.side) * patch.pose.angle);
      EXPECT_GT(std::cos(patch.pose.angle), 0);
      EXPECT_GT(sideSign(patch.side) * patch.pose.angle, 0);  // towards the field side the plane rises
      EXPECT_LT(patch.contact_angle, 0.15);
    }
  }
}

// The normals of the cells differ from the resultant by at most the turn of the surfaces over the patch. The gap of the
// wheel is inclined to the normal of the rail by at most 2 depth / half-width; on the flange this adds up to 0.1 %.
TEST_F(PatchFrameTest, PressureLiesInsideTheGridAndItsResultantIsTheNormalForce)
{
  WheelsetContact contact(scene_);
  for (const double y : {0.0, 2e-3, -4e-3, 6e-3})
  {
    const WheelsetResult& result = contact.evaluate(stateAt(y, 8e4, 0.002));
    ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
    for (const PatchResult& patch : result.patches)
    {
      const Eigen::ArrayXXd& p = patch.pressure;
      ASSERT_EQ(p.rows(), patch.grid.nx);
      ASSERT_EQ(p.cols(), patch.grid.ny);
      EXPECT_GE(p.minCoeff(), 0);
      EXPECT_GT(p.maxCoeff(), 0);
      const double sum = p.sum() * patch.grid.cellArea();
      EXPECT_LT(patch.normal_force, 1.001 * sum);
      EXPECT_GT(patch.normal_force, std::cos(2 * patch.half_space_ratio) * sum);
      // The highest pressure lies between cells. On a grid of n cells across it exceeds the highest cell by less than
      // 2/n² of the peak in each direction: 2 % on the coarsest grid. Next to a curvature discontinuity the highest
      // cell is too high by up to 2 % of the effect of the discontinuity, here by less than 1 %.
      // On an island of few cells the estimate covers both.
      EXPECT_GT(patch.max_pressure, (0.99 - patch.error_estimate) * p.maxCoeff());
      EXPECT_LT(patch.max_pressure, (1.02 + patch.error_estimate) * p.maxCoeff());
    }
  }
}

TEST_F(PatchFrameTest, OriginIsTheCentreOfPressure)
{
  WheelsetContact contact(scene_);
  for (const double yaw : {0.0, 0.01})
  {
    for (const double y : {0.0, 2e-3, -4e-3, 6e-3})
    {
      const WheelsetResult& result = contact.evaluate(stateAt(y, 8e4, yaw));
      ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
      for (const PatchResult& patch : result.patches)
      {
        double x = 0, across = 0;
        for (int j = 0; j < patch.grid.ny; ++j)
        {
          across += patch.pressure.col(j).sum() / patch.pressure.sum() * patch.grid.y(j);
        }
        for (int i = 0; i < patch.grid.nx; ++i)
        {
          x += patch.pressure.row(i).sum() / patch.pressure.sum() * patch.grid.x(i);
        }
        EXPECT_NEAR(x, 0, 1e-12) << "y " << y << " yaw " << yaw;
        EXPECT_NEAR(across, 0, 1e-12) << "y " << y << " yaw " << yaw;
      }
    }
  }
}

// A grid covers the overlap of the undeformed bodies, in which the contact lies. On coarse grids the margin is less
// than a cell.
TEST_F(PatchFrameTest, PressureDoesNotReachTheBorderOfAFineGrid)
{
  scene_.contact.method = NormalMethod::conjugate_gradient;
  scene_.contact.cells_along = 64;
  scene_.contact.cells_across = 64;
  WheelsetContact contact(scene_);
  for (const double y : {0.0, 2e-3, -4e-3})
  {
    const WheelsetResult& result = contact.evaluate(stateAt(y, 8e4));
    ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
    for (const PatchResult& patch : result.patches)
    {
      const Eigen::ArrayXXd& p = patch.pressure;
      EXPECT_EQ(std::max(p.row(0).maxCoeff(), p.row(p.rows() - 1).maxCoeff()), 0) << "y " << y;
      EXPECT_EQ(std::max(p.col(0).maxCoeff(), p.col(p.cols() - 1).maxCoeff()), 0) << "y " << y;
    }
  }
}

// Between tread and flange root a wheel has two patches. Both are compressed by the same penetration of the wheel, each
// by its component along its own normal. The contact search at the solved pose gives the same overlaps. Tolerance: the
// remaining errors of roll and penetration are 1 % of a penetration, and neighbouring search stations differ by 0.1 um.
TEST_F(PatchFrameTest, TwoPatchesOfAWheelShareOnePenetration)
{
  scene_ = manchesterScene();
  WheelsetContact contact(scene_);
  ContactSearch search(*scene_.wheel_profile.left, *scene_.rail_profile.left);
  const PlacedRail rail = restingRail(scene_, Side::left);
  search.setRail(rail);
  int found = 0;
  for (double y = 4.6e-3; y < 5.4e-3; y += 5e-5)
  {
    contact.reset();
    const WheelsetResult& result = contact.evaluate(stateAt(y, 1e4));
    if (!isUsable(result.status) || wheelTotal(result, Side::left).patches != 2)
    {
      continue;
    }
    ++found;
    EXPECT_NEAR(wheelTotal(result, Side::left).vertical, 1e4, 1e-6 * 1e4);
    search.setWheel(
        {*scene_.wheel_profile.left, scene_.wheelset, Side::left, {result.y, result.z, result.yaw, result.roll}});
    std::vector<OverlapInterval> intervals;
    search.overlapIntervals(0, intervals);
    for (const PatchResult& patch : result.patches)
    {
      if (patch.side != Side::left)
      {
        continue;
      }
      const auto nearest =
          std::min_element(intervals.begin(), intervals.end(),
                           [&](const OverlapInterval& a, const OverlapInterval& b)
                           { return std::abs(a.contact.y - patch.pose.y) < std::abs(b.contact.y - patch.pose.y); });
      ASSERT_NE(nearest, intervals.end());
      const double overlap = -nearest->contact.separation / std::hypot(1, nearest->contact.slope);
      EXPECT_NEAR(patch.approach, overlap, 0.01 * overlap + 1e-7) << "y " << y;
    }
  }
  EXPECT_GT(found, 2);
}
