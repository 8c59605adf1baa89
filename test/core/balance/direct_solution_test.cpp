// SPDX-License-Identifier: BSD-3-Clause
#include "../normal/dense_active_set.h"
#include "core/balance/rail_support.h"
#include "core/track/gap.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
/// Pressure of the left wheel of a result without yaw, by factorisations of the matrix of the loaded cells (Love 1929),
/// on fewer cells than its own. The forces are the changes of the energy.
struct DirectSolution
{
  double up = 0, inward = 0, max_pressure = 0;  ///< forces on the wheel [N], pressure of the highest cell [Pa]

  DirectSolution(const ContactModelConfig& config, const WheelsetResult& result)
  {
    const PatchResult& patch = result.patches.front();
    const Profile &rail = *config.rail_profile.left, &wheel = *config.wheel_profile.left;
    Eigen::Index begin = 0;
    (patch.pressure.colwise().maxCoeff() > 0).cast<int>().maxCoeff(&begin);
    const double rows = static_cast<double>((patch.pressure.rowwise().maxCoeff() > 0).count());
    const double width = patch.grid.dy * static_cast<double>((patch.pressure.colwise().maxCoeff() > 0).count());
    NormalProblem problem;
    problem.patches.resize(1);
    problem.modulus = problems::steel();
    problem.control = NormalProblem::Control::approach;
    Grid& grid = problem.patches[0].grid;
    grid = problems::centredGrid(32, 48, 1.1 * rows * patch.grid.dx, 1.1 * width, true);
    grid.y0 += patch.grid.y(static_cast<int>(begin)) + 0.5 * (width - patch.grid.dy);

    std::vector<SurfaceColumn> columns;
    const auto gap_at = [&](double outward, double upward)
    {
      const PlacedWheel placed(wheel, config.wheelset, Side::left,
                               {result.y + outward, result.z + upward, 0, result.roll});
      const SurfaceOrigin origin{0, rail.partAt(0).origin + patch.rail_s, wheel.partAt(0).origin + patch.wheel_s};
      Eigen::ArrayXXd gap, slope;
      EXPECT_TRUE(buildSurfaceGap(placed, restingRail(config, Side::left), origin, grid, gap, slope, columns));
      return gap;
    };
    constexpr double move = 1e-7;  // [m]
    problem.patches[0].gap = gap_at(0, 0);
    const Eigen::ArrayXXd raised = gap_at(0, move), moved = gap_at(move, 0);
    ColumnNormals normals;
    normals.turn.resize(grid.ny);
    std::transform(columns.begin(), columns.end(), normals.turn.data(), [](const auto& one) { return one.angle(); });
    const Eigen::ArrayXXd pressure = problems::DenseActiveSet(problem, {normals}).solve().pressure.front();
    up = grid.cellArea() / move * (pressure * (raised - problem.patches[0].gap)).sum();
    inward = -grid.cellArea() / move * (pressure * (moved - problem.patches[0].gap)).sum();
    max_pressure = pressure.maxCoeff();
  }
};
}  // namespace

// The reference of test/calibration/estimate_coverage.cpp on tread, gauge corner, root and flange. At a given height,
// the force on 29 loaded cells along the track is 0.02 % high, and depends on their place by as much.
TEST(DirectSolution, AgreesWithTheFinestGrid)
{
  ContactModelConfig config = manchesterScene();
  config.contact = {NormalMethod::conjugate_gradient, 1e-3, 128, 256};
  WheelsetContact contact(config);
  for (const double y : {0.0, 5.5e-3, 6.25e-3, 7e-3})
  {
    const WheelsetResult& result = contact.evaluate(stateAt(y, wheel_load));
    ASSERT_EQ(wheelTotal(result, Side::left).patches, 1) << "y " << y;
    const DirectSolution direct(config, result);
    EXPECT_NEAR(direct.up / wheel_load, 1, 1e-3) << "y " << y;
    EXPECT_NEAR(direct.inward / result.rail.left.lateral_force, 1, 1e-3) << "y " << y;
    EXPECT_NEAR(direct.max_pressure / result.patches.front().max_pressure, 1, 3e-3) << "y " << y;
  }
}
