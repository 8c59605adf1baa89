// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/stress_search.h"

#include <gtest/gtest.h>

#include "pressures.h"

using namespace wheel_rail_contact::core;
using pressures::Cells;

namespace
{
double alternating(const Stress& stress)
{
  return std::abs(stress.xz);
}

/// Highest value of a measure in layers below all cells.
double highestInLayers(const Cells& cells, double unit, double (*measure)(const Stress&))
{
  std::vector<double> depths;
  for (int k = 1; k <= 30; ++k)
  {
    depths.push_back(0.05 * k * unit);
  }
  double highest = 0;
  for (const StressLayer& layer : stressLayers(cells.grid, cells.pressure, 0.3, depths))
  {
    for (Eigen::Index k = 0; k < cells.pressure.size(); ++k)
    {
      highest = std::max(highest, measure(layer.at(k % cells.grid.nx, k / cells.grid.nx)));
    }
  }
  return highest;
}

HighestStresses search(const Cells& cells, const SemiAxes& axes)
{
  StressSearch search;
  search.set(cells.grid, cells.pressure, {0, cells.grid.ny}, axes);
  return search.find(0.3);
}
}  // namespace

// The depths of the maxima are those of Johnson 1985, sec. 3.4 and 4.2. On 12 × 24 cells the pressure itself has errors
// of 0.5 %; |xz| lies near the ends of the contact, which the cells resolve less.
TEST(StressSearch, FindsTheMaximaBelowEllipsesOfHertz)
{
  for (const double ratio : {0.25, 0.5, 1.0, 2.0, 4.0})
  {
    const double a = ratio, b = 1, unit = std::min(a, b);
    const Cells fine = pressures::hertz(64, 64, a, b);
    const double von_mises = highestInLayers(fine, unit, vonMises), shear = highestInLayers(fine, unit, maxShear);
    const double orthogonal = highestInLayers(fine, unit, alternating);
    for (const auto& [nx, ny] : {std::pair{12, 24}, std::pair{16, 32}, std::pair{32, 96}})
    {
      const HighestStresses highest = search(pressures::hertz(nx, ny, a, b), {a, b});
      EXPECT_NEAR(highest.von_mises.value, von_mises, 0.01 * von_mises) << ratio << " " << nx;
      EXPECT_NEAR(highest.shear.value, shear, 0.01 * shear) << ratio << " " << nx;
      EXPECT_NEAR(highest.orthogonal.value, orthogonal, 0.04 * orthogonal) << ratio << " " << nx;
      EXPECT_NEAR(highest.von_mises.x, 0, 0.03 * a);
      EXPECT_NEAR(highest.von_mises.y, 0, 0.03 * b);
    }
  }
  const HighestStresses round = search(pressures::hertz(32, 32, 1, 1), {1, 1});
  EXPECT_NEAR(round.von_mises.depth, 0.48, 0.02);
  EXPECT_NEAR(round.shear.depth, 0.48, 0.02);
  EXPECT_NEAR(1 / round.orthogonal.value, 4.68, 0.05);
}

// A narrow peak of the pressure beside a wide contact, as below an edge of a worn profile.
TEST(StressSearch, FindsANarrowPeakOffTheCentre)
{
  Cells cells = pressures::hertz(48, 96, 1, 2);
  for (int j = 0; j < cells.grid.ny; ++j)
  {
    const double distance = (cells.grid.y(j) - 1.3) / 0.15;
    cells.pressure.col(j) *= 1 + 2 * std::exp(-distance * distance);
  }
  const double von_mises = highestInLayers(cells, 1, vonMises);
  const HighestStresses highest = search(cells, {1, 2});
  EXPECT_NEAR(highest.von_mises.value, von_mises, 0.03 * von_mises);
  EXPECT_NEAR(highest.von_mises.y, 1.3, 0.05);
}

TEST(StressSearch, ColumnsOfOtherPatchesAreNotSearched)
{
  Cells cells = pressures::hertz(16, 32, 1, 1);
  cells.pressure.rightCols(16) *= 0.1;
  StressSearch search;
  search.set(cells.grid, cells.pressure, {16, 16}, {1, 0.5});
  const HighestStresses right = search.find(0.3);
  search.set(cells.grid, cells.pressure, {0, 16}, {1, 0.5});
  EXPECT_LT(right.von_mises.value, search.find(0.3).von_mises.value);
}
