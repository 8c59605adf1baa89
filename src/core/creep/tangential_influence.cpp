// SPDX-License-Identifier: BSD-3-Clause
#include "core/creep/tangential_influence.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
/// Most tables that are kept: the cells of a contact that moves have a few aspects.
constexpr std::size_t tables_kept = 16;
/// Digits of an aspect, which the grids of a contact that moves have in common. A table depends on them alone, not on
/// the grids before. The coefficients differ by no more than 1e-9.
constexpr double aspect_digits = 1 << 30;

double rounded(double aspect)
{
  int exponent = 0;
  const double digits = std::frexp(aspect, &exponent);
  return std::ldexp(std::round(aspect_digits * digits) / aspect_digits, exponent);
}

/// Antiderivatives of x²/rho³, y²/rho³ and x y / rho³. Terms of one variable are left out.
std::array<double, 3> cerrutiCorner(double x, double y)
{
  const double xx = y == 0 ? 0 : y * std::asinh(x / std::abs(y));
  const double yy = x == 0 ? 0 : x * std::asinh(y / std::abs(x));
  return {xx, yy, -std::sqrt(x * x + y * y)};
}
}  // namespace

TangentialInfluence tangentialInfluence(double x, double y, double dx, double dy, double poisson)
{
  const double x1 = x - 0.5 * dx, x2 = x + 0.5 * dx, y1 = y - 0.5 * dy, y2 = y + 0.5 * dy;
  const auto a = cerrutiCorner(x2, y2), b = cerrutiCorner(x1, y2), c = cerrutiCorner(x2, y1), d = cerrutiCorner(x1, y1);
  std::array<double, 3> sum{};
  for (std::size_t k = 0; k < sum.size(); ++k)
  {
    sum[k] = (a[k] - b[k]) - (c[k] - d[k]);
  }
  return {sum[0] + (1 - poisson) * sum[1], (1 - poisson) * sum[0] + sum[1], poisson * sum[2]};
}

bool TangentialTable::serves(int rows, int columns, double aspect, double poisson) const
{
  return rows <= rows_ && columns <= columns_ && poisson == poisson_ && aspect == aspect_;
}

void TangentialTable::set(int rows, int columns, double aspect, double poisson)
{
  rows_ = rows;
  columns_ = columns;
  aspect_ = aspect;
  poisson_ = poisson;
  centre_ = roundUpToLanes(columns);
  line_ = 2 * centre_ + lane_padding;
  table_.resize(3 * rows * line_);
  std::fill_n(table_.data(), 3 * rows * line_, 0.0);
  for (int row = 0; row < rows; ++row)
  {
    double* xx = table_.data() + 3 * row * line_ + centre_;
    double *xy = xx + line_, *yy = xy + line_;
    for (int j = 0; j < columns; ++j)
    {
      const TangentialInfluence value = tangentialInfluence(row * aspect, j, aspect, 1, poisson);
      xx[j] = xx[-j] = value.xx;
      yy[j] = yy[-j] = value.yy;
      xy[j] = value.xy;
      xy[-j] = -value.xy;
    }
  }
}

const TangentialTable& TangentialTables::find(int rows, int columns, double given_aspect, double poisson)
{
  const double aspect = rounded(given_aspect);
  std::size_t at = 0;
  while (at < tables_.size() && !tables_[at].serves(rows, columns, aspect, poisson))
  {
    ++at;
  }
  if (at == tables_.size() && at < tables_kept)
  {
    tables_.emplace_back();
    last_use_.push_back(0);
  }
  else if (at == tables_.size())
  {
    at = static_cast<std::size_t>(std::min_element(last_use_.begin(), last_use_.end()) - last_use_.begin());
  }
  if (!tables_[at].serves(rows, columns, aspect, poisson))
  {
    tables_[at].set(rows, columns, aspect, poisson);
  }
  last_use_[at] = ++uses_;
  return tables_[at];
}
}  // namespace wheel_rail_contact::core
