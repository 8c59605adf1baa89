// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/least_gap.h"

#include <algorithm>

#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Distance of the minimum of the parabola through three gaps below the middle one, which is the least. Zero next to a
/// cell without a body, whose gap is very large whatever has been added to all of them.
double fall(double before, double least, double after)
{
  const double bend = before - 2 * least + after;
  const bool bodies = std::max(before, after) < 0.5 * no_body_gap;
  return bodies && bend > 0 ? (after - before) * (after - before) / (8 * bend) : 0;
}

/// The same across the track. Next to a kink, where the gap bends less beside the least cell, the distance is limited
/// to twice that of a parabola with this bend.
double fallAcross(const Eigen::ArrayXXd& gap, Eigen::Index i, Eigen::Index j)
{
  const auto inside = [&](Eigen::Index column) { return column > 0 && column + 1 < gap.cols(); };
  if (!inside(j))
  {
    return 0;
  }
  double most = fall(gap(i, j - 1), gap(i, j), gap(i, j + 1));
  for (const Eigen::Index beside : {j - 1, j + 1})
  {
    const double bend = inside(beside) ? gap(i, beside - 1) - 2 * gap(i, beside) + gap(i, beside + 1) : 4 * most;
    most = std::min(most, std::max(bend, 0.0) / 4);
  }
  return most;
}
}  // namespace

double leastGap(const Grid& grid, const Eigen::ArrayXXd& gap)
{
  Eigen::Index i = 0, j = 0;
  const double least = gap.minCoeff(&i, &j);
  const bool at_mirror = grid.symmetric && i == 0;  // the neighbour of this cell is its mirror image
  const bool inside = (at_mirror || i > 0) && i + 1 < gap.rows();
  const double along = inside ? fall(at_mirror ? least : gap(i - 1, j), least, gap(i + 1, j)) : 0;
  return least - along - fallAcross(gap, i, j);
}

}  // namespace wheel_rail_contact::core
