// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/hertz_solver.h"

#include "core/constants.h"
#include "core/normal/solvers/patch_fields.h"

namespace wheel_rail_contact::core
{
namespace
{
using Eigen::Index;

/// Output of test/calibration/calibrate_error_estimate.cpp in revision 46df9a4.
constexpr ShapeWeights error_weights{{3.8e-05, 1.07, 0.16, 0}, {0.00103, 2.56, 0.269, 0}, {4.11e-05, 0.797, 0.0419, 0}};

/// Lowest cell of a gap and its eight neighbours. If the lowest cell is on the border, the next one inside is used.
/// Beyond x = 0 of a symmetric grid the cells are the mirror image; the lowest cell is assumed to be in the first row.
class LowestCells
{
 public:
  explicit LowestCells(const PatchGap& gap) : gap_(gap.gap)
  {
    if (gap.grid.symmetric)
    {
      gap_.row(0).minCoeff(&column_);
    }
    else
    {
      gap_.minCoeff(&row_, &column_);
      row_ = std::clamp<Index>(row_, 1, gap_.rows() - 2);
    }
    column_ = std::clamp<Index>(column_, 1, gap_.cols() - 2);
  }

  int row() const { return static_cast<int>(row_); }
  int column() const { return static_cast<int>(column_); }
  double at(Index along, Index across) const
  {
    const Index row = row_ + along;
    return gap_(row < 0 ? -1 - row : row, column_ + across);
  }

 private:
  const Eigen::ArrayXXd& gap_;
  Index row_ = 0, column_ = 0;
};

bool isLargeEnough(const PatchGap& patch)
{
  return patch.grid.rows() >= (patch.grid.symmetric ? 2 : 3) && patch.grid.ny >= 3;
}

/// Principal directions and curvatures from the second derivatives xx, xy, yy [1/m]. The coefficients of the gap are
/// half of the curvatures.
void setPrincipal(double xx, double xy, double yy, GapMinimum& minimum)
{
  const double mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy), radius = std::hypot(half, xy);
  const bool along_x = half >= 0;  // the first direction is the one nearer to x
  minimum.angle = radius > 0 ? 0.5 * std::atan2(along_x ? xy : -xy, std::abs(half)) : 0;
  minimum.curvature.a = 0.5 * (along_x ? mean + radius : mean - radius);
  minimum.curvature.b = 0.5 * (along_x ? mean - radius : mean + radius);
}

/// Sections of an ellipse along x.
class Sections
{
 public:
  Sections(const GapMinimum& minimum, const HertzContact& contact)
  {
    const double cosine = std::cos(minimum.angle), sine = std::sin(minimum.angle);
    const double first = 1 / (contact.semi_axis_x * contact.semi_axis_x);
    const double second = 1 / (contact.semi_axis_y * contact.semi_axis_y);
    const double xx = cosine * cosine * first + sine * sine * second;
    const double xy = cosine * sine * (first - second);
    tilt_ = -xy / xx;
    reach_ = 1 / std::sqrt(xx);
    half_x_ = std::hypot(cosine * contact.semi_axis_x, sine * contact.semi_axis_y);
    half_y_ = std::hypot(sine * contact.semi_axis_x, cosine * contact.semi_axis_y);
  }

  double halfX() const { return half_x_; }  ///< extent of the ellipse along x, from its centre [m]
  double halfY() const { return half_y_; }  ///< extent along y, from its centre [m]

  /// x of the middle of the section at y [m]. Both are measured from the centre of the ellipse.
  double middle(double y) const { return tilt_ * y; }
  /// Half-length of the section at y [m]. y is measured from the centre of the ellipse and must be within its extent.
  double halfLength(double y) const { return reach_ * std::sqrt(std::max(1 - y * y / (half_y_ * half_y_), 0.0)); }
  double longest() const { return reach_; }  ///< half-length of the section through the centre [m]

 private:
  double tilt_ = 0, reach_ = 0, half_x_ = 0, half_y_ = 0;
};

/// Integral of sqrt(1 - t²) from the left end of a section to t; lengths in half-lengths of the section.
double semicircle(double t)
{
  constexpr double quarter = 0.25 * pi;
  if (std::abs(t) >= 1)
  {
    return t > 0 ? 2 * quarter : 0;
  }
  return quarter + 0.5 * (t * std::sqrt(1 - t * t) + std::asin(t));
}

/// Adds the load of a section to the cells of a column: `factor` times its integral along x over each cell.
void addSection(const Grid& grid, double middle, double half_length, double factor, Eigen::ArrayXXd::ColXpr column)
{
  const auto up_to = [&](int row) { return semicircle((grid.x(row) - 0.5 * grid.dx - middle) / half_length); };
  double before = up_to(0);
  for (int i = 0; i < grid.rows(); ++i)
  {
    const double after = up_to(i + 1);
    column(i) += factor * (after - before);
    before = after;
  }
}

/// Adds the means of the ellipsoidal pressure over the cells. They are exact along x. Across, a Gauss rule with two
/// points over the loaded part of each column is used. It is exact for the sum: all cells together carry the force, to
/// rounding.
void addEllipsoid(const GapMinimum& minimum, const Sections& sections, double max_pressure, const Grid& grid,
                  Eigen::ArrayXXd& pressure)
{
  for (int j = 0; j < grid.ny; ++j)
  {
    const double begin = std::max(grid.y(j) - 0.5 * grid.dy - minimum.y, -sections.halfY());
    const double end = std::min(grid.y(j) + 0.5 * grid.dy - minimum.y, sections.halfY());
    for (const double place : {-std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)})
    {
      const double y = 0.5 * (begin + end + place * (end - begin)), half_length = sections.halfLength(y);
      if (end > begin && half_length > 0)
      {
        const double share = 0.5 * (end - begin) / grid.dy * half_length / grid.dx * half_length / sections.longest();
        addSection(grid, minimum.x + sections.middle(y), half_length, share * max_pressure, pressure.col(j));
      }
    }
  }
}

/// Distributes the part beyond the border of the grid over the loaded cells, mostly at the edge, so that they carry the
/// force of the contact. Does nothing if the cells would exceed the highest pressure.
void addCutOff(const HertzContact& contact, const Grid& grid, Eigen::ArrayXXd& pressure)
{
  const double missing = contact.force / grid.cellArea() - pressure.sum();
  const auto room = (pressure > 0).select(contact.max_pressure - pressure, 0.0);
  const double most = room.sum();
  if (missing > 0 && missing < most)
  {
    pressure += missing / most * room;
  }
}

bool isCut(const GapMinimum& minimum, const Sections& sections, const Grid& grid)
{
  const double end_x = 0.5 * grid.nx * grid.dx;
  return std::abs(minimum.x) + sections.halfX() > end_x || minimum.y - sections.halfY() < grid.y(0) - 0.5 * grid.dy ||
         minimum.y + sections.halfY() > grid.y(grid.ny - 1) + 0.5 * grid.dy;
}

/// Puts the ellipsoidal pressure on the cells; zero for a contact without area.
void layPressure(const GapMinimum& minimum, const HertzContact& contact, PatchPressure& patch)
{
  patch.pressure.setZero(patch.grid.rows(), patch.grid.ny);
  patch.touches_border = false;
  if (!(contact.area > 0))
  {
    return;
  }
  const Sections sections(minimum, contact);
  patch.touches_border = isCut(minimum, sections, patch.grid);
  addEllipsoid(minimum, sections, contact.max_pressure, patch.grid, patch.pressure);
  if (patch.touches_border)
  {
    addCutOff(contact, patch.grid, patch.pressure);
  }
}

/// The contact at another approach: lengths and pressure are proportional to its root.
HertzContact scaled(const HertzContact& unit, double approach)
{
  const double root = std::sqrt(approach);
  HertzContact contact = unit;
  contact.semi_axis_x *= root;
  contact.semi_axis_y *= root;
  contact.max_pressure *= root;
  contact.approach = approach;
  contact.force *= approach * root;
  contact.area *= approach;
  return contact;
}
}  // namespace

GapMinimum fitMinimum(const PatchGap& gap)
{
  const Grid& grid = gap.grid;
  const LowestCells cells(gap);
  const double gx = (cells.at(1, 0) - cells.at(-1, 0)) / (2 * grid.dx);
  const double gy = (cells.at(0, 1) - cells.at(0, -1)) / (2 * grid.dy);
  const double xx = (cells.at(1, 0) - 2 * cells.at(0, 0) + cells.at(-1, 0)) / (grid.dx * grid.dx);
  const double yy = (cells.at(0, 1) - 2 * cells.at(0, 0) + cells.at(0, -1)) / (grid.dy * grid.dy);
  const double twist = cells.at(1, 1) - cells.at(1, -1) - cells.at(-1, 1) + cells.at(-1, -1);
  const double xy = grid.symmetric ? 0 : twist / (4 * grid.dx * grid.dy);
  GapMinimum minimum;
  setPrincipal(xx, xy, yy, minimum);
  const double determinant = xx * yy - xy * xy;
  double sx = 0, sy = 0;
  if (minimum.isPositive())
  {
    sx = std::clamp((xy * gy - yy * gx) / determinant, -grid.dx, grid.dx);
    sy = std::clamp((xy * gx - xx * gy) / determinant, -grid.dy, grid.dy);
  }
  minimum.gap = cells.at(0, 0) + gx * sx + gy * sy + 0.5 * (xx * sx * sx + 2 * xy * sx * sy + yy * sy * sy);
  minimum.x = grid.symmetric ? 0 : grid.x(cells.row()) + sx;
  minimum.y = grid.y(cells.column()) + sy;
  return minimum;
}

OverlapMismatch compareOverlap(const PatchGap& gap, const GapMinimum& paraboloid, double level)
{
  const Grid& grid = gap.grid;
  const double cosine = std::cos(paraboloid.angle), sine = std::sin(paraboloid.angle);
  double own = 0, ideal = 0, apart = 0;
  for (int j = 0; j < grid.ny; ++j)
  {
    const double y = grid.y(j) - paraboloid.y;
    for (int i = 0; i < grid.rows(); ++i)
    {
      const double x = grid.x(i) - paraboloid.x;
      const double first = cosine * x + sine * y, second = cosine * y - sine * x;
      const double smooth =
          paraboloid.gap + paraboloid.curvature.a * first * first + paraboloid.curvature.b * second * second;
      const double depth = std::max(level - gap.gap(i, j), 0.0), smooth_depth = std::max(level - smooth, 0.0);
      own += depth;
      ideal += smooth_depth;
      apart += std::abs(depth - smooth_depth);
    }
  }
  return own > 0 && ideal > 0 ? OverlapMismatch{std::abs(std::log(own / ideal)), 2 * apart / (own + ideal)}
                              : OverlapMismatch{};
}

void HertzSolver::solve(const NormalProblem& problem, bool /*warm*/, NormalSolution& solution)
{
  solution.patches.resize(problem.patches.size());
  solution.iterations = 0;
  solution.residual = 0;
  solution.status = isValid(problem) ? fit(problem) : SolveStatus::invalid_problem;
  if (solution.status != SolveStatus::converged)
  {
    return;
  }
  solution.approach = problem.control == NormalProblem::Control::load ? approachForLoad(problem) : problem.value;
  bool touches = false;
  for (std::size_t k = 0; k < ellipses_.size(); ++k)
  {
    const PatchGap& gap = problem.patches[k];
    const GapMinimum& minimum = ellipses_[k].minimum;
    const double own = std::max(gap.weight * solution.approach - minimum.gap, 0.0);
    const HertzContact contact = scaled(ellipses_[k].unit, own);
    PatchPressure& patch = solution.patches[k];
    patch.grid = gap.grid;
    patch.force = contact.force;
    patch.max_pressure = contact.max_pressure;
    patch.area = contact.area;
    patch.moved_at_discontinuities = 0;
    layPressure(minimum, contact, patch);
    measures_.measureRatio(patch);
    touches = touches || own > 0;
  }
  solution.status = touches ? SolveStatus::converged : SolveStatus::no_contact;
}

/// Fits all patches. Returns no_positive_curvature if the curvatures of a patch are not positive.
SolveStatus HertzSolver::fit(const NormalProblem& problem)
{
  ellipses_.resize(problem.patches.size());
  for (std::size_t k = 0; k < ellipses_.size(); ++k)
  {
    if (!isLargeEnough(problem.patches[k]))
    {
      return SolveStatus::invalid_problem;
    }
    Ellipse& ellipse = ellipses_[k];
    ellipse.minimum = fitMinimum(problem.patches[k]);
    if (!ellipse.minimum.isPositive())
    {
      return SolveStatus::no_positive_curvature;
    }
    ellipse.unit = hertzForApproach(ellipse.minimum.curvature, problem.modulus, 1);
  }
  return SolveStatus::converged;
}

/// Common approach that carries the load [m]. The sum of the forces is convex in the approach. Newton's method
/// therefore converges from above. It starts at the lowest approach at which one patch alone would carry the load.
double HertzSolver::approachForLoad(const NormalProblem& problem) const
{
  constexpr int most_steps = 50;
  double approach = infinity;
  for (std::size_t k = 0; k < ellipses_.size(); ++k)
  {
    const double weight = problem.patches[k].weight;
    const double alone = std::cbrt(std::pow(problem.value / (weight * ellipses_[k].unit.force), 2));
    approach = std::min(approach, (ellipses_[k].minimum.gap + alone) / weight);
  }
  for (int step = 0; step < most_steps; ++step)
  {
    double load = 0, stiffness = 0;
    for (std::size_t k = 0; k < ellipses_.size(); ++k)
    {
      const double weight = problem.patches[k].weight;
      const double own = std::max(weight * approach - ellipses_[k].minimum.gap, 0.0);
      const double root = weight * ellipses_[k].unit.force * std::sqrt(own);
      load += root * own;
      stiffness += 1.5 * weight * root;
    }
    const double change = (problem.value - load) / stiffness;
    approach += change;
    if (!(std::abs(load - problem.value) > 1e-12 * problem.value))
    {
      break;
    }
  }
  return approach;
}

ShapeTerms HertzSolver::errorTerms(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch)
{
  const PatchGap& gap = problem.patches[patch];
  const GapMinimum minimum = fitMinimum(gap);
  const double approach = gap.weight * solution.approach - minimum.gap;
  if (!minimum.isPositive() || !(approach > 0))
  {
    constexpr double unknown = infinity;
    return {unknown, unknown, unknown, 0};
  }
  const OverlapMismatch half = compareOverlap(gap, minimum, minimum.gap + 0.5 * approach);
  const OverlapMismatch full = compareOverlap(gap, minimum, minimum.gap + approach);
  return {1, half.volume, full.shape, 0};
}

void HertzSolver::estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                                 std::vector<ErrorEstimate>& errors) const
{
  const auto alone = [&](std::size_t k) {
    return solution.patches[k].force > 0 ? weighted(error_weights, errorTerms(problem, solution, k)) : ErrorEstimate();
  };
  withSharedApproach(problem, solution, alone, errors);
}
}  // namespace wheel_rail_contact::core
