// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/stress.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

using namespace wheel_rail_contact::core;

TEST(Stress, VonMisesStressOfUniaxialAndShearStress)
{
  EXPECT_DOUBLE_EQ(vonMises({5, 0, 0, 0, 0, 0}), 5);
  EXPECT_DOUBLE_EQ(vonMises({0, 0, 0, 0, 2, 0}), 2 * std::sqrt(3.0));
  EXPECT_NEAR(vonMises({-7, -7, -7, 0, 0, 0}), 0, 1e-14);
}

TEST(Stress, PrincipalStressesAreTheEigenvaluesOfTheTensor)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  for (int k = 0; k < 200; ++k)
  {
    const Stress s{value(random), value(random), value(random), value(random), value(random), value(random)};
    Eigen::Matrix3d tensor;
    tensor << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    const Eigen::Vector3d expected = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor).eigenvalues();
    const std::array<double, 3> found = principalStresses(s);
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(found[i], expected[2 - static_cast<Eigen::Index>(i)], 1e-7);  // rounding where two are close
    }
    EXPECT_NEAR(maxShear(s), 0.5 * (expected[2] - expected[0]), 1e-7);
  }
}

TEST(Stress, HydrostaticStressHasEqualPrincipalStresses)
{
  for (const double principal : principalStresses({-3, -3, -3, 0, 0, 0}))
  {
    EXPECT_DOUBLE_EQ(principal, -3);
  }
  EXPECT_DOUBLE_EQ(maxShear({-3, -3, -3, 0, 0, 0}), 0);
}

TEST(Stress, StrainFollowsHookesLaw)
{
  const Material steel{2e11, 0.3, 0};
  const Strain pulled = strainOf({4e8, 0, 0, 0, 0, 0}, steel);
  EXPECT_DOUBLE_EQ(pulled.xx, 2e-3);
  EXPECT_DOUBLE_EQ(pulled.yy, -0.6e-3);
  const Strain sheared = strainOf({0, 0, 0, 0, 1e8, 0}, steel);
  EXPECT_DOUBLE_EQ(sheared.xz, 1e8 * 1.3 / 2e11);  // half of tau / G
  EXPECT_THROW(strainOf({}, Material{-1, 0.3, 0}), std::invalid_argument);
}

TEST(Stress, ConfigurationIsChecked)
{
  EXPECT_NO_THROW(validate(StressConfig{0, false}));
  EXPECT_NO_THROW(validate(StressConfig{4, true}));
  EXPECT_THROW(validate(StressConfig{3, false}), std::invalid_argument);
  EXPECT_THROW(validate(StressConfig{65, false}), std::invalid_argument);
  EXPECT_THROW(validate(StressConfig{0, true}), std::invalid_argument);
}
