// SPDX-License-Identifier: BSD-3-Clause
#include "core/creep/row_products.h"

#include <algorithm>
#include <cmath>

#include "core/simd/wide.h"

namespace wheel_rail_contact::core
{
namespace
{
using Lanes = double __attribute__((vector_size(lane_padding * sizeof(double))));
using LanesInMemory = double __attribute__((vector_size(lane_padding * sizeof(double)), aligned(sizeof(double))));

/// Passes over a row. More of them save few sweeps.
constexpr int row_passes = 2;
/// A change below this share of the bound is left to the next sweep.
constexpr double negligible_change = 1e-7;

constexpr int laneBefore(int column)
{
  return column / lane_padding * lane_padding;
}

/// Traction (x, y) of a cell that has the slip c + a (x, y), with the diagonal a of its influence: -c / a if this is
/// within the bound. Otherwise -c / (a + s) with the s > 0 that meets the bound, where slip and traction are opposite.
/// s is found by Newton's method on 1 / length, which is nearly linear in s (Moré and Sorensen 1983).
inline void solveCell(double ax, double ay, double cx, double cy, double bound, double& x, double& y)
{
  constexpr int steps = 4;
  constexpr double tolerance = 1e-6;
  x = -cx / ax;
  y = -cy / ay;
  if (x * x + y * y <= bound * bound)
  {
    return;
  }
  double s = std::max(0.0, std::sqrt(cx * cx + cy * cy) / bound - 0.5 * (ax + ay));
  double length = 0;
  for (int step = 0; step < steps; ++step)
  {
    const double inverse_x = 1 / (ax + s), inverse_y = 1 / (ay + s);
    x = -cx * inverse_x;
    y = -cy * inverse_y;
    const double square = x * x + y * y;
    length = std::sqrt(square);
    if (std::abs(length - bound) <= tolerance * bound)
    {
      break;
    }
    s = std::max(0.0, s + (length - bound) * square / (bound * (x * x * inverse_x + y * y * inverse_y)));
  }
  x *= bound / length;
  y *= bound / length;
}
}  // namespace

WHEEL_RAIL_CONTACT_WIDE void solveRow(const RowCells& row)
{
  const double ax = row.influence.xx[0], ay = row.influence.yy[0];
  for (int pass = 0; pass < row_passes; ++pass)
  {
    for (int k = 0; k < row.end - row.first; ++k)
    {
      const int j = pass % 2 == 0 ? row.first + k : row.end - 1 - k;
      double x = 0, y = 0;
      if (row.bound[j] > 0)
      {
        solveCell(ax, ay, row.slip_x[j] - ax * row.x[j], row.slip_y[j] - ay * row.y[j], row.bound[j], x, y);
      }
      const double change_x = x - row.x[j], change_y = y - row.y[j];
      const double change = std::abs(change_x) + std::abs(change_y);
      if (change <= negligible_change * row.bound[j])
      {
        continue;
      }
      row.x[j] = x;
      row.y[j] = y;
      row.step_x[j] += change_x;
      row.step_y[j] += change_y;
      for (int at = laneBefore(row.first); at < row.end; at += lane_padding)
      {
        const Lanes xx = *reinterpret_cast<const LanesInMemory*>(row.influence.xx + at - j);
        const Lanes xy = *reinterpret_cast<const LanesInMemory*>(row.influence.xy + at - j);
        const Lanes yy = *reinterpret_cast<const LanesInMemory*>(row.influence.yy + at - j);
        *reinterpret_cast<Lanes*>(row.slip_x + at) += xx * change_x + xy * change_y;
        *reinterpret_cast<Lanes*>(row.slip_y + at) += xy * change_x + yy * change_y;
      }
    }
  }
}

WHEEL_RAIL_CONTACT_WIDE void addProduct(const RowProduct& product)
{
  const double sign = product.influence.sign;
  for (int at = laneBefore(product.target_first); at < product.target_end; at += lane_padding)
  {
    Lanes direct_x{}, direct_y{}, cross_x{}, cross_y{};
    for (int k = 0; k < product.count; ++k)
    {
      const int j = product.columns[k];
      const Lanes xx = *reinterpret_cast<const LanesInMemory*>(product.influence.xx + at - j);
      const Lanes xy = *reinterpret_cast<const LanesInMemory*>(product.influence.xy + at - j);
      const Lanes yy = *reinterpret_cast<const LanesInMemory*>(product.influence.yy + at - j);
      direct_x += xx * product.step_x[j];
      cross_x += xy * product.step_y[j];
      cross_y += xy * product.step_x[j];
      direct_y += yy * product.step_y[j];
    }
    *reinterpret_cast<Lanes*>(product.behind_x + at) += direct_x + sign * cross_x;
    *reinterpret_cast<Lanes*>(product.behind_y + at) += direct_y + sign * cross_y;
    *reinterpret_cast<Lanes*>(product.ahead_x + at) += direct_x - sign * cross_x;
    *reinterpret_cast<Lanes*>(product.ahead_y + at) += direct_y - sign * cross_y;
  }
}
}  // namespace wheel_rail_contact::core
