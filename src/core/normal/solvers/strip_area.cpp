// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/strip_area.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/normal/measures/pressure_measures.h"
#include "core/normal/solvers/hertz.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Share of the approach at which the overlap of the undeformed bodies gives the contact area.
constexpr double virtual_penetration = 0.55;

/// Squared half-length of a strip below a level [m²]; not positive if the strip is not loaded.
double squaredLength(const Strip& strip, double level)
{
  return strip.bend > 0 ? (level - strip.gap) / strip.bend : -infinity;
}

/// Interpolates between the values of two neighbouring columns [m²]. At an end only the value of this end counts; the
/// other may be infinite.
double squaredBetween(double first, double last, double share)
{
  return share <= 0 ? first : share >= 1 ? last : (1 - share) * first + share * last;
}

/// Loaded part of the interval between two neighbouring columns. l² is linear between them.
struct Interval
{
  double begin = 0, end = 0;  ///< of the loaded part, in shares of the interval [-]
  double squares = 0;         ///< integral of l² over the share [m²]
  double lengths = 0;         ///< integral of l over the share [m]

  /// `first` and `last`: l² in the two columns [m²].
  Interval(double first, double last)
  {
    if (!(first > 0) && !(last > 0))
    {
      return;
    }
    begin = first > 0 ? 0 : 1 - last / (last - first);
    end = last > 0 ? 1 : first / (first - last);
    const double low = std::max(first, 0.0), high = std::max(last, 0.0);
    const double root_low = std::sqrt(low), root_high = std::sqrt(high);
    squares = 0.5 * (low + high) * (end - begin);
    lengths = 2.0 / 3.0 * (low + root_low * root_high + high) / (root_low + root_high) * (end - begin);
  }
};

/// Mean of ln|y| between two positions.
double meanLogarithm(double begin, double end)
{
  const auto primitive = [](double y) { return y == 0 ? 0 : y * std::log(std::abs(y)) - y; };
  return (primitive(end) - primitive(begin)) / (end - begin);
}

/// 1/l times the integral of sqrt(l² - x²) / sqrt(x² + y²) from -l to l, minus its singular part -2 ln|y|.
double regularInfluence(double l, double y)
{
  const double distance = std::abs(y), reach = std::hypot(l, y);
  if (distance < 1e-6 * reach)  // K - E equals ln(4 l / |y|) - 1 to rounding
  {
    return 2 * (std::log(4 * l) - 1);
  }
  return 2 * l / reach * elliptic(distance / reach).d + 2 * std::log(distance);
}

/// Double integral of sqrt(l² - x²) / (distance from the deepest point) over the corrected area [m²].
///
/// Between two columns the regular part is assumed linear and the singular part is replaced by its mean. Both are
/// multiplied by the integral of l.
double compliance(const StripGap& gap, const StripArea& area)
{
  const auto place = [&](double column) { return area.across * (gap.y0 + column * gap.dy - gap.y); };
  const auto regular_at = [&](double squared, double y)
  { return squared > 0 ? regularInfluence(area.along * std::sqrt(squared), y) : 0; };
  const auto at_edge = [](double y) { return 2 * std::log(std::abs(y)); };
  double sum = 0, squared = squaredLength(gap.strips[0], area.level), regular = regular_at(squared, place(0));
  for (std::size_t j = 0; j + 1 < gap.strips.size(); ++j)
  {
    const auto column = static_cast<double>(j);
    const double next = squaredLength(gap.strips[j + 1], area.level);
    const double regular_next = regular_at(next, place(column + 1));
    const Interval interval(squared, next);
    const double begin = place(column + interval.begin), end = place(column + interval.end);
    if (end > begin)
    {
      const double ends = (squared > 0 ? regular : at_edge(begin)) + (next > 0 ? regular_next : at_edge(end));
      sum += interval.lengths * (0.5 * ends - 2 * meanLogarithm(begin, end));
    }
    squared = next;
    regular = regular_next;
  }
  return sum * area.along * area.across * gap.dy;
}

Strip fitColumn(const PatchGap& patch, int column)
{
  const Grid& grid = patch.grid;
  const int last = grid.rows() - 1, middle = grid.symmetric ? 0 : grid.rows() / 2;
  const double x0 = grid.symmetric ? -grid.x(0) : grid.x(0), x1 = grid.x(middle), x2 = grid.x(last);
  const double g0 = patch.gap(0, column), g1 = patch.gap(middle, column), g2 = patch.gap(last, column);
  const double early = (g1 - g0) / (x1 - x0), late = (g2 - g1) / (x2 - x1);
  Strip strip;
  strip.bend = (late - early) / (x2 - x0);
  const double slope = early - strip.bend * (x0 + x1);  // at x = 0
  strip.x = strip.bend > 0 ? std::clamp(-0.5 * slope / strip.bend, x0, x2) : x1;
  strip.gap = g1 + (strip.x - x1) * (slope + strip.bend * (strip.x + x1));
  return strip;
}

/// Extrapolates `count` strips beyond `edge`, with the curvature from the two strips before it. `step` is the outward
/// direction.
void extrapolate(Strip* edge, int step, int count)
{
  const double increase = edge->gap - edge[-step].gap, bend = increase - (edge[-step].gap - edge[-2 * step].gap);
  const bool closed = !(increase + bend > 0) || !(bend >= 0);
  for (int k = 1; k <= count; ++k)
  {
    Strip& strip = edge[k * step];
    strip = *edge;
    strip.gap = closed ? infinity : edge->gap + k * (increase + 0.5 * (k + 1) * bend);
  }
}

void findDeepest(StripGap& gap)
{
  const auto lower = [](const Strip& a, const Strip& b) { return a.gap < b.gap; };
  const auto lowest = std::min_element(gap.strips.begin(), gap.strips.end(), lower);
  gap.deepest = *lowest;
  gap.y = gap.y0 + static_cast<double>(lowest - gap.strips.begin()) * gap.dy;
  if (lowest == gap.strips.begin() || lowest == gap.strips.end() - 1 || !std::isfinite(lowest[-1].gap) ||
      !std::isfinite(lowest[1].gap))
  {
    return;  // the grid cuts the overlap at its deepest point
  }
  const Strip &before = lowest[-1], &after = lowest[1];
  const double slope = 0.5 * (after.gap - before.gap), second = before.gap - 2 * lowest->gap + after.gap;
  const double shift = second > 0 ? std::clamp(-slope / second, -0.5, 0.5) : 0;
  const Strip& next = shift < 0 ? before : after;
  gap.y += shift * gap.dy;
  gap.deepest.gap += shift * (slope + 0.5 * second * shift);
  gap.deepest.x += std::abs(shift) * (next.x - lowest->x);
  gap.deepest.bend += std::abs(shift) * (next.bend - lowest->bend);
}

/// Sets the factors that give the area the ratio of length to width of its Hertz ellipse.
void correctShape(StripArea& area)
{
  const double length = 2 * area.half_length;
  const HertzContact ellipse = hertzForApproach({1 / (length * length), 1 / (area.width * area.width)}, 1, 1);
  area.along = std::sqrt(ellipse.semi_axis_x / ellipse.semi_axis_y * area.width / length);
  area.across = 1 / area.along;
}
}  // namespace

bool fitStrips(const PatchGap& patch, StripGap& gap)
{
  const Grid& grid = patch.grid;
  if (grid.rows() < (grid.symmetric ? 2 : 3) || grid.ny < 3)
  {
    return false;
  }
  const int beyond = grid.ny / 4 + 1;
  gap.strips.resize(static_cast<std::size_t>(grid.ny + 2 * beyond));
  gap.dy = grid.dy;
  gap.y0 = grid.y0 - beyond * grid.dy;
  const auto first = gap.strips.begin() + beyond;
  for (int j = 0; j < grid.ny; ++j)
  {
    first[j] = fitColumn(patch, j);
  }
  extrapolate(&first[0], -1, beyond);
  extrapolate(&first[grid.ny - 1], 1, beyond);
  findDeepest(gap);
  return true;
}

StripArea stripAreaAt(const StripGap& gap, double modulus, double approach)
{
  StripArea area;
  if (!(approach > 0))
  {
    return area;
  }
  area.level = gap.deepest.gap + virtual_penetration * approach;
  area.sound = gap.deepest.bend > 0;
  double squares = 0, lengths = 0;
  for (std::size_t j = 0; j + 1 < gap.strips.size(); ++j)
  {
    const Strip& strip = gap.strips[j];
    area.sound = area.sound && (strip.bend > 0 || strip.gap > area.level);
    const Interval interval(squaredLength(strip, area.level), squaredLength(gap.strips[j + 1], area.level));
    area.width += gap.dy * (interval.end - interval.begin);
    squares += gap.dy * interval.squares;
    lengths += gap.dy * interval.lengths;
  }
  if (!area.sound || !(area.width > 0))
  {
    return area;
  }
  area.half_length = std::sqrt(virtual_penetration * approach / gap.deepest.bend);
  correctShape(area);
  // Each strip carries a half-ellipse: pressure / half_length * pi/2 * l² per unit of width, corrected along and
  // across.
  area.pressure = pi * modulus * approach * area.along * area.half_length / compliance(gap, area);
  area.force = 0.5 * pi * area.pressure * squares * area.along * area.across / area.half_length;
  area.area = 2 * lengths * area.along * area.across;
  return area;
}

void fillPressure(const Grid& grid, const StripGap& gap, const StripArea& area, Eigen::ArrayXXd& pressure)
{
  pressure.setZero(grid.rows(), grid.ny);
  const double factor = area.force > 0 ? area.pressure / (area.along * area.half_length) : 0;
  for (int j = 0; j < grid.ny && factor > 0; ++j)
  {
    const double column = (gap.y + (grid.y(j) - gap.y) / area.across - gap.y0) / gap.dy;
    const auto last = static_cast<double>(gap.strips.size() - 1);
    if (!(column >= 0 && column <= last))
    {
      continue;
    }
    const auto low = static_cast<std::size_t>(std::min(column, last - 1));
    const double share = column - static_cast<double>(low);
    const Strip &before = gap.strips[low], &after = gap.strips[low + 1];
    const double squared = squaredBetween(squaredLength(before, area.level), squaredLength(after, area.level), share);
    const double middle = before.x + share * (after.x - before.x), reach = area.along * area.along * squared;
    for (int i = 0; i < grid.rows(); ++i)
    {
      const double x = grid.x(i) - middle;
      pressure(i, j) = factor * std::sqrt(std::max(reach - x * x, 0.0));
    }
  }
}
}  // namespace wheel_rail_contact::core
