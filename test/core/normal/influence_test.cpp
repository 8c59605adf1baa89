// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "core/normal/operator/influence.h"
#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Integral of 1/rho over the rectangle by Gauss–Legendre quadrature with 5 × 5 points on 40 × 40 parts. Exact to 1e-14
/// for points at least one side away.
double byQuadrature(double x, double y, double dx, double dy)
{
  constexpr std::array<double, 5> node = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                          0.9061798459386640};
  constexpr std::array<double, 5> weight = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                            0.4786286704993665, 0.2369268850561891};
  constexpr int parts = 40;
  double sum = 0;
  for (int i = 0; i < parts * 5; ++i)
  {
    const auto p = static_cast<std::size_t>(i % 5);
    const double u = ((i / 5 + 0.5 + 0.5 * node[p]) / parts - 0.5) * dx;
    for (int j = 0; j < parts * 5; ++j)
    {
      const auto q = static_cast<std::size_t>(j % 5);
      const double v = ((j / 5 + 0.5 + 0.5 * node[q]) / parts - 0.5) * dy;
      sum += weight[p] * weight[q] / std::hypot(x - u, y - v);
    }
  }
  return 0.25 * dx * dy / (parts * parts) * sum;
}

TEST(Influence, RectangleEqualsQuadratureOfTheKernel)
{
  for (const double aspect : {0.2, 1.0, 4.0, 20.0})
  {
    for (const auto& [i, j] : {std::pair{1, 0}, {0, 1}, {1, 1}, {3, 2}, {0, 7}, {9, 1}, {2, 30}, {250, 3}})
    {
      const double expected = byQuadrature(i * aspect, j, aspect, 1);
      // For points nearer than the longer side this quadrature is less accurate.
      const double tolerance = std::hypot(i * aspect, j) > std::max(aspect, 1.0) ? 1e-12 : 1e-6;
      EXPECT_NEAR(rectangleInfluence(i * aspect, j, aspect, 1) / expected, 1, tolerance)
          << "aspect " << aspect << ", cell " << i << ", " << j;
    }
  }
}

TEST(Influence, OwnCellOfASquareIsLovesValue)
{
  const double h = 2.5e-4;
  const double love = 4 * h * std::log(1 + std::sqrt(2.0));
  EXPECT_NEAR(rectangleInfluence(0, 0, h, h), love, 1e-15 * love);
  EXPECT_NEAR(pointInfluence(0, 0, h, h), love, 1e-15 * love)
      << "coefficient of the paper for the cell itself, with the missing factor h";
}

TEST(Influence, ClosedFormAndQuadratureAreContinuous)
{
  for (const double aspect : {1.0, 7.0})
  {
    const double limit = 8 * aspect;  // change from closed form to quadrature
    const double inside = rectangleInfluence(limit * (1 - 1e-13), 0, aspect, 1);
    EXPECT_NEAR(rectangleInfluence(limit * (1 + 1e-13), 0, aspect, 1) / inside, 1, 1e-12);
  }
}

TEST(Influence, PointForceIsFourPercentLowAtTheNextSquare)
{
  EXPECT_NEAR(pointInfluence(1, 0, 1, 1) / rectangleInfluence(1, 0, 1, 1), 0.963, 0.002);
  EXPECT_NEAR(pointInfluence(20, 0, 1, 1) / rectangleInfluence(20, 0, 1, 1), 1, 2e-4);
}

double smallestEigenvalue(double aspect, Kernel kernel)
{
  const Grid grid = problems::centredGrid(12, 24, 12 * aspect, 24, false);
  const Eigen::MatrixXd matrix = problems::influenceMatrix(grid, 1, kernel);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues().minCoeff() /
         matrix(0, 0);
}

TEST(Influence, RectangleMatrixIsPositiveDefiniteOnCellsOfAnyShape)
{
  for (const double aspect : {0.1, 0.5, 1.0, 3.0, 10.0, 30.0})
  {
    EXPECT_GT(smallestEigenvalue(aspect, Kernel::rectangle), 0.01) << "aspect " << aspect;
  }
}

TEST(Influence, PointForceMatrixIsIndefiniteOnCellsLongerThan4p70Widths)
{
  EXPECT_NEAR(smallestEigenvalue(1, Kernel::point_force), 0.543, 0.02);
  EXPECT_GT(smallestEigenvalue(4.6, Kernel::point_force), 0);
  EXPECT_LT(smallestEigenvalue(4.8, Kernel::point_force), 0);
}
}  // namespace
}  // namespace wheel_rail_contact::core
