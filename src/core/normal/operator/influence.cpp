// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/influence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace wheel_rail_contact::core
{
namespace
{
/// Distance beyond which quadrature replaces the closed form, in lengths of the longer side of the rectangle [-]. From
/// there on the error of the six-point rule is below 1e-14.
constexpr double far_ratio = 8;

/// Six-point Gauss–Legendre rule on [-1, 1]: the three positive nodes and their weights.
constexpr std::array<double, 3> gauss_nodes = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
constexpr std::array<double, 3> gauss_weights = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};

/// Second antiderivative of 1/rho: d²F/dxdy = 1/sqrt(x² + y²).
double corner(double x, double y)
{
  const double along = x == 0 ? 0 : x * std::asinh(y / std::abs(x));
  const double across = y == 0 ? 0 : y * std::asinh(x / std::abs(y));
  return along + across;
}

double closedForm(double x, double y, double dx, double dy)
{
  const double x1 = x - 0.5 * dx, x2 = x + 0.5 * dx;
  const double y1 = y - 0.5 * dy, y2 = y + 0.5 * dy;
  return (corner(x2, y2) - corner(x1, y2)) - (corner(x2, y1) - corner(x1, y1));
}

double inverseDistance(double x, double y)
{
  return 1 / std::sqrt(x * x + y * y);
}

double quadrature(double x, double y, double dx, double dy)
{
  double sum = 0;
  for (std::size_t i = 0; i < gauss_nodes.size(); ++i)
  {
    for (std::size_t j = 0; j < gauss_nodes.size(); ++j)
    {
      const double a = 0.5 * dx * gauss_nodes[i], b = 0.5 * dy * gauss_nodes[j];
      const double near = inverseDistance(x - a, y - b) + inverseDistance(x - a, y + b);
      const double far = inverseDistance(x + a, y - b) + inverseDistance(x + a, y + b);
      sum += gauss_weights[i] * gauss_weights[j] * (near + far);
    }
  }
  return 0.25 * dx * dy * sum;
}
}  // namespace

double rectangleInfluence(double x, double y, double dx, double dy)
{
  const bool far = std::hypot(x, y) > far_ratio * std::max(dx, dy);
  return far ? quadrature(x, y, dx, dy) : closedForm(x, y, dx, dy);
}

double pointInfluence(double x, double y, double dx, double dy)
{
  const double distance = std::hypot(x, y);
  return distance < 0.5 * std::min(dx, dy) ? closedForm(0, 0, dx, dy) : dx * dy / distance;
}

double influence(Kernel kernel, double x, double y, double dx, double dy)
{
  return kernel == Kernel::rectangle ? rectangleInfluence(x, y, dx, dy) : pointInfluence(x, y, dx, dy);
}

void InfluenceTable::set(const Grid& grid, Kernel kernel)
{
  const double aspect = grid.dx / grid.dy;
  if (rows_ == grid.rows() && columns_ == grid.ny && symmetric_ == grid.symmetric && aspect_ == aspect &&
      kernel_ == kernel)
  {
    return;
  }
  rows_ = grid.rows();
  columns_ = grid.ny;
  symmetric_ = grid.symmetric;
  aspect_ = aspect;
  kernel_ = kernel;
  line_ = symmetric_ ? 3 * rows_ - 1 : 2 * rows_ - 1;
  table_.resize(static_cast<std::size_t>(columns_ * line_));
  double* coefficient = table_.data();
  for (int column = 0; column < columns_; ++column)
  {
    for (int row = 1 - rows_; row < line_ - rows_ + 1; ++row)
    {
      *coefficient++ = influence(kernel, row * aspect, column, aspect, 1);
    }
  }
}

double InfluenceTable::own(int row) const
{
  const double* direct = atColumnDistance(0);
  return direct[0] + (symmetric_ ? direct[2 * row + 1] : 0);
}

void InfluenceTable::add(int row, int column, double amount, double* displacement) const
{
  for (int j = 0; j < columns_; ++j, displacement += rows_)
  {
    const double* direct = atColumnDistance(std::abs(j - column)) - row;
    for (int i = 0; i < rows_; ++i)
    {
      displacement[i] += amount * direct[i];
    }
    if (symmetric_)
    {
      const double* mirrored = direct + 2 * row + 1;
      for (int i = 0; i < rows_; ++i)
      {
        displacement[i] += amount * mirrored[i];
      }
    }
  }
}
}  // namespace wheel_rail_contact::core
