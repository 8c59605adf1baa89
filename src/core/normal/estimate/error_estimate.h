// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// The larger of each quantity's errors.
ErrorEstimate largestOf(const ErrorEstimate& one, const ErrorEstimate& other);
/// The largest of each quantity's errors; zero of none.
ErrorEstimate largestOf(const std::vector<ErrorEstimate>& errors);

/// What a residual makes of each error [-]; `residual` is over the patch's own approach.
ErrorEstimate ofResidual(double residual);

/// What a solution on a grid shows of its own mesh error: the estimates are sums of these, each times its weight.
///
/// Along the lines of cells through the highest cell, let q be the squared pressure over its maximum (a parabola in a
/// Hertz contact), and k the second differences of the gap across. Lengths are counted in cells.
struct ErrorTerms
{
  /// Of max_pressure: bend of q at the crest, along plus across · its square · fourth power of the sum of the jumps of
  /// k, each over (distance from the crest + 1/2)², as a pressure over the crest's, up to 4 of it · the bend again
  /// where a cell beside the crest across is not loaded or the gap's curvature goes to and fro about it · residual.
  std::array<double, 5> max_pressure{};
  /// Of max_pressure, without a weight, the least that it may be off: by how much a lower crest of the pressure may
  /// turn out higher, by its own terms and their weights but the residual's, twofold if it stands in a lobe of
  /// two columns; or one at a step of the gap, on cells four times finer.
  double overtopping = 0;
  /// Of area: 1 + 0.5 |logarithm of the cells' aspect|, per cell of the area · by how much the sum of 1 / (cells
  /// loaded) over the columns, times (cells along) / (cells across), is above an oval's, per cell of the area · by how
  /// much jumps of k at the edge have moved it beyond a fifth of a cell, over the area · variation of k over its mean
  /// and (cells across)² · residual. All of them a third larger where the pressure fills its grid along, which then
  /// does not show where it ends, and again where it fills it across: without the latter 5 % of the answers of `auto`
  /// at a tolerance of 10 % were off by more than their estimate, with it 1 %.
  std::array<double, 5> area{};
  /// Of area, without a weight, the least that it may be off: by a tail of the pressure that is narrower than the cells
  /// tell, one and a half cells for each of its columns but the few of an oval; or for want of cells, 6 / cells².
  double narrow_end = 0;
  /// Of approach: 1 / (cells along)² · residual.
  std::array<double, 2> approach{};
};

/// Terms of a patch that carries pressure. `residual` is the solution's, over the patch's own approach.
ErrorTerms errorTerms(const PatchGap& gap, const PatchPressure& pressure, double modulus, double residual);

/// Weights of the terms.
struct ErrorWeights
{
  std::array<double, 5> max_pressure{};  ///< of ErrorTerms::max_pressure [-]
  std::array<double, 5> area{};          ///< of ErrorTerms::area [-]
  std::array<double, 2> approach{};      ///< of ErrorTerms::approach [-]
};

/// The weights in use.
const ErrorWeights& gridErrorWeights();

/// For methods that know a gap by a paraboloid only: the estimate of each quantity is a sum of these, each times its
/// weight. One · |logarithm of the ratio of volumes| below a level of the gap and of the paraboloid · the volume below
/// a level that is not common to both, over their mean · squared logarithm of the paraboloid's aspect.
using ShapeTerms = std::array<double, 4>;

/// Weights of ShapeTerms for each quantity [-].
struct ShapeWeights
{
  ShapeTerms max_pressure{};  ///< of the highest pressure
  ShapeTerms area{};          ///< of the contact area
  ShapeTerms approach{};      ///< of the approach
};

/// Errors that mesh and algebra leave in each patch of a usable solution by any method that puts pressure on the grid's
/// cells; zero for a patch without pressure. `errors` gets one for each patch.
///
/// Weights were fitted to random contacts, each against the same one on a grid four times finer each way, so that the
/// largest of the three is at least the true one in 98 % of single patches, and as close to it as that allows;
/// test/calibration does that again and prints the table. In several patches, one patch's error of approach shifts the
/// load to the others: with Hertz's laws (maximum ~ approach^1/2, area ~ approach) that is added in.
void estimateGridErrors(const NormalProblem& problem, const NormalSolution& solution,
                        std::vector<ErrorEstimate>& errors);
}  // namespace wheel_rail_contact::core
