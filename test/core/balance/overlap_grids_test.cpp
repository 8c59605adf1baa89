// SPDX-License-Identifier: BSD-3-Clause
// Grids over the overlap of the undeformed bodies.
#include "core/balance/overlap_grids.h"

#include "../../seeded.h"
#include "core/balance/rail_support.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr GridSize size{16, 32};
constexpr double overlap = 5e-5;  ///< largest one [m]

class OverlapGridsTest : public testing::Test
{
 protected:
  OverlapGridsTest()
  {
    grids_.setRail(rail_);
    search_.setRail(rail_);
    problem_.modulus = contactModulus(config_.wheel_material.left, config_.rail_material.left);
  }

  /// Pose at which the bodies overlap by `depth` [m].
  WheelsetPose overlapping(double y, double yaw, double depth)
  {
    WheelsetPose pose{y, 0.47, yaw, 0};
    CurvedProblem none = problem_;
    EXPECT_EQ(grids_.build(pose, size, OverlapGrids::Choice::own, OverlapGrids::Reach::whole, none),
              OverlapGrids::Overlap::none);
    pose.z -= grids_.touch().separation + depth;
    return pose;
  }

  OverlapGrids::Overlap build(const WheelsetPose& pose, OverlapGrids::Choice choice = OverlapGrids::Choice::own)
  {
    return grids_.build(pose, size, choice, OverlapGrids::Reach::whole, problem_);
  }

  /// The same pressure in all cells [Pa].
  NormalSolution pressed(double pressure) const
  {
    NormalSolution solution;
    for (const PatchGap& patch : problem_.patches)
    {
      solution.patches.emplace_back();
      solution.patches.back().grid = patch.grid;
      solution.patches.back().pressure.setConstant(patch.grid.rows(), patch.grid.ny, pressure);
    }
    return solution;
  }

  /// Expects no cell of a border to overlap, and some cell inside.
  void expectOverlapInside() const
  {
    for (const PatchGap& patch : problem_.patches)
    {
      const Eigen::ArrayXXd& gap = patch.gap;
      EXPECT_LT(gap.minCoeff(), 0);
      EXPECT_GE(gap.bottomRows(1).minCoeff(), 0);
      EXPECT_GE(patch.grid.symmetric ? 0 : gap.topRows(1).minCoeff(), 0);
      EXPECT_GE(gap.leftCols(1).minCoeff(), 0);
      EXPECT_GE(gap.rightCols(1).minCoeff(), 0);
    }
  }

  /// Finds a state in which tread and flange root overlap at distant places.
  WheelsetPose onTreadAndFlange()
  {
    for (double y = 4.6e-3; y < 5.6e-3; y += 1e-5)
    {
      const WheelsetPose pose = overlapping(y, 0, 2e-5);
      build(pose);
      if (problem_.patches.size() == 2)
      {
        return pose;
      }
    }
    ADD_FAILURE() << "no state with two grids";
    return {};
  }

  ContactModelConfig config_ = manchesterScene();
  PlacedRail rail_ = restingRail(config_, Side::left);
  OverlapGrids grids_{config_, Side::left, rail_};
  ContactSearch search_{*config_.wheel_profile.left, *config_.rail_profile.left};
  CurvedProblem problem_;
};
}  // namespace

TEST_F(OverlapGridsTest, ContactOfTheTreadHasOneGrid)
{
  for (const double yaw : {0.0, 0.01})
  {
    ASSERT_EQ(build(overlapping(1e-3, yaw, overlap)), OverlapGrids::Overlap::found);
    ASSERT_EQ(problem_.patches.size(), 1U);
    EXPECT_EQ(problem_.coupling.size(), 0);
    const Grid& grid = problem_.patches[0].grid;
    EXPECT_EQ(grid.nx, size.along);
    EXPECT_EQ(grid.ny, size.across);
    EXPECT_EQ(grid.symmetric, yaw == 0);
    EXPECT_EQ(grids_.columns()[0].size(), static_cast<std::size_t>(grid.ny));
    EXPECT_NEAR(grids_.touch().separation, -overlap, 1e-9);
    EXPECT_GT(problem_.patches[0].gap.minCoeff(), -overlap - 1e-9);
    EXPECT_LT(problem_.patches[0].gap.minCoeff(), -0.95 * overlap);
    expectOverlapInside();
  }
}

// The coupling is the displacement by a point force on a half-space, at most at the distance of the grids.
TEST_F(OverlapGridsTest, DistantContactsHaveTwoCoupledGrids)
{
  onTreadAndFlange();
  ASSERT_EQ(problem_.patches.size(), 2U);
  expectOverlapInside();
  const Eigen::Index first = problem_.patches[0].grid.ny, second = problem_.patches[1].grid.ny;
  const Eigen::MatrixXd& coupling = problem_.coupling;
  ASSERT_EQ(coupling.rows(), first + second);
  ASSERT_EQ(coupling.cols(), first + second);
  EXPECT_EQ(coupling, coupling.transpose());
  EXPECT_TRUE(coupling.topLeftCorner(first, first).isZero(0));
  EXPECT_TRUE(coupling.bottomRightCorner(second, second).isZero(0));
  for (Eigen::Index i = 0; i < first; ++i)
  {
    for (Eigen::Index j = 0; j < second; ++j)
    {
      const SurfaceColumn& here = grids_.columns()[0][static_cast<std::size_t>(i)];
      const SurfaceColumn& there = grids_.columns()[1][static_cast<std::size_t>(j)];
      const double distance = std::hypot(here.y - there.y, here.z - there.z);
      EXPECT_GT(coupling(i, first + j), 0);
      EXPECT_LT(coupling(i, first + j), 1 / (std::acos(-1.0) * problem_.modulus * distance));
    }
  }
}

// The contact lies inside the overlap of the undeformed bodies. Every interval of the overlap must therefore be in a
// grid, and its ends inside the border.
TEST_F(OverlapGridsTest, GridsContainTheWholeOverlap)
{
  Seeded random(20113U);
  for (int i = 0; i < 200; ++i)
  {
    const double y = 8e-3 * random.unit(), yaw = i % 2 == 0 ? 0 : 0.02 * random.unit();
    const double depth = 1e-5 * std::pow(30, std::abs(random.unit()));
    const WheelsetPose pose = overlapping(y, yaw, depth);
    SCOPED_TRACE("y " + std::to_string(y) + " yaw " + std::to_string(yaw) + " depth " + std::to_string(depth));
    ASSERT_EQ(build(pose), OverlapGrids::Overlap::found);
    expectOverlapInside();
    search_.setWheel({*config_.wheel_profile.left, config_.wheelset, Side::left, pose});
    std::vector<OverlapInterval> intervals;
    search_.overlapIntervals(0, intervals);
    for (const OverlapInterval& interval : intervals)
    {
      const auto holds = [&](const std::vector<SurfaceColumn>& columns)
      {
        const double u = interval.contact.rail_u;
        return columns.front().rail_u < u && columns.back().rail_u > u;
      };
      EXPECT_TRUE(std::any_of(grids_.columns().begin(), grids_.columns().end(), holds));
    }
  }
}

// One search moves the wheel by little. Its solutions are then on the same cells.
TEST_F(OverlapGridsTest, GridsAreKeptWhereTheyStillCoverTheOverlap)
{
  WheelsetPose pose = overlapping(1e-3, 0, overlap);
  build(pose);
  const Grid first = problem_.patches[0].grid;
  pose.z += 1e-6;
  build(pose, OverlapGrids::Choice::kept);
  EXPECT_EQ(problem_.patches[0].grid.dx, first.dx);
  EXPECT_EQ(problem_.patches[0].grid.dy, first.dy);
  EXPECT_EQ(problem_.patches[0].grid.y0, first.y0);
  pose.z -= overlap;  // the overlap has grown beyond the grid
  build(pose, OverlapGrids::Choice::kept);
  EXPECT_GT(problem_.patches[0].grid.dy, first.dy);
  expectOverlapInside();
}

TEST(GridLayout, CoversAnAreaUnlessItIsMuchSmaller)
{
  SurfaceArea area{-4e-3, 4e-3, -3e-3, 3e-3, {}};
  const GridLayout layout = layGrid(area, {16, 32}, true);
  EXPECT_TRUE(covers(layout, area, 0, 2));
  EXPECT_FALSE(covers(layout, area, 2e-3, 2)) << "the area is beside the grid";
  area.x_least *= 0.4;
  area.x_most *= 0.4;
  EXPECT_TRUE(covers(layout, area, 0, 4));
  EXPECT_FALSE(covers(layout, area, 0, 2));
}

// A Hertzian contact is 0.7 times as long and as wide as the overlap. The grids leave a margin.
TEST_F(OverlapGridsTest, TheExpectedContactIsAPartOfTheOverlap)
{
  for (const double y : {3e-3, 4e-3})
  {
    const WheelsetPose pose = overlapping(y, 0, overlap);
    ASSERT_EQ(build(pose), OverlapGrids::Overlap::found);
    const Grid whole = problem_.patches[0].grid;
    EXPECT_TRUE(grids_.isComplete(problem_, pressed(1)));
    ASSERT_EQ(grids_.build(pose, size, OverlapGrids::Choice::own, OverlapGrids::Reach::expected, problem_),
              OverlapGrids::Overlap::found);
    const Grid expected = problem_.patches[0].grid;
    EXPECT_LT(expected.cellArea(), 0.75 * whole.cellArea()) << "y " << y;
    NormalSolution solution = pressed(0);
    EXPECT_TRUE(grids_.isComplete(problem_, solution));
    solution.patches[0].pressure(0, 0) = 1;
    EXPECT_FALSE(grids_.isComplete(problem_, solution)) << "pressure at the edge";
  }
}

// A finer grid is laid over the pressure found on a coarser one.
TEST_F(OverlapGridsTest, AFinerGridFollowsThePressure)
{
  const WheelsetPose pose = overlapping(1e-3, 0, overlap);
  build(pose);
  const Grid grid = problem_.patches[0].grid;
  PatchPressure pressure;
  pressure.grid = grid;
  pressure.pressure = Eigen::ArrayXXd::Zero(grid.rows(), grid.ny);
  pressure.pressure.block(0, grid.ny / 2 - 2, 3, 4).setOnes();
  const auto u = [this](Eigen::Index j) { return grids_.columns()[0][static_cast<std::size_t>(j)].rail_u; };
  const double begin = u(grid.ny / 2 - 2) - grid.dy, end = u(grid.ny / 2 + 1) + grid.dy;
  grids_.follow({pressure});
  grids_.build(pose, size, OverlapGrids::Choice::own, OverlapGrids::Reach::expected, problem_);
  EXPECT_LT(grids_.columns()[0].front().rail_u, begin);
  EXPECT_GT(grids_.columns()[0].back().rail_u, end);
  EXPECT_LT(problem_.patches[0].grid.dy, 0.7 * grid.dy);
  grids_.unfollow();
  build(pose);
  EXPECT_EQ(problem_.patches[0].grid.dy, grid.dy);
}

TEST_F(OverlapGridsTest, BodiesApartOrBesideOneAnotherHaveNoGrids)
{
  EXPECT_EQ(build(overlapping(0, 0, -1e-9)), OverlapGrids::Overlap::none);
  EXPECT_EQ(build({0.5, 0.46, 0, 0}), OverlapGrids::Overlap::beside);
}
}  // namespace wheel_rail_contact::core
