// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/kalker_coefficients.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace simulate_wheelset
{
namespace
{
const double pi = std::acos(-1.0);

std::array<double, 4> logarithms(const KalkerCoefficients& c)
{
  return {std::log(c.c11), std::log(c.c22), std::log(c.c23), std::log(c.c33)};
}

TEST(KalkerTable, CircularContactHasTheTabulatedValues)
{
  const KalkerCoefficients c = KalkerTable(0.25).at(1);
  EXPECT_NEAR(c.c11, 4.12, 1e-9);
  EXPECT_NEAR(c.c22, 3.67, 1e-9);
  EXPECT_NEAR(c.c23, 1.47, 1e-9);
  EXPECT_NEAR(c.c33, 1.19, 1e-9);
}

TEST(KalkerTable, NarrowContactApproachesStripTheory)
{
  // Limits for a/b = g to 0 (Kalker 1990, appendix E). At g = 0.1 the remainder is a few per cent; for C23 it is 7 %.
  const double g = 0.1;
  for (const double poisson : {0.0, 0.25, 0.5})
  {
    const KalkerCoefficients c = KalkerTable(poisson).at(g);
    EXPECT_NEAR(c.c11 / (pi * pi / (4 * (1 - poisson))), 1, 0.03) << poisson;
    EXPECT_NEAR(c.c22 / (pi * pi / 4), 1, 0.03) << poisson;
    EXPECT_NEAR(c.c23 / (pi * std::sqrt(g) / (3 * (1 - poisson))), 1, 0.12) << poisson;
    EXPECT_NEAR(c.c33 / (pi * pi / (16 * (1 - poisson) * g)), 1, 0.06) << poisson;
  }
}

TEST(KalkerTable, CurvesAreSmooth)
{
  // A wrong digit in a row makes a kink. The slopes in logarithms of neighbouring intervals differ by up to 0.12,
  // because the values of the table have three digits; one wrong unit in the second digit changes them by 0.2 and more.
  const std::vector<double> ratios = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
  for (const double poisson : {0.0, 0.25, 0.5})
  {
    const KalkerTable table(poisson);
    for (const bool is_long : {false, true})
    {
      for (std::size_t i = 1; i + 1 < ratios.size(); ++i)
      {
        const auto at = [&](std::size_t k) { return logarithms(table.at(is_long ? 1 / ratios[k] : ratios[k])); };
        const auto before = at(i - 1), here = at(i), after = at(i + 1);
        for (std::size_t k = 0; k < here.size(); ++k)
        {
          const double first = (here[k] - before[k]) / std::log(ratios[i] / ratios[i - 1]);
          const double second = (after[k] - here[k]) / std::log(ratios[i + 1] / ratios[i]);
          EXPECT_NEAR(first, second, 0.15)
              << "C" << k << ", ratio " << ratios[i] << ", long " << is_long << ", " << poisson;
        }
      }
    }
  }
}

TEST(KalkerTable, LiesBetweenItsNeighboursAndContinuesBeyondItsEnds)
{
  const KalkerTable table(0.28);
  EXPECT_GT(table.at(1.05).c22, table.at(1).c22);
  EXPECT_LT(table.at(1.05).c22, table.at(1 / 0.9).c22);
  EXPECT_TRUE(KalkerTable::contains(0.1));
  EXPECT_TRUE(KalkerTable::contains(10));
  EXPECT_FALSE(KalkerTable::contains(10.1));
  EXPECT_FALSE(KalkerTable::contains(0.09));
  EXPECT_NEAR(table.at(20).c22 / table.at(10).c22, table.at(10).c22 / table.at(5).c22, 1e-9);
}

TEST(KalkerTable, RefusesAnImpossiblePoissonRatio)
{
  EXPECT_THROW(KalkerTable(-0.01), std::invalid_argument);
  EXPECT_THROW(KalkerTable(0.51), std::invalid_argument);
  EXPECT_THROW(KalkerTable(std::nan("")), std::invalid_argument);
}
}  // namespace
}  // namespace simulate_wheelset
