// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/pressure_surface.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
constexpr int rim = 2;  ///< number of empty cells added on each side, so that the pressure at the outermost points is 0

/// Squared pressures, with the rim around them.
Eigen::ArrayXXd squares(const Eigen::ArrayXXd& pressure)
{
  Eigen::ArrayXXd q = Eigen::ArrayXXd::Zero(pressure.rows() + 2 * rim, pressure.cols() + 2 * rim);
  q.block(rim, rim, pressure.rows(), pressure.cols()) = pressure.square();
  return q;
}

/// Value for a cell without pressure: the mean of the linear extrapolations from its loaded neighbours in rows and
/// columns, each at most 0; without such neighbours, minus the largest value of the diagonal neighbours.
double extrapolated(const Eigen::ArrayXXd& q, Eigen::Index i, Eigen::Index j)
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

/// Squared pressures, extrapolated below zero in the cells beside the edge.
Eigen::ArrayXXd extrapolatedSquares(const Eigen::ArrayXXd& pressure)
{
  // Two more rings of zeros, so that each cell has two neighbours in each direction.
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
        result(i, j) = extrapolated(wide, i + 2, j + 2);
      }
    }
  }
  return result;
}

/// Number of parts into which a cell is divided in one direction.
int refinement(int cells, int points)
{
  return std::max(1, (points + cells - 1) / std::max(cells, 1));
}

/// Bilinear interpolation between four cell centres, at the point (a, b) of a grid with `factor_a` × `factor_b` points
/// for each cell.
double between(const Eigen::ArrayXXd& q, Eigen::Index a, int factor_a, Eigen::Index b, int factor_b)
{
  const Eigen::Index i = std::min(a / factor_a, q.rows() - 2), j = std::min(b / factor_b, q.cols() - 2);
  const double s = static_cast<double>(a - i * factor_a) / factor_a;
  const double t = static_cast<double>(b - j * factor_b) / factor_b;
  return (1 - s) * ((1 - t) * q(i, j) + t * q(i, j + 1)) + s * ((1 - t) * q(i + 1, j) + t * q(i + 1, j + 1));
}
}  // namespace

PressureSurface::PressureSurface(const core::PatchGrid& grid, const Eigen::ArrayXXd& pressure, int points)
{
  const Eigen::ArrayXXd q = extrapolatedSquares(pressure);
  const int along = refinement(grid.nx, points), across = refinement(grid.ny, points);
  dx_ = grid.dx / along;
  dy_ = grid.dy / across;
  x0_ = grid.x(0) - rim * grid.dx;
  y0_ = grid.y(0) - rim * grid.dy;
  square_.resize((q.rows() - 1) * along + 1, (q.cols() - 1) * across + 1);
  for (Eigen::Index b = 0; b < square_.cols(); ++b)
  {
    for (Eigen::Index a = 0; a < square_.rows(); ++a)
    {
      square_(a, b) = between(q, a, along, b, across);
    }
  }
}

double PressureSurface::pressure(int row, int column) const
{
  return std::sqrt(std::max(square_(row, column), 0.0));
}

PressureSurface::Corner PressureSurface::cornerAt(int row, int column) const
{
  return {x(row), y(column), square_(row, column)};
}

std::vector<PressureSurface::Triangle> PressureSurface::allTriangles() const
{
  std::vector<Triangle> triangles;
  for (int i = 0; i + 1 < rows(); ++i)
  {
    for (int j = 0; j + 1 < columns(); ++j)
    {
      const Corner first = cornerAt(i, j), last = cornerAt(i + 1, j + 1);
      triangles.push_back({first, cornerAt(i + 1, j), last});
      triangles.push_back({first, last, cornerAt(i, j + 1)});
    }
  }
  return triangles;
}

PressureSurface::Point PressureSurface::crossing(const Corner& from, const Corner& to)
{
  const double t = from.square / (from.square - to.square);
  return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), 0};
}

std::vector<PressureSurface::Point> PressureSurface::triangles() const
{
  std::vector<Point> points, loaded;
  for (const Triangle& triangle : allTriangles())
  {
    // The loaded part of a triangle is a polygon of up to four corners.
    loaded.clear();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Corner &here = triangle.at(k), &next = triangle.at((k + 1) % 3);
      if (here.square > 0)
      {
        loaded.push_back({here.x, here.y, std::sqrt(here.square)});
      }
      if ((here.square > 0) != (next.square > 0))
      {
        loaded.push_back(crossing(here, next));
      }
    }
    for (std::size_t k = 1; k + 1 < loaded.size(); ++k)
    {
      points.insert(points.end(), {loaded[0], loaded[k], loaded[k + 1]});
    }
  }
  return points;
}

std::vector<PressureSurface::Point> PressureSurface::outline() const
{
  std::vector<Point> points;
  for (const Triangle& triangle : allTriangles())
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Corner &here = triangle.at(k), &next = triangle.at((k + 1) % 3);
      if ((here.square > 0) != (next.square > 0))
      {
        points.push_back(crossing(here, next));
      }
    }
  }
  return points;
}
}  // namespace wheel_rail_contact
