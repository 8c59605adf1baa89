// SPDX-License-Identifier: BSD-3-Clause
#include "../../usual_headers.h"
#include "wheel_rail_contact/core/creep.h"

namespace wheel_rail_contact::core
{
namespace
{
std::array<double, 4> logarithmsAt(double ratio, double poisson)
{
  const KalkerCoefficients c = kalkerCoefficients(ratio, poisson);
  return {std::log(c.c11), std::log(c.c22), std::log(c.c23), std::log(c.c33)};
}

TEST(KalkerCoefficients, AreTheTabulatedOnesLieBetweenTheRowsAndContinueBeyondTheEnds)
{
  const KalkerCoefficients c = kalkerCoefficients(1, 0.25);
  EXPECT_NEAR(c.c11, 4.12, 1e-9);
  EXPECT_NEAR(c.c22, 3.67, 1e-9);
  EXPECT_NEAR(c.c23, 1.47, 1e-9);
  EXPECT_NEAR(c.c33, 1.19, 1e-9);
  const auto c22 = [](double ratio) { return kalkerCoefficients(ratio, 0.28).c22; };
  EXPECT_GT(c22(1.05), c22(1));
  EXPECT_LT(c22(1.05), c22(1 / 0.9));
  EXPECT_NEAR(c22(20) / c22(10), c22(10) / c22(5), 1e-9);
  EXPECT_NEAR(c22(0.05) / c22(0.1), c22(0.1) / c22(0.2), 1e-9);
}

TEST(KalkerCoefficients, CurvesAreSmooth)
{
  // A wrong digit in a row makes a kink. The slopes in logarithms of neighbouring intervals differ by up to 0.12,
  // because the values of the table have three digits; one wrong unit in the second digit changes them by 0.2 and more.
  const std::vector<double> ratios = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
  for (const double poisson : {0.0, 0.25, 0.5})
  {
    for (const bool is_long : {false, true})
    {
      for (std::size_t i = 1; i + 1 < ratios.size(); ++i)
      {
        const auto at = [&](std::size_t k) { return logarithmsAt(is_long ? 1 / ratios[k] : ratios[k], poisson); };
        const auto before = at(i - 1), here = at(i), after = at(i + 1);
        for (std::size_t k = 0; k < here.size(); ++k)
        {
          const double first = (here[k] - before[k]) / std::log(ratios[i] / ratios[i - 1]);
          const double second = (after[k] - here[k]) / std::log(ratios[i + 1] / ratios[i]);
          EXPECT_NEAR(first, second, 0.15) << "C" << k << ", ratio " << ratios[i] << ", " << is_long << ", " << poisson;
        }
      }
    }
  }
}

TEST(KalkerCoefficients, RefuseImpossibleNumbers)
{
  EXPECT_THROW(kalkerCoefficients(1, -0.01), std::invalid_argument);
  EXPECT_THROW(kalkerCoefficients(1, 0.51), std::invalid_argument);
  EXPECT_THROW(kalkerCoefficients(0, 0.3), std::invalid_argument);
  EXPECT_THROW(kalkerCoefficients(std::nan(""), 0.3), std::invalid_argument);
}
}  // namespace
}  // namespace wheel_rail_contact::core
