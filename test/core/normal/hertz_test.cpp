// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/hertz.h"

#include "../../seeded.h"
#include "problems.h"

using namespace wheel_rail_contact::core;

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

// Contacts smaller than the cells: their error estimate must be above the tolerance, whatever the pressure.

/// Bowl at a random position between the cells of a grid, with curvatures and load over many decades.
NormalProblem randomBowl(std::mt19937& random)
{
  constexpr double cell = 1e-3;
  const auto between = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  const auto spread = [&](double low, double high) { return std::exp(between(std::log(low), std::log(high))); };
  const bool symmetric = random() % 2 == 0;
  const Grid grid = problems::centredGrid(8, 16, 8 * cell, 16 * cell * spread(0.4, 2.5), symmetric);
  const double x0 = symmetric ? 0 : between(-0.5, 0.5) * grid.dx, y0 = between(-0.5, 0.5) * grid.dy;
  const double along = 0.5 / spread(0.02, 7), across = 0.5 / spread(0.007, 3);
  const auto bowl = [=](double x, double y) { return along * (x - x0) * (x - x0) + across * (y - y0) * (y - y0); };
  return problems::underLoad(problems::sampled(grid, bowl), spread(0.02, 2e4));
}

// The largest tolerance used is 10 %. The smallest estimate of 2800 such contacts was 11.6 %.
TEST(Spike, FewerThanThreeLoadedCellsAreEstimatedAboveTenPercent)
{
  Seeded random(3);
  ConjugateGradients solver;
  int spikes = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const NormalProblem problem = randomBowl(random);
    const NormalSolution solution = problems::solved(solver, problem);
    if (isUsable(solution.status) && (solution.patches[0].pressure > 0).count() < 3)
    {
      ++spikes;
      EXPECT_GT(errorsOf(solver, problem, solution)[0].largest(), 0.1);
    }
  }
  EXPECT_GT(spikes, 100);
}
}  // namespace
