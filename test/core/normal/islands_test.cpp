// SPDX-License-Identifier: BSD-3-Clause
// Separate contacts of a wheel, of which several may lie on one grid.
#include "core/normal/estimate/islands.h"

#include "../../manchester_scene.h"
#include "core/track/placement.h"
#include "problems.h"

using namespace wheel_rail_contact::core;

namespace
{
/// Two bowls on one grid, at y = -5 mm and y = 4 mm, of which the second is higher by `rise` [m].
CurvedProblem twoBowls(double rise)
{
  const Grid grid = problems::centredGrid(32, 96, 0.02, 0.02, true);
  return problems::curved(problems::underLoad(
      problems::sampled(grid,
                        [rise](double x, double y)
                        {
                          const double first = y + 5e-3, second = y - 4e-3;
                          return 1.1 * x * x + std::min(30 * first * first, 50 * second * second + rise);
                        }),
      5e4));
}

class IslandsTest : public testing::Test
{
 protected:
  void solve(const CurvedProblem& problem)
  {
    problem_ = problem;
    ConjugateGradients().solveCurved(problem_, false, solution_);
    ASSERT_EQ(solution_.status, SolveStatus::converged);
    islands_.find(problem_, solution_);
  }

  CurvedProblem problem_;
  NormalSolution solution_;
  Islands islands_;
};

TEST_F(IslandsTest, TwoContactsOnOneGridAreTwoIslandsThatAddUp)
{
  solve(twoBowls(1e-5));
  ASSERT_EQ(islands_.islands().size(), 2U);
  ASSERT_EQ(islands_.solution().patches.size(), 2U);
  ASSERT_EQ(islands_.problem().patches.size(), 2U);
  const Eigen::ArrayXXd& whole = solution_.patches[0].pressure;
  Eigen::Index next = 0;
  for (std::size_t k = 0; k < 2; ++k)
  {
    const Island& island = islands_.islands()[k];
    const PatchPressure& part = islands_.solution().patches[k];
    EXPECT_EQ(island.patch, 0U);
    EXPECT_EQ(island.begin, next) << "the columns of the islands are those of the grid";
    next = island.begin + island.columns;
    EXPECT_EQ(part.grid.y0, problem_.patches[0].grid.y(static_cast<int>(island.begin)));
    EXPECT_TRUE((part.pressure == whole.middleCols(island.begin, island.columns)).all());
    EXPECT_TRUE(
        (islands_.problem().patches[k].gap == problem_.patches[0].gap.middleCols(island.begin, island.columns)).all());
    EXPECT_GT(whole.col(island.first).maxCoeff(), 0);
    EXPECT_GT(whole.col(island.last).maxCoeff(), 0);
  }
  EXPECT_EQ(next, whole.cols());
  const PatchPressure& grid = solution_.patches[0];
  const auto& parts = islands_.solution().patches;
  EXPECT_NEAR((parts[0].force + parts[1].force) / grid.force, 1, 1e-12);
  EXPECT_NEAR((parts[0].area + parts[1].area) / grid.area, 1, 1e-3);
  EXPECT_NEAR(std::max(parts[0].max_pressure, parts[1].max_pressure) / grid.max_pressure, 1, 1e-3);
  EXPECT_LT(parts[0].max_pressure, 0.95 * parts[1].max_pressure);  // the second bowl is narrower
  EXPECT_EQ(islands_.solution().approach, solution_.approach);
  EXPECT_EQ(islands_.solution().status, solution_.status);
}

TEST_F(IslandsTest, ASingleContactIsTheWholeProblem)
{
  solve(twoBowls(1e-3));
  ASSERT_EQ(islands_.islands().size(), 1U);
  EXPECT_EQ(islands_.islands()[0].columns, problem_.patches[0].grid.ny);
  EXPECT_EQ(&islands_.problem(), &problem_);
  EXPECT_EQ(&islands_.solution(), &solution_);
}

TEST_F(IslandsTest, APatchWithoutPressureAndClearedIslandsHaveNone)
{
  CurvedProblem problem = twoBowls(1e-3);
  problem.patches.push_back(problem.patches[0]);
  problem.normals.emplace_back();
  problem.patches[1].gap += 1e-3;
  solve(problem);
  ASSERT_EQ(islands_.islands().size(), 1U);
  ASSERT_EQ(islands_.solution().patches.size(), 1U);
  EXPECT_NEAR(islands_.solution().patches[0].force / solution_.patches[0].force, 1, 1e-12);
  islands_.clear();
  EXPECT_TRUE(islands_.islands().empty());
}

/// Largest depth of the left wheel in the rail along the normals of the rail [m], by samples of both sections.
double sampledDepth(const ContactModelConfig& config, const WheelsetResult& at)
{
  const PlacedWheel wheel(*config.wheel_profile.left, config.wheelset, Side::left, {at.y, at.z, at.yaw, at.roll});
  const PlacedRail rail(config.rail_profile.left, config.track, Side::left);
  double depth = 0;
  for (double u = 0; u < rail.profile().length(); u += 2e-5)
  {
    const PlanePoint origin = rail.at(u);
    const Eigen::Vector2d tangent = Eigen::Vector2d(origin.dy, origin.dz).normalized();
    double across_before = 0, height_before = 0;
    for (double v = 0; v < wheel.profile().length(); v += 1e-4)
    {
      PlanePoint point{};
      wheel.section(wheel.profile().at(v), 0, point);
      const double dy = point.y - origin.y, dz = point.z - origin.z;
      const double across = tangent.x() * dy + tangent.y() * dz, height = tangent.x() * dz - tangent.y() * dy;
      if (v > 0 && (across > 0) != (across_before > 0) && std::abs(height) < 2e-3)
      {
        const double share = across_before / (across_before - across);
        depth = std::max(depth, -height_before - share * (height - height_before));
      }
      across_before = across;
      height_before = height;
    }
  }
  return depth;
}

// Crown, gauge corner and flange: the approach of a patch is the depth of the undeformed bodies along a normal. The
// remaining difference between two grids is the error of the penetration on the coarse one. The chords of the samples,
// 0.1 mm long on radii of 13 mm, are 0.1 µm from the arc.
TEST(Approach, IsTheLargestDepthAlongANormalWhateverTheCells)
{
  for (const double y : {0.0, 3e-3, 4.9e-3, 6.95e-3})
  {
    std::vector<double> approach[2];
    for (const int along : {24, 64})
    {
      ContactModelConfig config = manchesterScene();
      config.contact = {NormalMethod::conjugate_gradient, 1e-3, along, 2 * along};
      WheelsetContact contact(config);
      WheelsetState state;
      state.y = y;
      state.force_z = -200e3;
      const WheelsetResult& result = contact.evaluate(state);
      for (const PatchResult& patch : result.patches)
      {
        approach[along == 24 ? 0 : 1].push_back(patch.approach);
      }
      EXPECT_NEAR(approach[along == 24 ? 0 : 1][0], sampledDepth(config, result), 2e-7) << "y " << y;
    }
    ASSERT_EQ(approach[0].size(), approach[1].size());
    for (std::size_t k = 0; k < approach[0].size(); ++k)
    {
      std::cout << "y " << y << ": " << approach[0][k] << ", " << approach[1][k] << " m\n";
      EXPECT_NEAR(approach[0][k], approach[1][k], 1e-3 * approach[1][k]) << "y " << y;
    }
  }
}
}  // namespace
