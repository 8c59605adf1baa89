// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/hertz.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hertz_load.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double modulus = 1.14e11, force = 1e5;

TEST(Hertz, SphereHasItsClosedForm)
{
  const double radius = 0.46;
  const HertzContact contact = hertzForForce({0.5 / radius, 0.5 / radius}, modulus, force);
  // Johnson 1985, eq. 4.22 to 4.24.
  const double a = std::cbrt(3 * force * radius / (4 * modulus));
  EXPECT_EQ(contact.status, SolveStatus::converged);
  EXPECT_NEAR(contact.semi_axis_x / a, 1, 1e-12);
  EXPECT_NEAR(contact.semi_axis_y / a, 1, 1e-12);
  EXPECT_NEAR(contact.approach / (a * a / radius), 1, 1e-12);
  EXPECT_NEAR(contact.max_pressure / (1.5 * force / (std::acos(-1.0) * a * a)), 1, 1e-12);
}

TEST(Hertz, EllipsesObeyJohnsonsEquations)
{
  for (const double ratio : {1.0001, 1.1, 2.0, 5.0, 10.0, 1e3, 1e6})
  {
    const GapCurvature gap = {1.1, 1.1 * ratio};
    const HertzContact contact = hertzForForce(gap, modulus, force);
    const double a = contact.semi_axis_x, b = contact.semi_axis_y, p = contact.max_pressure;
    const double e = std::sqrt((a - b) * (a + b)) / a;
    const double K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
    // Eq. 4.26a to c. The difference K - E loses digits near the circle.
    const double lost = 1e-14 / (e * e);
    EXPECT_NEAR(p / modulus * b / (e * e * a * a) * (K - E) / gap.a, 1, 1e-9 + lost) << ratio;
    EXPECT_NEAR(p / modulus * b / (e * e * a * a) * (a * a / (b * b) * E - K) / gap.b, 1, 1e-9 + lost) << ratio;
    EXPECT_NEAR(p / modulus * b * K / contact.approach, 1, 1e-9) << ratio;
    EXPECT_NEAR(contact.force / force, 1, 1e-12) << ratio;
    EXPECT_NEAR(contact.area / (std::acos(-1.0) * a * b), 1, 1e-12) << ratio;
  }
}

TEST(Hertz, LongerAxisLiesAlongTheSmallerCurvature)
{
  for (const double ratio : {0.01, 0.5, 30.0})
  {
    const HertzContact contact = hertzForApproach({2.0, 2.0 * ratio}, modulus, 1e-4);
    EXPECT_EQ(contact.semi_axis_x > contact.semi_axis_y, ratio > 1);
  }
}

TEST(Hertz, HasNoResultWithoutPositiveCurvature)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double approach = 1e-4;
  EXPECT_EQ(hertzForApproach({1, 0}, modulus, approach).status, SolveStatus::invalid_problem);
  EXPECT_EQ(hertzForApproach({-1, 1}, modulus, approach).status, SolveStatus::invalid_problem);
  EXPECT_EQ(hertzForApproach({1, nan}, modulus, approach).status, SolveStatus::invalid_problem);
  EXPECT_EQ(hertzForApproach({1, 1}, modulus, nan).status, SolveStatus::invalid_problem);
  EXPECT_EQ(hertzForApproach({1, 1}, 0, approach).status, SolveStatus::invalid_problem);
  EXPECT_EQ(hertzForApproach({1, 1}, modulus, -1e-6).status, SolveStatus::no_contact);
  EXPECT_EQ(hertzForApproach({1, 1}, modulus, -1e-6).force, 0);
}
}  // namespace
}  // namespace wheel_rail_contact::core
