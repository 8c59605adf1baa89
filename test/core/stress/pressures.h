// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../usual_headers.h"
#include "wheel_rail_contact/core/stress.h"

/// Pressures whose stress is known.
namespace wheel_rail_contact::core::pressures
{
/// Pressure on the cells of a grid.
struct Cells
{
  PatchGrid grid;
  Eigen::ArrayXXd pressure;
};

/// Grid around the origin.
inline PatchGrid centredGrid(int nx, int ny, double length, double width)
{
  const double dx = length / nx, dy = width / ny;
  return {nx, ny, dx, dy, 0.5 * (dx - length), 0.5 * (dy - width)};
}

/// Hertz's pressure with the highest value 1 on an ellipse with the semi-axes a (along x) and b; mean of each cell. The
/// grid is 1.1 times as large.
inline Cells hertz(int nx, int ny, double a, double b)
{
  constexpr int parts = 6;  // of a cell in each direction
  Cells cells{centredGrid(nx, ny, 2.2 * a, 2.2 * b), Eigen::ArrayXXd::Zero(nx, ny)};
  for (int k = 0; k < nx * ny * parts * parts; ++k)
  {
    const int i = k % nx, j = k / nx % ny, m = k / (nx * ny) % parts, n = k / (nx * ny * parts);
    const double x = (cells.grid.x(i) + ((m + 0.5) / parts - 0.5) * cells.grid.dx) / a;
    const double y = (cells.grid.y(j) + ((n + 0.5) / parts - 0.5) * cells.grid.dy) / b;
    cells.pressure(i, j) += std::sqrt(std::max(0.0, 1 - x * x - y * y)) / (parts * parts);
  }
  return cells;
}

/// Random pressures of 0 to 1 on cells of 1.3 × 0.7.
inline Cells random(int nx, int ny, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> value(0, 1);
  Cells cells{centredGrid(nx, ny, 1.3 * nx, 0.7 * ny), Eigen::ArrayXXd::Zero(nx, ny)};
  for (Eigen::Index k = 0; k < cells.pressure.size(); ++k)
  {
    cells.pressure(k) = value(generator);
  }
  return cells;
}
}  // namespace wheel_rail_contact::core::pressures
