// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/influence_operator.h"

#include <Eigen/Eigenvalues>

#include "../../refusal.h"
#include "../../seeded.h"
#include "core/normal/operator/influence.h"
#include "core/normal/operator/operator_cache.h"
#include "problems.h"

using namespace wheel_rail_contact::core;

namespace
{
using problems::uniform;

/// Applies an operator to a vector of cell values in the order of a gap array.
class Applied
{
 public:
  explicit Applied(const OperatorShape& shape) : influence_(shape), in_(size()), out_(size())
  {
    workspace_.reserve(influence_);
  }

  int rows() const { return influence_.shape().symmetric ? influence_.shape().nx / 2 : influence_.shape().nx; }
  int cells() const { return rows() * influence_.shape().ny; }

  Eigen::VectorXd product(const Eigen::VectorXd& values)
  {
    put(values);
    influence_.multiply(in_.data(), out_.data(), workspace_);
    return get();
  }

  Eigen::VectorXd preconditioned(const Eigen::VectorXd& values)
  {
    put(values);
    influence_.precondition(in_.data(), out_.data(), workspace_);
    return get();
  }

  bool lastIsProduct() const { return influence_.isProduct(in_.data(), out_.data()); }
  void spoilLast(int cell, double factor) { out_[at(cell)] *= factor; }

 private:
  std::size_t size() const { return static_cast<std::size_t>(influence_.fieldSize()); }
  std::size_t at(int cell) const
  {
    return static_cast<std::size_t>(influence_.rowOffset(cell % rows()) + influence_.columnOffset(cell / rows()));
  }
  void put(const Eigen::VectorXd& values)
  {
    for (int cell = 0; cell < cells(); ++cell)
    {
      in_[at(cell)] = values(cell);
    }
  }
  Eigen::VectorXd get() const
  {
    Eigen::VectorXd values(cells());
    for (int cell = 0; cell < cells(); ++cell)
    {
      values(cell) = out_[at(cell)];
    }
    return values;
  }

  InfluenceOperator influence_;
  InfluenceOperator::Workspace workspace_;
  std::vector<double> in_, out_;
};

Eigen::VectorXd randomColumn(int size, std::mt19937_64& random)
{
  return Eigen::VectorXd::NullaryExpr(size, [&random] { return uniform(random, 0, 1); });
}

class InfluenceOperatorProduct : public testing::TestWithParam<std::tuple<std::pair<int, int>, double, bool>>
{
};

TEST_P(InfluenceOperatorProduct, EqualsTheSumOverAllCells)
{
  const auto& [size, aspect, symmetric] = GetParam();
  const OperatorShape shape{size.first, size.second, aspect, symmetric};
  Seeded64 random(7);
  Applied applied(shape);
  const Eigen::VectorXd pressure = randomColumn(applied.cells(), random);
  const Grid grid = problems::centredGrid(shape.nx, shape.ny, shape.nx * aspect, shape.ny, symmetric);
  const Eigen::VectorXd expected = problems::influenceMatrix(grid, 1 / std::acos(-1.0)) * pressure;
  EXPECT_LT((applied.product(pressure) - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.maxCoeff());
  EXPECT_TRUE(applied.lastIsProduct());
  applied.spoilLast(applied.cells() / 3, 1.0001);
  EXPECT_FALSE(applied.lastIsProduct());
}

INSTANTIATE_TEST_SUITE_P(Even, InfluenceOperatorProduct,
                         testing::Combine(testing::Values(std::pair{4, 16}, std::pair{2, 2}, std::pair{6, 10},
                                                          std::pair{12, 20}, std::pair{16, 32}, std::pair{2, 128}),
                                          testing::Values(0.3, 1.0, 5.0), testing::Bool()));
INSTANTIATE_TEST_SUITE_P(Odd, InfluenceOperatorProduct,
                         testing::Combine(testing::Values(std::pair{5, 7}, std::pair{7, 65}, std::pair{16, 3}),
                                          testing::Values(0.3, 1.0, 5.0), testing::Values(false)));

TEST(InfluenceOperator, LargeProductEqualsTheSumAtSomeCells)
{
  Applied applied(OperatorShape{256, 256, 2, true});
  Seeded64 random(8);
  const Eigen::VectorXd pressure = randomColumn(applied.cells(), random);
  const Eigen::VectorXd found = applied.product(pressure);
  for (const int cell : {0, 127, 5000, 128 * 255, 128 * 256 - 1})
  {
    const int i = cell % 128, j = cell / 128;
    double expected = 0;
    for (int other = 0; other < applied.cells(); ++other)
    {
      const double x = other % 128, y = other / 128;
      expected += pressure(other) *
                  (rectangleInfluence(2 * (i - x), j - y, 2, 1) + rectangleInfluence(2 * (i + x + 1), j - y, 2, 1));
    }
    EXPECT_NEAR(found(cell) / expected, 1, 1e-12) << "cell " << cell;
  }
}

TEST(InfluenceOperator, IsReproducibleToTheLastBit)
{
  Applied first(OperatorShape{16, 32, 1, false}), second(OperatorShape{16, 32, 1, false});
  std::mt19937_64 random(1);
  const Eigen::VectorXd pressure = randomColumn(first.cells(), random);
  const Eigen::VectorXd once = first.product(pressure);
  EXPECT_EQ(once, first.product(pressure));
  EXPECT_EQ(once, second.product(pressure));
}

TEST(InfluenceOperator, PreconditionerIsSymmetricAndNearTheInverse)
{
  Applied applied(OperatorShape{8, 16, 3, false});
  std::mt19937_64 random(2);
  const Eigen::VectorXd a = randomColumn(applied.cells(), random), b = randomColumn(applied.cells(), random);
  EXPECT_NEAR(a.dot(applied.preconditioned(b)), b.dot(applied.preconditioned(a)), 1e-12 * a.dot(b));
  const Eigen::VectorXd shaped = (a.array() - 0.5).matrix();
  const double near_one = shaped.dot(applied.preconditioned(applied.product(shaped))) / shaped.squaredNorm();
  EXPECT_NEAR(near_one, 1, 0.3);
}

TEST(InfluenceOperator, RejectsInvalidShapesByName)
{
  const auto message = [](int nx, int ny, double aspect, bool symmetric) {
    return refusalOf([&] { InfluenceOperator(OperatorShape{nx, ny, aspect, symmetric}); });
  };
  EXPECT_EQ(message(1, 8, 1, false), "grid = 1 x 8: must have at least 2 cells in each direction");
  EXPECT_EQ(message(5, 8, 1, true), "nx = 5: must be even on a symmetric grid");
  EXPECT_EQ(message(4, 8, -1, false), "aspect = -1.000000: must be positive and finite");
}

TEST(CellAspect, CoveringGridIsLittleLargerThanTheBox)
{
  Seeded64 random(3);
  for (int k = 0; k < 1000; ++k)
  {
    const double width = uniform(random, 1e-3, 2e-2), length = width * std::exp(uniform(random, -1.5, 2.5));
    const auto cell = cell_aspect::coveringCell(length, width, 16, 32);
    EXPECT_GE(16 * cell.dx, length * (1 - 1e-12));
    EXPECT_GE(32 * cell.dy, width * (1 - 1e-12));
    // Half a step of the series of aspects: 2^(1/16).
    EXPECT_LE(16 * cell.dx * 32 * cell.dy, 1.0443 * length * width);
    EXPECT_DOUBLE_EQ(cell.dx / cell.dy, cell_aspect::aspect(cell_aspect::nearestIndex(cell.dx / cell.dy)));
  }
}

TEST(OperatorCache, KeepsAspectsOfTheSeriesAndAFewOthers)
{
  OperatorCache cache;
  const auto level = cache.find(4, 8, true, 2);
  EXPECT_EQ(cache.find(4, 8, true, 2 * (1 + 1e-12)), level) << "rounding of dx/dy";
  EXPECT_NE(cache.find(4, 8, false, 2), level);
  const auto other = cache.find(4, 8, true, 1.9);
  EXPECT_EQ(cache.find(4, 8, true, 1.9), other);
  for (int k = 0; k < 20; ++k)
  {
    cache.find(4, 8, true, 1.5 + 0.001 * k);
  }
  EXPECT_NE(cache.find(4, 8, true, 1.9), other) << "discarded after 20 others";
  EXPECT_EQ(cache.find(4, 8, true, 2), level);
}

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

TEST(Influence, OwnCellOfASquareIsLovesValueAndAPointForceIsFourPercentLowAtTheNext)
{
  const double h = 2.5e-4;
  const double love = 4 * h * std::log(1 + std::sqrt(2.0));
  EXPECT_NEAR(rectangleInfluence(0, 0, h, h), love, 1e-15 * love);
  EXPECT_NEAR(pointInfluence(0, 0, h, h), love, 1e-15 * love)
      << "coefficient of the paper for the cell itself, with the missing factor h";
  EXPECT_NEAR(pointInfluence(1, 0, 1, 1) / rectangleInfluence(1, 0, 1, 1), 0.963, 0.002);
  EXPECT_NEAR(pointInfluence(20, 0, 1, 1) / rectangleInfluence(20, 0, 1, 1), 1, 2e-4);
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

double smallestEigenvalue(double aspect, Kernel kernel)
{
  const Grid grid = problems::centredGrid(12, 24, 12 * aspect, 24, false);
  const Eigen::MatrixXd matrix = problems::influenceMatrix(grid, 1, kernel);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues().minCoeff() /
         matrix(0, 0);
}

TEST(Influence, RectangleMatrixIsPositiveDefiniteAndThatOfPointForcesIsNotAbove4p70)
{
  for (const double aspect : {0.1, 0.5, 1.0, 3.0, 10.0, 30.0})
  {
    EXPECT_GT(smallestEigenvalue(aspect, Kernel::rectangle), 0.01) << "aspect " << aspect;
  }
  EXPECT_NEAR(smallestEigenvalue(1, Kernel::point_force), 0.543, 0.02);
  EXPECT_GT(smallestEigenvalue(4.6, Kernel::point_force), 0);
  EXPECT_LT(smallestEigenvalue(4.8, Kernel::point_force), 0);
}
}  // namespace
