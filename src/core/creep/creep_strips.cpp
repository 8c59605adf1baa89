// SPDX-License-Identifier: BSD-3-Clause
#include "core/creep/creep_strips.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
CreepStrip stripOf(const CreepProblem& problem, int column)
{
  const PatchGrid& grid = problem.grid;
  double sum = 0, first = 0, second = 0;
  for (int i = 0; i < grid.nx; ++i)
  {
    const double p = problem.pressure(i, column);
    sum += p;
    first += p * i;
    second += p * i * i;
  }
  CreepStrip strip;
  if (sum > 0)
  {
    const double mean = first / sum;
    // The variance of a semi-ellipse is a quarter of its half length squared; a single cell has that of a uniform load.
    const double variance = std::max(second / sum - mean * mean, 1.0 / 12);
    strip.force = sum;
    strip.centre = grid.x0 + mean * grid.dx;
    strip.half = 2 * std::sqrt(variance) * grid.dx;
  }
  return strip;
}
}  // namespace

double slipVelocity(double speed, const Creepage& creepage)
{
  return std::abs(speed) * std::hypot(creepage.x, creepage.y);
}

Creepage creepageOf(const CreepProblem& problem, int column)
{
  const Creepage& creep = problem.creepage;
  return problem.columns.empty() ? Creepage{creep.x - creep.spin * problem.grid.y(column), creep.y, creep.spin}
                                 : problem.columns[static_cast<std::size_t>(column)];
}

double frictionOf(const CreepProblem& problem, int column)
{
  const auto index = static_cast<std::size_t>(column);
  const Creepage& creepage = problem.columns.empty() ? problem.creepage : problem.columns[index];
  return problem.friction.at(slipVelocity(problem.speed, creepage));
}

double pressureScale(const CreepProblem& problem)
{
  return problem.normal_force / (problem.pressure.sum() * problem.grid.cellArea());
}

/// Sums over the strips of an ellipse. Lengths and moments of the strips are those of their ellipses.
struct CreepStrips::Sums
{
  double area = 0, first_x = 0, first_y = 0, second_x = 0, second_y = 0;  ///< [m^2], [m^3], [m^4]
  double force = 0, moment = 0;                                           ///< the latter times x

  Ellipse ellipse() const
  {
    const double x = first_x / area, y = first_y / area;
    return {area, std::sqrt((second_x / area - x * x) / (second_y / area - y * y))};
  }
};

void CreepStrips::measure(const CreepProblem& problem)
{
  const double area = pressureScale(problem) * problem.grid.cellArea();
  strips_.clear();
  for (int j = 0; j < problem.grid.ny; ++j)
  {
    strips_.push_back(stripOf(problem, j));
    strips_.back().force *= area;
  }
  for (int j = 0; j < problem.grid.ny; ++j)
  {
    strips_[static_cast<std::size_t>(j)].area = areaOf(problem, j);
  }
}

CreepStrips::Ellipse CreepStrips::ellipseOf(const CreepProblem& problem, double first, double end) const
{
  Sums sums;
  for (int j = static_cast<int>(first); j < end; ++j)
  {
    addTo(sums, problem, j, std::min(end, j + 1.0) - std::max(first, double(j)));
  }
  return sums.ellipse();
}

const std::vector<CreepStrip>& CreepStrips::find(const CreepProblem& problem)
{
  measure(problem);
  const Eigen::Index most = std::max<Eigen::Index>(problem.grid.ny, shares_.rows());
  shares_.setZero(most, most);
  creepages_.setZero(most);
  bool is_same = false;  // all strips that belong together have one ellipse
  for (int j = 0; j < problem.grid.ny; ++j)
  {
    if (is_same && forceOf(j) > 0)
    {
      CreepStrip& strip = strips_[static_cast<std::size_t>(j)];
      strip.flexibility = (&strip - 1)->flexibility;
      strip.middle = (&strip - 1)->middle;
      shares_.col(j) = shares_.col(j - 1);
      continue;
    }
    setEllipse(problem, j);
    is_same = forceOf(j) > 0 && !(forceOf(j - 1) > 0) && hasOnePeak(j);
  }
  return roll(problem);
}

const std::vector<CreepStrip>& CreepStrips::roll(const CreepProblem& problem)
{
  for (int j = 0; j < problem.grid.ny; ++j)
  {
    creepages_[j] = creepageOf(problem, j).x;
  }
  for (int j = 0; j < problem.grid.ny; ++j)
  {
    strips_[static_cast<std::size_t>(j)].creepage_x = shares_.col(j).dot(creepages_);
  }
  return strips_;
}

/// True if the force rises and then falls from a strip on to the first one without force.
bool CreepStrips::hasOnePeak(int column) const
{
  int j = column;
  for (; forceOf(j + 1) >= forceOf(j); ++j)
  {
  }
  for (; forceOf(j + 1) > 0 && forceOf(j + 1) <= forceOf(j); ++j)
  {
  }
  return !(forceOf(j + 1) > 0);
}

/// Zero beside the grid.
double CreepStrips::forceOf(int column) const
{
  const bool exists = column >= 0 && column < static_cast<int>(strips_.size());
  return exists ? strips_[static_cast<std::size_t>(column)].force : 0;
}

/// Area of a strip [m^2]. At the edge of a patch, where the force grows linearly from zero, only a share of the width
/// is loaded. It follows from the force of the strip beside it, and is one from a third of it on.
double CreepStrips::areaOf(const CreepProblem& problem, int column) const
{
  const double beside = std::max(forceOf(column - 1), forceOf(column + 1));
  const double ratio = beside > 0 ? forceOf(column) / beside : 1;
  const double share = std::min(1.0, ratio + std::sqrt(ratio * ratio + ratio));
  return 2 * strips_[static_cast<std::size_t>(column)].half * share * problem.grid.dy;
}

void CreepStrips::addTo(Sums& sums, const CreepProblem& problem, int column, double weight) const
{
  const CreepStrip& strip = strips_[static_cast<std::size_t>(column)];
  const double width = problem.grid.dy, x = strip.centre, y = problem.grid.y(column);
  const double area = weight * strip.area, force = weight * strip.force;
  sums.area += area;
  sums.first_x += area * x;
  sums.first_y += area * y;
  sums.second_x += area * (x * x + strip.half * strip.half / 3);
  sums.second_y += area * (y * y + width * width / 12);
  sums.force += force;
  sums.moment += force * x;
}

void CreepStrips::setEllipse(const CreepProblem& problem, int column)
{
  CreepStrip& strip = strips_[static_cast<std::size_t>(column)];
  if (!(strip.force > 0))
  {
    return;
  }
  Sums sums;
  const auto add = [&](int k, double weight)
  {
    addTo(sums, problem, k, weight);
    shares_(k, column) = weight * forceOf(k);
  };
  visitConnected(
      problem.grid.ny, column, [&](int k) { return forceOf(k); }, add);
  shares_.col(column) /= sums.force;
  strip.middle = sums.moment / sums.force;
  const auto [area, ratio] = sums.ellipse();
  const double over_modulus = std::sqrt(area * ratio / pi) / problem.elasticity.modulus;
  const KalkerCoefficients c = kalkerCoefficients(ratio, problem.elasticity.poisson);
  strip.flexibility = {8 * over_modulus / (3 * c.c11), 8 * over_modulus / (3 * c.c22),
                       pi * over_modulus * std::sqrt(ratio) / (4 * c.c23)};
}
}  // namespace wheel_rail_contact::core
