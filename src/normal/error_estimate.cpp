// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/normal/error_estimate.h"

#include <algorithm>
#include <cmath>

#include "patch_errors.h"

namespace wheel_rail_contact
{
namespace
{
using Eigen::Index;

/// Factor of the area's error where the pressure reaches the outermost rows: the grid then does not show where it ends.
constexpr double unseen_edge = 4.0 / 3;

/// A line of cells through the crest; cells beyond the grid carry nothing, those beyond x = 0 of a symmetric grid are
/// the mirror image.
class CrestLine
{
 public:
  CrestLine(const double* first, Index stride, Index size, Index crest, bool mirrored)
      : first_(first), stride_(stride), size_(size), crest_(crest), mirrored_(mirrored), top_(first[crest * stride])
  {
  }

  /// Squared pressure over the maximum, `offset` cells from the crest.
  double q(Index offset) const
  {
    Index place = crest_ + offset;
    place = mirrored_ && place < 0 ? -1 - place : place;
    const double p = place >= 0 && place < size_ ? first_[place * stride_] / top_ : 0;
    return p * p;
  }
  double bend() const { return 2 * q(0) - q(-1) - q(1); }
  double thirdDifference() const
  {
    const double up = std::abs(q(-1) - 3 * q(0) + 3 * q(1) - q(2));
    const double down = std::abs(q(1) - 3 * q(0) + 3 * q(-1) - q(-2));
    return std::max(up, down);
  }

 private:
  const double* first_;
  Index stride_, size_, crest_;
  bool mirrored_;
  double top_;
};

/// Where the pressure lies on its grid. Counts are of the whole grid, symmetric or not.
struct Loaded
{
  Index row = 0, column = 0;     ///< of the highest cell
  double along = 0, across = 0;  ///< loaded cells in its column and in its row
  Index first = 0, last = -1;    ///< loaded columns of its row
  double thin_columns = 0;       ///< sum over loaded columns of 1 / loaded cells
  double thin_rows = 0;          ///< sum over loaded rows of 1 / loaded cells
};

void scanColumns(const Grid& grid, const Eigen::ArrayXXd& pressure, Loaded& loaded)
{
  const int images = grid.symmetric ? 2 : 1;
  double top = 0;
  for (Index j = 0; j < pressure.cols(); ++j)
  {
    const auto count = static_cast<double>(images * (pressure.col(j) > 0).count());
    const double highest = count > 0 ? pressure.col(j).maxCoeff() : 0;
    loaded.thin_columns += count > 0 ? 1 / count : 0;
    if (highest > top)
    {
      top = highest;
      loaded.column = j;
      loaded.along = count;
    }
  }
  pressure.col(loaded.column).maxCoeff(&loaded.row);
}

void scanRows(const Grid& grid, const Eigen::ArrayXXd& pressure, Loaded& loaded)
{
  constexpr Index block = 8;
  for (Index first = 0; first < pressure.rows(); first += block)
  {
    const Index size = std::min(block, pressure.rows() - first);
    std::array<double, block> count{};
    for (Index j = 0; j < pressure.cols(); ++j)
    {
      const double* p = pressure.data() + first + j * pressure.rows();
      for (Index i = 0; i < size; ++i)
      {
        count[static_cast<std::size_t>(i)] += p[i] > 0 ? 1 : 0;
      }
    }
    for (const double cells : count)
    {
      loaded.thin_rows += cells > 0 ? 1 / cells : 0;
    }
  }
  loaded.thin_rows *= grid.symmetric ? 2 : 1;

  const auto crest = pressure.row(loaded.row);
  loaded.across = static_cast<double>((crest > 0).count());
  loaded.first = 0;
  loaded.last = pressure.cols() - 1;
  while (!(crest[loaded.first] > 0))
  {
    ++loaded.first;
  }
  while (!(crest[loaded.last] > 0))
  {
    --loaded.last;
  }
}

/// How the gap's second differences across change along the crest's row [m].
struct Bending
{
  double jumps_at_crest = 0;  ///< sum of jumps over (distance from the crest + 1/2)²
  double jumps_at_edges = 0;  ///< sum of jumps within 2.5 cells of the outermost loaded cells
  double variation = 0;       ///< largest less smallest, over the mean [-]
};

Bending gapBending(const Eigen::ArrayXXd& gap, const Loaded& loaded)
{
  const auto line = gap.row(loaded.row);
  const Index first = std::max<Index>(loaded.first - 1, 1), last = std::min(loaded.last + 1, gap.cols() - 2);
  Bending bending;
  double low = INFINITY, high = -INFINITY, sum = 0, before = 0;
  int count = 0;
  for (Index j = first; j <= last; ++j)
  {
    const double second = line[j + 1] - 2 * line[j] + line[j - 1];
    if (j >= loaded.first && j <= loaded.last)
    {
      low = std::min(low, second);
      high = std::max(high, second);
      sum += second;
      ++count;
    }
    const double jump = j > first ? std::abs(second - before) : 0;
    const double place = static_cast<double>(j) - 0.5;
    const double distance = std::abs(place - static_cast<double>(loaded.column)) + 0.5;
    const double from_edge = std::min(std::abs(place - static_cast<double>(loaded.first)),
                                      std::abs(place - static_cast<double>(loaded.last)));
    bending.jumps_at_crest += jump / (distance * distance);
    bending.jumps_at_edges += from_edge < 2.5 ? jump : 0;
    before = second;
  }
  bending.variation = count > 0 && sum != 0 ? (high - low) * count / std::abs(sum) : 0;
  return bending;
}

double largestApproach(const NormalProblem& problem, const NormalSolution& solution)
{
  double largest = 0;
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    largest = std::max(largest, ownApproach(problem, solution, k));
  }
  return largest;
}

/// Errors of a patch as if it were alone under its own load.
ErrorEstimate errorsAlone(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch,
                          double largest_approach)
{
  const double own = ownApproach(problem, solution, patch);
  if (!(solution.patches[patch].max_pressure > 0) || !(own > 0))
  {
    return {};
  }
  const double residual = solution.residual * largest_approach / own;
  const ErrorTerms terms = errorTerms(problem.patches[patch], solution.patches[patch], problem.modulus, residual);
  const ErrorWeights& weights = gridErrorWeights();
  return {weighted(weights.max_pressure, terms.max_pressure), weighted(weights.area, terms.area),
          weighted(weights.approach, terms.approach)};
}
}  // namespace

double ErrorEstimate::largest() const
{
  return std::max({max_pressure, area, approach});
}

ErrorEstimate largestOf(const ErrorEstimate& one, const ErrorEstimate& other)
{
  return {std::max(one.max_pressure, other.max_pressure), std::max(one.area, other.area),
          std::max(one.approach, other.approach)};
}

ErrorTerms errorTerms(const PatchGap& gap, const PatchPressure& pressure, double modulus, double residual)
{
  const Grid& grid = gap.grid;
  const Eigen::ArrayXXd& p = pressure.pressure;
  Loaded loaded;
  scanColumns(grid, p, loaded);
  scanRows(grid, p, loaded);
  const CrestLine along(p.data() + loaded.column * p.rows(), 1, p.rows(), loaded.row, grid.symmetric);
  const CrestLine across(p.data() + loaded.row, p.rows(), p.cols(), loaded.column, false);
  const Bending bending = gapBending(gap.gap, loaded);

  const double per_cell = grid.dx * grid.dy / pressure.area;
  const double as_pressure = modulus / (grid.dy * pressure.max_pressure);
  const double jump = as_pressure * bending.jumps_at_crest;
  const double longer = std::max(std::log(grid.dx / grid.dy), 0.0);
  const double mean_along = 1 / (per_cell * loaded.across);
  const double variation = bending.variation / (loaded.across * loaded.across);
  const double few_along = 1 / (loaded.along * loaded.along);
  ErrorTerms terms;
  terms.max_pressure = {along.bend() + across.bend(), along.thirdDifference() + across.thirdDifference(), jump * jump};
  terms.area = {longer / std::cbrt(mean_along * mean_along),
                loaded.thin_columns * per_cell,
                loaded.thin_rows * per_cell,
                as_pressure * bending.jumps_at_edges * per_cell,
                variation,
                few_along,
                residual};
  terms.approach = {few_along, variation, residual};
  if (loaded.along >= grid.nx)
  {
    std::transform(terms.area.begin(), terms.area.end(), terms.area.begin(),
                   [](double term) { return unseen_edge * term; });
  }
  return terms;
}

const ErrorWeights& gridErrorWeights()
{
  // As printed by test/calibration/calibrate_error_estimate.cpp.
  static constexpr ErrorWeights weights{
      {0.0307, 0.0135, 0.0365}, {0.00557, 0.0642, 0.187, 1.20, 0.104, 0.0921, 1.22}, {0.186, 0.0409, 0.503}};
  return weights;
}

double ownApproach(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch)
{
  const PatchGap& gap = problem.patches[patch];
  return gap.weight * solution.approach - gap.gap.minCoeff();
}

ErrorEstimate estimateGridError(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch)
{
  const double largest = largestApproach(problem, solution);
  return inCommon(problem, solution, patch, [&](std::size_t k) { return errorsAlone(problem, solution, k, largest); });
}
}  // namespace wheel_rail_contact
