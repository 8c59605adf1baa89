// SPDX-License-Identifier: BSD-3-Clause
#include "core/creep/exact_rolling.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/creep/row_products.h"
#include "core/creep/simplified_theory.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr int most_sweeps = 200;
/// The sweeps end when the tractions change by less than this share of their own sum.
constexpr double change_tolerance = 5e-4;
/// Place of a step's rigid slip, in cells ahead of its end. It is the middle for cells that stick, and the end for
/// cells that slip, where the traction is opposite to the slip at its own place: taken is the mean of both.
constexpr double slip_place = 0.25;
// Error of the forces by the cells, for n loaded rows: error_by_rows / n. See doc/theory.md.
constexpr double error_by_rows = 0.6;
}  // namespace

void VectorField::resize(int size)
{
  x.resize(size);
  y.resize(size);
}

CreepStatus ExactRolling::fill(const CreepProblem& problem, bool warm, CreepSolution& solution)
{
  if (!hasPressure(problem))
  {
    return CreepStatus::invalid_problem;
  }
  if (isAgain())
  {
    addRigid(-1);
    prepare(problem);
    addRigid(1);
  }
  else
  {
    prepare(problem);
    const bool continues = warm && solution.traction_x.rows() == nx_ && solution.traction_x.cols() == ny_ &&
                           solution.traction_y.rows() == nx_ && solution.traction_y.cols() == ny_;
    continues ? startFrom(solution) : startOnStrips(problem);
    findSlip();
  }
  bool is_converged = false;
  double change = 0;
  while (!is_converged && solution.iterations < most_sweeps)
  {
    const SweepSums sums = sweep();
    change = sums.change / bound_sum_;
    is_converged = sums.change <= change_tolerance * sums.traction;
    ++solution.iterations;
  }
  store(problem, solution);
  const auto loaded = [](const LoadedColumns& range) { return !range.isEmpty(); };
  const auto rows = std::count_if(ranges_.begin(), ranges_.end() - 2, loaded);
  solution.error_estimate = error_by_rows / static_cast<double>(rows) + change;
  return is_converged ? CreepStatus::converged : CreepStatus::iteration_limit;
}

void ExactRolling::prepare(const CreepProblem& problem)
{
  const PatchGrid& grid = problem.grid;
  direction_ = directionOf(problem);
  nx_ = grid.nx;
  ny_ = grid.ny;
  line_ = roundUpToLanes(ny_);
  table_ = &tables_.find(nx_ + 1, ny_, grid.dx / grid.dy, problem.elasticity.poisson);
  ranges_.assign(static_cast<std::size_t>(nx_) + 2, {ny_, 0});
  stepped_.resize(static_cast<std::size_t>(ny_));
  const int size = (nx_ + 2) * line_;
  bound_.resize(size);
  for (VectorField* field : {&traction_, &rigid_, &slip_})
  {
    field->resize(size);
  }
  step_.resize(line_);
  moved_.resize(line_);
  const double scale = pressureScale(problem);
  friction_.resize(line_);
  for (int j = 0; j < ny_; ++j)
  {
    friction_[j] = scale * frictionOf(problem, gridColumn(j));
  }
  bound_sum_ = 0;
  for (int row = 0; row < nx_; ++row)
  {
    setRow(problem, row);
  }
  widenRanges();
}

void ExactRolling::setRow(const CreepProblem& problem, int row)
{
  const PatchGrid& grid = problem.grid;
  const double unit = pi * problem.elasticity.modulus * grid.dx / grid.dy;
  const double ahead = direction_ * grid.x(gridRow(row)) + slip_place * grid.dx;
  LoadedColumns& range = ranges_[static_cast<std::size_t>(row)];
  for (int j = 0; j < ny_; ++j)
  {
    const int at = row * line_ + j;
    const Creepage creep = creepageOf(problem, gridColumn(j));
    bound_[at] = friction_[j] * problem.pressure(gridRow(row), gridColumn(j));
    bound_sum_ += bound_[at];
    rigid_.x[at] = unit * direction_ * creep.x;
    rigid_.y[at] = unit * (direction_ * creep.y + creep.spin * ahead);
    if (problem.pressure(gridRow(row), gridColumn(j)) > 0)
    {
      range.first = std::min(range.first, j);
      range.end = j + 1;
    }
  }
}

void ExactRolling::widenRanges()
{
  const int last = nx_ * line_;
  std::fill_n(bound_.data() + last, line_, 0.0);
  std::fill_n(rigid_.x.data() + last, line_, 0.0);
  std::fill_n(rigid_.y.data() + last, line_, 0.0);
  for (std::size_t row = ranges_.size() - 2; row > 0; --row)
  {
    ranges_[row].first = std::min(ranges_[row].first, ranges_[row - 1].first);
    ranges_[row].end = std::max(ranges_[row].end, ranges_[row - 1].end);
  }
}

void ExactRolling::startOnStrips(const CreepProblem& problem)
{
  const std::vector<CreepStrip>& strips = strips_.find(problem);
  const double step = problem.grid.dy / (pi * problem.elasticity.modulus);  // a cell's length over the unit of slip
  for (int j = 0; j < ny_; ++j)
  {
    const CreepStrip& strip = strips[static_cast<std::size_t>(gridColumn(j))];
    double x = 0, y = 0;
    for (int row = 0; row <= nx_; ++row)
    {
      const int at = row * line_ + j;
      if (strip.force > 0)
      {
        x -= step * rigid_.x[at] / strip.flexibility.x;
        y -= step * rigid_.y[at] / strip.flexibility.y;
      }
      const double length = std::sqrt(x * x + y * y), factor = length > bound_[at] ? bound_[at] / length : 1;
      traction_.x[at] = x *= factor;
      traction_.y[at] = y *= factor;
    }
  }
}

void ExactRolling::startFrom(const CreepSolution& solution)
{
  for (int row = 0; row <= nx_; ++row)
  {
    for (int j = 0; j < ny_; ++j)
    {
      const int at = row * line_ + j;
      const bool is_loaded = bound_[at] > 0;
      traction_.x[at] = is_loaded ? direction_ * solution.traction_x(gridRow(row), gridColumn(j)) : 0;
      traction_.y[at] = is_loaded ? direction_ * solution.traction_y(gridRow(row), gridColumn(j)) : 0;
    }
  }
}

void ExactRolling::findSlip()
{
  std::fill_n(slip_.x.data(), (nx_ + 2) * line_, 0.0);
  std::fill_n(slip_.y.data(), (nx_ + 2) * line_, 0.0);
  addRigid(1);
  for (int row = 0; row <= nx_; ++row)
  {
    const int at = row * line_, ahead = at - line_;
    for (int j = 0; j < line_; ++j)
    {
      step_.x[j] = traction_.x[at + j] - (row > 0 ? traction_.x[ahead + j] : 0);
      step_.y[j] = traction_.y[at + j] - (row > 0 ? traction_.y[ahead + j] : 0);
    }
    addSteps(row, true);
  }
}

void ExactRolling::addRigid(double factor)
{
  for (int at = 0; at < (nx_ + 1) * line_; ++at)
  {
    slip_.x[at] += factor * rigid_.x[at];
    slip_.y[at] += factor * rigid_.y[at];
  }
}

/// The rows at a distance behind and ahead share a product.
void ExactRolling::addSteps(int row, bool to_itself)
{
  RowProduct product;
  const LoadedColumns& source = ranges_[static_cast<std::size_t>(row)];
  for (int j = source.first; j < source.end; ++j)
  {
    stepped_[static_cast<std::size_t>(product.count)] = j;
    product.count += step_.x[j] != 0 || step_.y[j] != 0 ? 1 : 0;
  }
  product.columns = stepped_.data();
  product.step_x = step_.x.data();
  product.step_y = step_.y.data();
  const auto inside = [&](int target) { return target >= 0 && target <= nx_ ? target : nx_ + 1; };
  for (int distance = to_itself ? 0 : 1; distance <= std::max(row, nx_ - row); ++distance)
  {
    const int behind = inside(row + distance), ahead = inside(distance > 0 ? row - distance : -1);
    const LoadedColumns &one = ranges_[static_cast<std::size_t>(behind)],
                        &other = ranges_[static_cast<std::size_t>(ahead)];
    product.target_first = std::min(one.first, other.first);
    product.target_end = product.count > 0 ? std::max(one.end, other.end) : 0;
    product.behind_x = slip_.x.data() + behind * line_;
    product.behind_y = slip_.y.data() + behind * line_;
    product.ahead_x = slip_.x.data() + ahead * line_;
    product.ahead_y = slip_.y.data() + ahead * line_;
    product.influence = table_->row(distance);
    addProduct(product);
  }
}

ExactRolling::SweepSums ExactRolling::sweep()
{
  SweepSums sums;
  std::fill_n(moved_.x.data(), line_, 0.0);
  std::fill_n(moved_.y.data(), line_, 0.0);
  for (int row = 0; row <= nx_; ++row)
  {
    const LoadedColumns range = ranges_[static_cast<std::size_t>(row)];
    if (!range.isEmpty())
    {
      solve(row, range, sums);
    }
  }
  return sums;
}

void ExactRolling::solve(int row, const LoadedColumns& range, SweepSums& sums)
{
  const int at = row * line_;
  RowCells cells;
  cells.first = range.first;
  cells.end = range.end;
  cells.bound = bound_.data() + at;
  cells.x = traction_.x.data() + at;
  cells.y = traction_.y.data() + at;
  cells.slip_x = slip_.x.data() + at;
  cells.slip_y = slip_.y.data() + at;
  cells.step_x = step_.x.data();
  cells.step_y = step_.y.data();
  cells.influence = table_->row(0);
  for (int j = range.first; j < range.end; ++j)
  {
    cells.x[j] += moved_.x[j];
    cells.y[j] += moved_.y[j];
    step_.x[j] = step_.y[j] = 0;
  }
  solveRow(cells);
  for (int j = range.first; j < range.end; ++j)
  {
    moved_.x[j] += step_.x[j];
    moved_.y[j] += step_.y[j];
    sums.change += std::abs(moved_.x[j]) + std::abs(moved_.y[j]);
    sums.traction += std::abs(cells.x[j]) + std::abs(cells.y[j]);
  }
  addSteps(row, false);
}

void ExactRolling::store(const CreepProblem& problem, CreepSolution& solution) const
{
  const PatchGrid& grid = problem.grid;
  solution.traction_x.resize(nx_, ny_);
  solution.traction_y.resize(nx_, ny_);
  solution.columns.assign(static_cast<std::size_t>(ny_), {});
  solution.limits.assign(static_cast<std::size_t>(ny_), 0);
  const double area = grid.cellArea();
  for (int row = 0; row < nx_; ++row)
  {
    const int i = gridRow(row);
    for (int column = 0; column < ny_; ++column)
    {
      const int at = row * line_ + column, j = gridColumn(column);
      const double px = direction_ * traction_.x[at], py = direction_ * traction_.y[at];
      solution.traction_x(i, j) = px;
      solution.traction_y(i, j) = py;
      CreepForce& sum = solution.columns[static_cast<std::size_t>(j)];
      solution.limits[static_cast<std::size_t>(j)] += area * bound_[at];
      sum.x += area * px;
      sum.y += area * py;
      sum.moment += area * grid.x(i) * py;
    }
  }
}
}  // namespace wheel_rail_contact::core
