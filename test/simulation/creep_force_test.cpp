// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/creep_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace simulate_wheelset
{
namespace
{
const ContactEllipse ellipse = {0.006, 0.005, 100e3};
const CreepParameters parameters;

TEST(CreepForce, SmallCreepageFollowsTheLinearTheory)
{
  const CreepLaw law(parameters);
  const KalkerCoefficients c = KalkerTable(parameters.poisson).at(1.2);
  const double product = ellipse.along * ellipse.across, cube = std::pow(product, 1.5);
  const double g = parameters.shear_modulus, small = 1e-9;
  // The saturation changes the force by a third of its ratio to the limit, here 1e-5.
  EXPECT_NEAR(law.force(ellipse, {small, 0, 0}).along / (-g * product * c.c11 * small), 1, 1e-5);
  EXPECT_NEAR(law.force(ellipse, {0, small, 0}).across / (-g * product * c.c22 * small), 1, 1e-5);
  EXPECT_NEAR(law.force(ellipse, {0, small, 0}).moment / (g * cube * c.c23 * small), 1, 1e-5);
  EXPECT_NEAR(law.force(ellipse, {0, 0, small}).across / (-g * cube * c.c23 * small), 1, 1e-5);
  EXPECT_NEAR(law.force(ellipse, {0, 0, small}).moment / (-g * product * product * c.c33 * small), 1, 1e-5);
}

TEST(CreepForce, GrowsMonotonicallyToTheFrictionLimit)
{
  const CreepLaw law(parameters);
  const double limit = parameters.friction * ellipse.normal_force;
  double last = 0;
  for (int i = 1; i <= 200; ++i)
  {
    const CreepForce force = law.force(ellipse, {5e-5 * i, 2e-5 * i, 0});
    const double resultant = std::hypot(force.along, force.across);
    EXPECT_LE(resultant, limit * (1 + 1e-12));
    EXPECT_GE(resultant, last * (1 - 1e-12));
    last = resultant;
  }
  EXPECT_NEAR(last, limit, 1e-9 * limit);
}

TEST(CreepForce, FrictionNeverDrives)
{
  const unsigned seed = 20;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const CreepLaw law(parameters);
  for (int i = 0; i < 1000; ++i)
  {
    const Creepage creepage = {0.01 * unit(random), 0.01 * unit(random), unit(random)};
    const ContactEllipse shape = {0.006 * (1.1 + unit(random)), 0.005 * (1.1 + unit(random)), 100e3};
    const CreepForce force = law.force(shape, creepage);
    const double power = force.along * creepage.along + force.across * creepage.across + force.moment * creepage.spin;
    EXPECT_LE(power, 0) << "seed " << seed << ", case " << i;
  }
}

TEST(CreepForce, NoCreepageHasNoForce)
{
  const CreepForce force = CreepLaw(parameters).force(ellipse, {});
  EXPECT_EQ(force.along, 0);
  EXPECT_EQ(force.across, 0);
  EXPECT_EQ(force.moment, 0);
}
}  // namespace
}  // namespace simulate_wheelset
