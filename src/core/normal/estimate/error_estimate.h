// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Terms of the discretisation error, computed from a solution on its grid. An estimate is a weighted sum of these
/// terms.
///
/// q is the squared pressure over its maximum, along the lines of cells through the highest cell (a parabola in a Hertz
/// contact). k are the second differences of the gap across the track. Lengths are counted in cells.
struct ErrorTerms
{
  /// Terms of the max_pressure error:
  /// * bend: negative second difference of q at the peak, along plus across;
  /// * bend² / (1 + bend);
  /// * fourth power of S, at most 4^4. S is the sum of the jumps of k in the row of the peak, each divided by (distance
  ///   from the peak + 1/2)², as a pressure over the peak pressure;
  /// * the bend again, if a neighbour of the peak across the track is not loaded or the curvature of the gap jumps up
  ///   and down near it;
  /// * residual.
  std::array<double, 5> max_pressure{};
  /// Lower limit of the max_pressure error, without a weight: the largest of four relative amounts by which the
  /// pressure may exceed max_pressure:
  /// * a secondary peak grows by its weighted terms without the residual (in a lobe of two columns: at least to twice
  ///   its value);
  /// * the pressure at a step of the gap, on cells four times finer;
  /// * the pressure at waves of the gap that are narrower than the cells;
  /// * half of what the measure adds to the parabolas of the highest cell, beyond a smooth peak, and the error by third
  ///   differences if this cell is one column from the end of the pressure.
  double least_pressure_error = 0;
  /// Terms of the area error, with the number n of cells of the contact area:
  /// * (1 + 0.5 |ln(dx / dy)|) / n;
  /// * (S - 1.6) / n, at least zero. S is the sum of 1 / (loaded cells) over the columns, times (cells along) / (cells
  ///   across): about 1.6 for an oval;
  /// * displacement of the edge by jumps of k, minus a fifth of a cell (at least zero), over the area;
  /// * largest minus smallest k in the row of the peak, over their mean and (cells across)²;
  /// * residual.
  /// All are a third larger if the pressure fills its grid along the track, because its end is not visible, and again a
  /// third larger if it fills the grid across. Without the latter, 5 % of the results of `auto` at a tolerance of 10 %
  /// had an error above their estimate; with it 1 %.
  std::array<double, 5> area{};
  /// Lower limit of the area error, without a weight. The larger of two parts: 1.7 / n for each
  /// column of at most two loaded cells, beyond the four of an oval (narrow ends); 6 / n² (few cells).
  double narrow_end = 0;
  /// Terms of the approach error: 1 / (cells along)²; residual.
  std::array<double, 2> approach{};
};

/// Terms of a patch that carries pressure. `modulus`: E* [Pa]. `residual` is relative to the own approach of the patch.
ErrorTerms errorTerms(const PatchGap& gap, const PatchPressure& pressure, double modulus, double residual);

/// Weights of the terms [-].
struct ErrorWeights
{
  std::array<double, 5> max_pressure{};  ///< of ErrorTerms::max_pressure
  std::array<double, 5> area{};          ///< of ErrorTerms::area
  std::array<double, 2> approach{};      ///< of ErrorTerms::approach
};

/// Weights in use.
const ErrorWeights& gridErrorWeights();

/// Terms for methods that represent a gap by a paraboloid. The estimate of each quantity is a weighted sum of:
/// * one;
/// * |ln(ratio of the volumes)| below a level, of the gap and of the paraboloid;
/// * volume below a level that is not common to both, over the mean of both volumes;
/// * squared logarithm of the aspect of the paraboloid.
using ShapeTerms = std::array<double, 4>;

/// Weights of ShapeTerms for each quantity [-].
struct ShapeWeights
{
  ShapeTerms max_pressure{};  ///< of the highest pressure
  ShapeTerms area{};          ///< of the contact area
  ShapeTerms approach{};      ///< of the approach
};

/// Estimates the errors by discretisation and residual in each patch of a usable solution, for any method with a
/// pressure in each cell. Zero for a patch without pressure. `errors` gets one entry for each patch.
///
/// The largest of the three estimates is at least the true error in 98 % of single patches (doc/theory.md,
/// "Calibration"). With several patches, the approach error of one shifts load to the others. This is added with
/// Hertz's laws (maximum ~ approach^1/2, area ~ approach).
void estimateGridErrors(const NormalProblem& problem, const NormalSolution& solution,
                        std::vector<ErrorEstimate>& errors);

/// Own approach of a patch, from the first touch of its cells [m].
double ownApproach(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch);

template <std::size_t N>
double weighted(const std::array<double, N>& weights, const std::array<double, N>& terms)
{
  return std::inner_product(weights.begin(), weights.end(), terms.begin(), 0.0);
}

inline ErrorEstimate weighted(const ShapeWeights& weights, const ShapeTerms& terms)
{
  return {weighted(weights.max_pressure, terms), weighted(weights.area, terms), weighted(weights.approach, terms)};
}

inline ErrorEstimate weighted(const ErrorWeights& weights, const ErrorTerms& terms)
{
  return {std::max(weighted(weights.max_pressure, terms.max_pressure), terms.least_pressure_error),
          std::max(weighted(weights.area, terms.area), terms.narrow_end), weighted(weights.approach, terms.approach)};
}

/// Errors of all patches from `alone(k)`, the errors of each patch as if it carried its load alone. The error of the
/// common approach is the largest error of an own approach [m]. With Hertz's laws (maximum ~ approach^1/2, area ~
/// approach) it is added to the errors of all patches.
template <typename Alone>
void withSharedApproach(const NormalProblem& problem, const NormalSolution& solution, Alone alone,
                        std::vector<ErrorEstimate>& errors)
{
  const std::size_t count = problem.patches.size();
  errors.resize(count);
  double shift = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    errors[k] = alone(k);
    shift = std::max(shift, count > 1 ? errors[k].approach * ownApproach(problem, solution, k) : 0);
  }
  for (std::size_t k = 0; count > 1 && k < count; ++k)
  {
    ErrorEstimate& error = errors[k];
    const double own = ownApproach(problem, solution, k);
    if (error.largest() > 0 && own > 0)
    {
      const double relative = shift / own;
      error = {error.max_pressure + 0.5 * relative, error.area + relative, relative};
    }
  }
}

/// Fills PatchGap::unseen_slope from the slopes of the gap. Error estimates use it to detect features that are narrower
/// than the cells.
///
/// With the third differences t of the gap on both sides of column j, a kink or a jump of the curvature makes the
/// slopes differ by no more than (|t_before| + |t_after|) / (4 dy). Only the part of the difference above this limit is
/// stored.
/// @param patch     grid and gap must be filled
/// @param slope_at  returns the slope d(gap)/dy at x = 0 of a column j [-]
template <typename SlopeAt>
void fillUnseenSlope(PatchGap& patch, SlopeAt slope_at)
{
  const Grid& grid = patch.grid;
  const int behind = grid.symmetric ? 0 : (grid.nx - 1) / 2, ahead = grid.symmetric ? 0 : grid.nx / 2;
  const auto line = [&](Eigen::Index j) { return 0.5 * (patch.gap(behind, j) + patch.gap(ahead, j)); };
  const auto third = [&](Eigen::Index j) { return line(j + 2) - 3 * line(j + 1) + 3 * line(j) - line(j - 1); };
  patch.unseen_slope.setZero(grid.ny);
  for (Eigen::Index j = 2; j < grid.ny - 2; ++j)
  {
    const double shown = 0.5 * (line(j + 1) - line(j - 1));
    const double off = std::abs(slope_at(j) * grid.dy - shown);
    const double bends = 0.25 * (std::abs(third(j - 1)) + std::abs(third(j)));
    patch.unseen_slope[j] = std::max(off - bends, 0.0) / grid.dy;
  }
}
}  // namespace wheel_rail_contact::core
