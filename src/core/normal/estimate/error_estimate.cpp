// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/estimate/error_estimate.h"

#include "core/constants.h"
#include "core/normal/measures/cells_around.h"
#include "core/normal/measures/gap_steps.h"
#include "core/normal/measures/pressure_measures.h"

namespace wheel_rail_contact::core
{
namespace
{
using Eigen::Index;

/// Factor of the area error where the pressure fills its grid along or across the track, so that its end is not
/// visible.
constexpr double unseen_edge = 4.0 / 3;

/// Increase of the area error by the cell aspect, per unit of its logarithm.
constexpr double long_cells = 0.5;

/// Sum of 1 / (loaded cells) over the columns of an oval, times (cells along) / (cells across): pi / 2 for an ellipse.
constexpr double oval = 1.6;

/// Displacement of the edge by curvature discontinuities, summed, up to which the area error does not increase [cells].
constexpr double usual_move = 0.2;

/// Columns of at most `narrow_cells` loaded cells are narrower than the cells resolve. The tips of an oval have up to
/// `narrow_tips` of them. Each further one belongs to a narrow end and adds `narrow_end_cells` cells to the area error.
/// Taken from known narrow ends: test/core/normal/error_estimate_test.cpp, 6 kN at 0.6 mm.
constexpr int narrow_cells = 2;
constexpr int narrow_tips = 4;
constexpr double narrow_end_cells = 1.7;

/// Area error of a contact of few cells, times the square of its number of cells. Six cells have an error above 10 %.
/// From 33 cells on the weighted terms are larger.
constexpr double few_cells_error = 6;

/// Possible growth of a secondary peak that has an unloaded neighbour across the track: a lobe of two columns. Taken
/// from one case, test/core/balance/warm_start_test.cpp, in which it grows by 0.64 to 0.96 of its value.
constexpr double lobe_growth = 1;

/// Factor of the errors of a patch whose weight is less: a contact angle of 37 degrees, for yaw in the root [-]. Set by
/// hand on 3 400 patches of 800 random wheelsets (S1002 on 60E1 and UIC60).
constexpr double steep_factor = 1.5, steep_weight = 0.8;

/// Limit for the jumps at a peak. The estimate is then above 100 %.
constexpr double largest_jump = 4;

/// Cell that is the highest of its column and not exceeded by a neighbouring column.
struct Peak
{
  Index row = 0, column = 0;
  Index first = 0, last = -1;  ///< outermost loaded columns of its row
};

Peak peakAt(const Eigen::ArrayXXd& pressure, Index row, Index column)
{
  Peak peak{row, column, 0, pressure.cols() - 1};
  while (!(pressure(row, peak.first) > 0))
  {
    ++peak.first;
  }
  while (!(pressure(row, peak.last) > 0))
  {
    --peak.last;
  }
  return peak;
}

/// Loaded part of the grid. Counts refer to the whole grid, symmetric or not.
struct Loaded
{
  Peak peak;                     ///< the highest peak
  double along = 0, across = 0;  ///< loaded cells in the column and in the row of the peak
  double thin_columns = 0;       ///< sum over loaded columns of 1 / loaded cells
  int narrow_columns = 0;        ///< columns of at most narrow_cells loaded cells
};

Loaded findLoaded(const Grid& grid, const Eigen::ArrayXXd& pressure)
{
  Loaded loaded;
  double top = 0;
  Index row = 0, column = 0;
  for (Index j = 0; j < pressure.cols(); ++j)
  {
    const double highest = pressure.col(j).maxCoeff();
    if (highest > top)
    {
      top = highest;
      column = j;
    }
    const Index cells = (grid.symmetric ? 2 : 1) * (pressure.col(j) > 0).count();
    loaded.thin_columns += cells > 0 ? 1 / static_cast<double>(cells) : 0;
    loaded.narrow_columns += cells > 0 && cells <= narrow_cells ? 1 : 0;
  }
  pressure.col(column).maxCoeff(&row);
  loaded.peak = peakAt(pressure, row, column);
  loaded.along = static_cast<double>((grid.symmetric ? 2 : 1) * (pressure.col(column) > 0).count());
  loaded.across = static_cast<double>((pressure.row(row) > 0).count());
  return loaded;
}

/// Changes of the second differences of the gap across the track, in the row of the peak [m].
struct Bending
{
  double jumps_at_peak = 0;  ///< sum of the jumps, each over (distance from the peak + 1/2)²
  double variation = 0;      ///< largest minus smallest, over the mean [-]
};

Bending gapBending(const Eigen::ArrayXXd& gap, const Peak& peak)
{
  const auto line = gap.row(peak.row);
  const Index first = std::max<Index>(peak.first - 1, 1), last = std::min(peak.last + 1, gap.cols() - 2);
  Bending bending;
  double low = INFINITY, high = -INFINITY, sum = 0, before = 0;
  int count = 0;
  for (Index j = first; j <= last; ++j)
  {
    const double second = line[j + 1] - 2 * line[j] + line[j - 1];
    if (j >= peak.first && j <= peak.last)
    {
      low = std::min(low, second);
      high = std::max(high, second);
      sum += second;
      ++count;
    }
    const double jump = j > first ? std::abs(second - before) : 0;
    const double place = static_cast<double>(j) - 0.5;
    const double distance = std::abs(place - static_cast<double>(peak.column)) + 0.5;
    bending.jumps_at_peak += jump / (distance * distance);
    before = second;
  }
  bending.variation = count > 0 && sum != 0 ? (high - low) * count / std::abs(sum) : 0;
  return bending;
}

/// Terms of the pressure error at a peak. `jumps` is Bending::jumps_at_peak of its row; `residual` is relative to the
/// own approach of the patch.
std::array<double, 5> peakTerms(const PatchGap& gap, double modulus, const CellsAround& peak, double jumps,
                                double residual)
{
  const double bend = peak.bend(), jump = std::min(modulus * jumps / (gap.grid.dy * peak.top()), largest_jump);
  const bool unclear = !peak.isInside() || areWaves(gapSteps(peak, gap, modulus));
  // The second term increases with the square of the bend until the peak is as sharp as the cells. Beyond that it
  // increases no faster than the errors do.
  return {bend, bend * bend / (1 + bend), std::pow(jump, 4), unclear ? bend : 0, residual};
}

/// Error of a peak that the bend does not show [-]: half of the difference of the measure from the parabolas without
/// the bias of smooth peaks, as that is inferred from other cells; and if the peak is one column from the end of the
/// pressure, the effect of the third differences.
double hiddenError(const PatchGap& gap, double modulus, const CellsAround& peak)
{
  constexpr double smooth_bias = 1.0 / 80;  // of the parabolas, over the bend
  const double added = peakPressure(gap, modulus, peak) / peak.parabolas() * (1 + smooth_bias * peak.bend()) - 1;
  return std::max(0.5 * std::abs(added), peak.isBesideEnd() ? peak.errorAcross() : 0);
}

/// Relative amount by which a secondary peak may exceed the highest one because of its own error [-].
double errorFromLowerPeak(const PatchGap& gap, const PatchPressure& pressure, double modulus, const CellsAround& peak)
{
  const Bending bending = gapBending(gap.gap, peakAt(pressure.pressure, peak.row(), peak.column()));
  const double own = weighted(gridErrorWeights().max_pressure, peakTerms(gap, modulus, peak, bending.jumps_at_peak, 0));
  const double growth = std::max(own, peak.isInside() ? hiddenError(gap, modulus, peak) : lobe_growth);
  return (1 + growth) * peakPressure(gap, modulus, peak) / pressure.max_pressure - 1;
}

/// Largest relative amount by which a peak outside the column `highest` may exceed the highest one [-]; 0 if none may.
/// The narrower of two lobes grows with finer cells.
double errorFromLowerPeaks(const PatchGap& gap, const PatchPressure& pressure, double modulus, Index highest)
{
  double most = 0;
  visitPeaks(gap.grid, pressure.pressure,
             [&](const CellsAround& peak, bool rises)
             {
               if (rises && peak.column() != highest)
               {
                 most = std::max(most, errorFromLowerPeak(gap, pressure, modulus, peak));
               }
             });
  return most;
}

/// Step of the gap between the columns j and j + 1 [m], 2 <= j < gap.cols() - 3. Zero where the gap bends smoothly, has
/// a kink or changes its curvature: only a step makes third differences that alternate (h, -2h, h).
double stepAfter(const Eigen::ArrayXXd& gap, Index row, Index j)
{
  const auto third = [&](Index k) { return gap(row, k + 2) - 3 * gap(row, k + 1) + 3 * gap(row, k) - gap(row, k - 1); };
  const double before = third(j - 1), here = -0.5 * third(j), after = third(j + 1);
  const double least = std::min({before, here, after}), most = std::max({before, here, after});
  return least > 0 ? least : most < 0 ? -most : 0;
}

/// Relative amount by which the pressure at a step of the gap in the row of the peak would exceed that of the highest
/// cell if the cells were four times finer [-]; 0 if it would not. A step h adds about E* h / (pi dy).
double errorFromSteps(const PatchGap& gap, const PatchPressure& pressure, double modulus, const Peak& peak)
{
  constexpr double finer = 4;
  const double spike = finer * modulus / (pi * gap.grid.dy);
  const auto p = pressure.pressure.row(peak.row);
  double highest = 0;
  for (Index j = std::max<Index>(peak.first, 2); j < std::min(peak.last, gap.gap.cols() - 3); ++j)
  {
    const double step = stepAfter(gap.gap, peak.row, j);
    highest = step > 0 ? std::max(highest, std::max(p[j], p[j + 1]) + spike * step) : highest;
  }
  return std::max(highest / p[peak.column] - 1, 0.0);
}

/// Relative amount by which the pressure would exceed the highest one if the cells resolved the features of the gap
/// that are narrower than the present cells [-] (doc/theory.md, "Waves of a profile narrower than the cells"). If fewer
/// than half of the columns show one, the slope is no more than the largest one.
double errorFromUnseenSlopes(const PatchGap& gap, const PatchPressure& pressure, double modulus, const Peak& peak)
{
  constexpr double over_mean = 5, over_largest = 1.8;
  if (gap.unseen_slope.size() == 0)
  {
    return 0;
  }
  const auto p = pressure.pressure.row(peak.row);
  double highest = 0;
  for (Index j = peak.first; j <= peak.last; ++j)
  {
    const double slope = gap.unseen_slope[j];
    const double beside = std::max(p[std::max(j - 1, peak.first)], p[std::min(j + 1, peak.last)]);
    highest = slope > 0 ? std::max(highest, std::max(p[j], beside) + 0.5 * modulus * slope) : highest;
  }
  const auto slopes = gap.unseen_slope.segment(peak.first, peak.last - peak.first + 1);
  const bool covered = 2 * (slopes > 0).count() > slopes.size();
  const double typical = over_mean * slopes.mean();
  const double anywhere = 0.5 * modulus * std::min((covered ? over_largest : 1) * slopes.maxCoeff(), typical);
  return std::max(anywhere, highest - pressure.max_pressure) / pressure.max_pressure;
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

/// Errors of a patch as if it carried its load alone.
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
  const ErrorEstimate plane = weighted(gridErrorWeights(), terms);
  const double factor = problem.patches[patch].weight < steep_weight ? steep_factor : 1;
  return {factor * plane.max_pressure, factor * plane.area, factor * plane.approach};
}
}  // namespace

double ErrorEstimate::largest() const
{
  return std::max({max_pressure, area, approach});
}

ErrorTerms errorTerms(const PatchGap& gap, const PatchPressure& pressure, double modulus, double residual)
{
  const Grid& grid = gap.grid;
  const Eigen::ArrayXXd& p = pressure.pressure;
  const Loaded loaded = findLoaded(grid, p);
  const Bending bending = gapBending(gap.gap, loaded.peak);

  const CellsAround peak{grid, p, loaded.peak.row, loaded.peak.column};
  const double per_cell = grid.dx * grid.dy / pressure.area;
  const double variation = bending.variation / (loaded.across * loaded.across);
  ErrorTerms terms;
  terms.least_pressure_error =
      std::max({hiddenError(gap, modulus, peak), errorFromLowerPeaks(gap, pressure, modulus, loaded.peak.column),
                errorFromSteps(gap, pressure, modulus, loaded.peak),
                errorFromUnseenSlopes(gap, pressure, modulus, loaded.peak)});
  terms.max_pressure = peakTerms(gap, modulus, peak, bending.jumps_at_peak, residual);
  terms.narrow_end =
      std::max(narrow_end_cells * std::max(loaded.narrow_columns - narrow_tips, 0), few_cells_error * per_cell) *
      per_cell;
  const double aspect = 1 + long_cells * std::abs(std::log(grid.dx / grid.dy));
  const double beyond_oval = std::max(loaded.thin_columns * loaded.along / loaded.across - oval, 0.0);
  const double moved = std::max(pressure.moved_at_discontinuities / pressure.area - usual_move * per_cell, 0.0);
  terms.area = {aspect * per_cell, beyond_oval * per_cell, moved, variation, residual};
  terms.approach = {1 / (loaded.along * loaded.along), residual};
  const double unseen = (loaded.along >= grid.nx ? unseen_edge : 1) * (loaded.across >= grid.ny ? unseen_edge : 1);
  std::transform(terms.area.begin(), terms.area.end(), terms.area.begin(),
                 [unseen](double term) { return unseen * term; });
  return terms;
}

const ErrorWeights& gridErrorWeights()
{
  // doc/theory.md, "Calibration", states how each was set.
  static constexpr ErrorWeights weights{{0.0035, 0.025, 0.0055, 0.1, 1.7}, {0.095, 0.2, 0.5, 0.1, 1.5}, {0.19, 0.3}};
  return weights;
}

double ownApproach(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch)
{
  const PatchGap& gap = problem.patches[patch];
  return gap.weight * solution.approach - gap.gap.minCoeff();
}

void estimateGridErrors(const NormalProblem& problem, const NormalSolution& solution,
                        std::vector<ErrorEstimate>& errors)
{
  const double largest = largestApproach(problem, solution);
  withSharedApproach(
      problem, solution, [&](std::size_t k) { return errorsAlone(problem, solution, k, largest); }, errors);
}
}  // namespace wheel_rail_contact::core
