// SPDX-License-Identifier: BSD-3-Clause
// Stress beneath the patches of a wheelset.
#include <gtest/gtest.h>

#include <cmath>

#include "round_bodies.h"

using namespace wheel_rail_contact::core;

namespace
{
ContactModelConfig roundScene(const StressConfig& stress)
{
  ContactModelConfig scene = round_bodies::scene(0.05);
  scene.stress = stress;
  return scene;
}

ContactModelConfig standardScene(const StressConfig& stress)
{
  ContactModelConfig scene = manchesterScene();
  scene.stress = stress;
  return scene;
}
}  // namespace

TEST(PatchStress, IsNotComputedByDefault)
{
  WheelsetContact contact(roundScene({}));
  const PatchResult& patch = contact.evaluate(stateAt(0, 1e5)).patches.at(0);
  EXPECT_EQ(patch.rail_stress.von_mises.value, 0);
  EXPECT_EQ(patch.wheel_stress.shakedown_limit, 0);
  EXPECT_TRUE(patch.rail_stress.field.empty());
}

// Semi-axes 6.4 and 5.4 mm: between 0.62 p0 at 0.48 a (circle, nu = 0.3) and 0.56 p0 at 0.70 b (line).
TEST(PatchStress, OfAHertzContactIsThatOfTheExactPressure)
{
  WheelsetContact contact(roundScene({16, false}));
  const PatchResult& patch = contact.evaluate(stateAt(0, 1e5)).patches.at(0);
  const HertzContact hertz = round_bodies::exactContact(contact.config(), 0.05, 0, 1e5);
  const double a = hertz.semi_axis_x, b = hertz.semi_axis_y;
  Eigen::ArrayXXd pressure(64, 64);
  const PatchGrid grid{64, 64, a / 30, b / 30, -31.5 * a / 30, -31.5 * b / 30};
  for (int k = 0; k < 64 * 64; ++k)
  {
    const double x = grid.x(k % 64) / a, y = grid.y(k / 64) / b;
    pressure(k % 64, k / 64) = hertz.max_pressure * std::sqrt(std::max(0.0, 1 - x * x - y * y));
  }
  double von_mises = 0, depth = 0;
  for (double z = 0.2 * b; z < b; z += 0.005 * b)
  {
    const double here = vonMises(stressAt(grid, pressure, 0.28, {0, 0, z}));
    depth = here > von_mises ? z : depth;
    von_mises = std::max(von_mises, here);
  }
  EXPECT_NEAR(patch.rail_stress.von_mises.value, von_mises, 0.01 * von_mises);
  EXPECT_NEAR(patch.rail_stress.von_mises.depth, depth, 0.04 * depth);
  EXPECT_NEAR(patch.rail_stress.von_mises.x, 0, 0.05 * a);
  EXPECT_NEAR(patch.rail_stress.von_mises.y, 0, 0.05 * b);
  EXPECT_EQ(patch.wheel_stress.von_mises.value, patch.rail_stress.von_mises.value);
}

TEST(PatchStress, LoadFactorUsesTheYieldStressOfEachBody)
{
  ContactModelConfig scene = roundScene({16, false});
  scene.wheel_material.left.yield = 600e6;
  scene.wheel_material.left.young = 2.0e11;
  WheelsetContact contact(scene);
  const PatchResult& patch = contact.evaluate(stateAt(0, 1e5)).patches.at(0);
  EXPECT_NEAR(patch.wheel_stress.load_factor, patch.max_pressure * std::sqrt(3.0) / 600e6, 1e-12);
  EXPECT_EQ(patch.rail_stress.load_factor, 0);
  EXPECT_EQ(patch.wheel_stress.shakedown_limit, patch.rail_stress.shakedown_limit);
  EXPECT_GT(patch.wheel_stress.shakedown_limit, 4.4);  // between line and circle, and longer along the track than wide
  EXPECT_LT(patch.wheel_stress.shakedown_limit, 5.5);
}

TEST(PatchStress, DependsOnPoissonsRatioOfTheBody)
{
  ContactModelConfig scene = roundScene({16, false});
  scene.wheel_material.left.poisson = 0.45;
  WheelsetContact contact(scene);
  const PatchResult& patch = contact.evaluate(stateAt(0, 1e5)).patches.at(0);
  EXPECT_LT(patch.wheel_stress.von_mises.value, 0.95 * patch.rail_stress.von_mises.value);
}

// Up to two contacts on a wheel, with yaw. The layers are sampled below the cells alone.
TEST(PatchStress, FieldHasTheShapeOfTheGridAndContainsTheMaximum)
{
  WheelsetContact contact(standardScene({40, true}));
  for (const double y : {0.0, 3e-3, -5.5e-3, 6.2e-3})
  {
    const WheelsetResult& result = contact.evaluate(stateAt(y, 1e5, 2e-3));
    ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
    for (const PatchResult& patch : result.patches)
    {
      ASSERT_EQ(patch.rail_stress.field.size(), 40U);
      double highest = 0;
      for (const StressLayer& layer : patch.rail_stress.field)
      {
        ASSERT_EQ(layer.components[5].rows(), patch.grid.nx);
        ASSERT_EQ(layer.components[5].cols(), patch.grid.ny);
        for (Eigen::Index k = 0; k < patch.pressure.size() && layer.depth > 0; ++k)
        {
          highest = std::max(highest, vonMises(layer.at(k % patch.grid.nx, k / patch.grid.nx)));
        }
      }
      if (patch.normal_force > 2e4)  // below a small patch, the stress of its neighbour may be higher at its border
      {
        EXPECT_NEAR(patch.rail_stress.von_mises.value, highest, 0.03 * highest) << y;
      }
    }
  }
}

TEST(PatchStress, LeftAndRightAreMirrorImages)
{
  WheelsetContact contact(standardScene({8, true}));
  const WheelsetResult left = contact.evaluate(stateAt(5e-3, 1e5));
  contact.reset();
  const WheelsetResult right = contact.evaluate(stateAt(-5e-3, 1e5));
  ASSERT_EQ(left.patches.size(), right.patches.size());
  std::size_t compared = 0;
  for (const PatchResult& one : left.patches)
  {
    for (const PatchResult& other : right.patches)
    {
      if (other.side == one.side || other.normal_force != one.normal_force)
      {
        continue;
      }
      EXPECT_DOUBLE_EQ(one.rail_stress.von_mises.value, other.rail_stress.von_mises.value);
      EXPECT_NEAR(one.rail_stress.von_mises.y, -other.rail_stress.von_mises.y, 1e-9);
      EXPECT_DOUBLE_EQ(one.rail_stress.shear.depth, other.rail_stress.shear.depth);
      ++compared;
      const StressLayer &layer = one.rail_stress.field[3], &mirrored = other.rail_stress.field[3];
      EXPECT_TRUE(layer.components[0].isApprox(mirrored.components[0].rowwise().reverse(), 1e-9));
      EXPECT_TRUE(layer.components[3].isApprox(-mirrored.components[3].rowwise().reverse(), 1e-9));
    }
  }
  EXPECT_EQ(compared, left.patches.size());
}

// The highest pressure is a narrow peak at the end of a conformal contact, 20 times as close to the surface as the
// maximum below the rest of the patch. Reference: layers on 64 × 256 cells; 24 × 64 cells resolve the peak less.
TEST(PatchStress, OfANarrowPeakIsNotMissed)
{
  ContactModelConfig scene = standardScene({4, false});
  scene.rail_profile = std::make_shared<Profile>(rail60E1());
  WheelsetContact contact(scene);
  double highest = 0, depth = 0;
  for (const PatchResult& patch : contact.evaluate(stateAt(6.29e-3, 5e4, 5e-3)).patches)
  {
    depth = patch.rail_stress.von_mises.value > highest ? patch.rail_stress.von_mises.depth : depth;
    highest = std::max(highest, patch.rail_stress.von_mises.value);
  }
  EXPECT_NEAR(highest, 929e6, 0.04 * 929e6);
  EXPECT_LT(depth, 0.4e-3);
}
