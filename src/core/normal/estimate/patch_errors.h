// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "core/normal/estimate/error_estimate.h"

namespace wheel_rail_contact::core
{
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
}  // namespace wheel_rail_contact::core
