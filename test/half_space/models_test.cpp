// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "core/balance/patch_result.h"
#include "half_space/cell_grids.h"
#include "half_space/models.h"
#include "half_space/planar_gap.h"
#include "wheel_rail_contact/core/profile_reader.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::half_space;

namespace
{
constexpr double load = 60e3;  // [N]

ContactModelConfig standardConfig()
{
  ContactModelConfig config;
  config.wheel_profile = std::make_shared<const Profile>(s1002Wheel());
  config.rail_profile = std::make_shared<const Profile>(rail60E1());
  return config;
}

/// Relative difference of the maximum pressures of two models at a lateral position [-].
double pressureDifference(double y, Model model, Model reference)
{
  const ContactModelConfig config = standardConfig();
  LoadedWheel wheel(config);
  wheel.solve(y, load);
  return solveModel(config, wheel, model).front().max_pressure /
             solveModel(config, wheel, reference).front().max_pressure -
         1;
}
}  // namespace

TEST(LoadedWheel, CarriesTheLoadAndHasTheRatioOfTheResult)
{
  ContactModelConfig config = standardConfig();
  LoadedWheel wheel(config);
  wheel.solve(6.5e-3, load);
  EXPECT_NEAR(wheel.contact().forces()[wheel_up], load, 1e-6 * load);  // the load is held to rounding
  config.wheelset.solve_height_and_roll = false;
  WheelsetState state;
  state.y = wheel.pose().y;
  state.z = wheel.pose().z;
  const WheelsetResult result = WheelsetContact(config).evaluate(state);
  ASSERT_FALSE(result.patches.empty()) << result.reason;
  // Both are the turn between the outer loaded columns: they differ by a cell of the coarser grid.
  EXPECT_NEAR(wheel.parts().front().half_space_ratio, result.patches.front().half_space_ratio, 0.02);
  EXPECT_EQ(result.patches.front().model_error, modelError(result.patches.front().half_space_ratio, true));
}

TEST(LoadedWheel, WithoutContactIsRefusedWithThePosition)
{
  const ContactModelConfig config = standardConfig();
  LoadedWheel wheel(config);
  try
  {
    wheel.solve(0.3, load);
    FAIL() << "a wheel beside the rail has a contact";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("y = 0.3 m"), std::string::npos) << error.what();
  }
}

TEST(Models, AgreeOnTheTread)
{
  // The normals turn by 0.04 rad, whose square is 0.002. A plane has other cells, so the peak differs a little more.
  EXPECT_NEAR(pressureDifference(0, Model::curved, Model::turned), 0, 0.002);
  EXPECT_NEAR(pressureDifference(0, Model::planar, Model::turned), 0, 0.005);
}

TEST(Models, OnePlaneLowersThePressureInTheFlangeRoot)
{
  const double planar = pressureDifference(6.6e-3, Model::planar, Model::turned);
  EXPECT_LT(planar, -0.02);
  EXPECT_GT(planar, -0.1);
}

TEST(PlanarGap, HasTheOpeningAndTheDepthOfTheSurfaceAtItsPlane)
{
  const ContactModelConfig config = standardConfig();
  LoadedWheel wheel(config);
  wheel.solve(6.2e-3, load);
  const PatchGap& patch = wheel.contact().problem().patches.front();
  const std::vector<SurfaceColumn>& columns = wheel.contact().grids().columns().front();
  Eigen::Index row = 0, touch = 0;
  patch.gap.minCoeff(&row, &touch);
  const PlacedWheel placed(*config.wheel_profile.left, config.wheelset, Side::left, wheel.pose());
  const PatchGap planar = planarGap(placed, wheel.rail(), columns, patch.grid, touch);
  ASSERT_GT(planar.gap.size(), 0);
  EXPECT_EQ(planar.weight, columns[static_cast<std::size_t>(touch)].cosine);
  // The pose is within 1e-4 of the overlap of that of the grid.
  EXPECT_NEAR(planar.gap(row, touch), patch.gap(row, touch), -2e-4 * patch.gap(row, touch));
}

TEST(CellGrids, CoverThePressedPartsOfAllLoads)
{
  const ContactModelConfig config = standardConfig();
  LoadedWheel wheel(config);
  std::vector<std::vector<PressedPart>> parts;
  for (const double one : {20e3, 120e3})
  {
    wheel.solve(6.5e-3, one);
    parts.push_back(wheel.parts());
  }
  const std::vector<CellGrid> grids = cellGrids(wheel.rail(), parts, {8, 12});
  ASSERT_EQ(grids.size(), 1U);
  const Grid& grid = grids.front().grid;
  EXPECT_EQ(grid.rows(), 8);
  EXPECT_EQ(grid.ny, 12);
  for (const auto& of_load : parts)
  {
    const PressedPart& part = of_load.front();
    const auto place = [&](double u) { return arcLength(wheel.rail().profile(), grids.front().origin.rail_u, u); };
    EXPECT_LT(grid.y(0) - 0.5 * grid.dy, place(part.u_first));
    EXPECT_GT(grid.y(grid.ny - 1) + 0.5 * grid.dy, place(part.u_last));
    EXPECT_GT(grid.rows() * grid.dx, part.x_most);
  }
}

TEST(CellGrids, TooFewCellsAreRefused)
{
  const ContactModelConfig config = standardConfig();
  LoadedWheel wheel(config);
  wheel.solve(0, load);
  EXPECT_THROW(cellGrids(wheel.rail(), {wheel.parts()}, {1, 12}), std::invalid_argument);
}
