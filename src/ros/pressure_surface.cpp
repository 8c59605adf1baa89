// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/ros/pressure_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheel_rail_contact
{
namespace
{
constexpr int rim = 2;  ///< cells added on every side, so that the outermost points are 0

/// Squares of the pressures, with the rim round them.
Eigen::ArrayXXd squares(const Eigen::ArrayXXd& pressure)
{
  Eigen::ArrayXXd q = Eigen::ArrayXXd::Zero(pressure.rows() + 2 * rim, pressure.cols() + 2 * rim);
  q.block(rim, rim, pressure.rows(), pressure.cols()) = pressure.square();
  return q;
}

/// What a cell without pressure gets: the mean of the linear continuations from its neighbours, never positive.
double continued(const Eigen::ArrayXXd& q, Eigen::Index i, Eigen::Index j)
{
  double sum = 0, largest = 0;
  int count = 0;
  for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
  {
    const double near = q(i + di, j + dj);
    const double far = q(i + 2 * di, j + 2 * dj);
    if (near > 0)
    {
      sum += far > 0 ? std::min(2 * near - far, 0.0) : -near;
      ++count;
    }
  }
  for (const auto& [di, dj] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}})
  {
    largest = std::max(largest, q(i + di, j + dj));
  }
  return count > 0 ? sum / count : -largest;
}

/// The squares with the cells beside the edge continued below zero.
Eigen::ArrayXXd continuedSquares(const Eigen::ArrayXXd& pressure)
{
  // One more ring of zeros, so that two neighbours can be asked for everywhere.
  const Eigen::ArrayXXd q = squares(pressure);
  Eigen::ArrayXXd wide = Eigen::ArrayXXd::Zero(q.rows() + 4, q.cols() + 4);
  wide.block(2, 2, q.rows(), q.cols()) = q;
  Eigen::ArrayXXd result = q;
  for (Eigen::Index j = 0; j < q.cols(); ++j)
  {
    for (Eigen::Index i = 0; i < q.rows(); ++i)
    {
      if (!(q(i, j) > 0))
      {
        result(i, j) = continued(wide, i + 2, j + 2);
      }
    }
  }
  return result;
}

/// Parts into which a cell is divided.
int refinement(int cells, int points)
{
  return std::max(1, (points + cells - 1) / std::max(cells, 1));
}

/// Value between four cell centres; point `a` of `factor` in each cell.
double between(const Eigen::ArrayXXd& q, Eigen::Index a, int factor_a, Eigen::Index b, int factor_b)
{
  const Eigen::Index i = std::min(a / factor_a, q.rows() - 2), j = std::min(b / factor_b, q.cols() - 2);
  const double s = static_cast<double>(a - i * factor_a) / factor_a;
  const double t = static_cast<double>(b - j * factor_b) / factor_b;
  return (1 - s) * ((1 - t) * q(i, j) + t * q(i, j + 1)) + s * ((1 - t) * q(i + 1, j) + t * q(i + 1, j + 1));
}
}  // namespace

PressureSurface::PressureSurface(const Grid& grid, const Eigen::ArrayXXd& pressure, int points)
{
  const Eigen::ArrayXXd q = continuedSquares(pressure);
  const int along = refinement(grid.nx, points), across = refinement(grid.ny, points);
  dx_ = grid.dx / along;
  dy_ = grid.dy / across;
  x0_ = grid.x(0) - rim * grid.dx;
  y0_ = grid.y(0) - rim * grid.dy;
  pressure_.resize((q.rows() - 1) * along + 1, (q.cols() - 1) * across + 1);
  for (Eigen::Index b = 0; b < pressure_.cols(); ++b)
  {
    for (Eigen::Index a = 0; a < pressure_.rows(); ++a)
    {
      pressure_(a, b) = std::sqrt(std::max(between(q, a, along, b, across), 0.0));
    }
  }
}
}  // namespace wheel_rail_contact
