// SPDX-License-Identifier: BSD-3-Clause
#include "paper/stress_maxima.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "paper/scan.h"

namespace wheel_rail_contact::core::paper
{
namespace
{
// Depths of the search, in units of the shorter semi-axis [-]. The maxima of the paper's cases are at 0.26 to 0.4.
// Below the close depths, the stress falls steadily.
constexpr Range close_depths{0.05, 0.8, 30};
constexpr Range far_depths{0.9, 2.5, 16};

using Measure = double (*)(const Stress&);

double alternating(const Stress& stress)
{
  return std::abs(stress.xz);
}

/// Searches below the centres of all cells.
StressPeak highestIn(const StressLayer& layer, const PatchGrid& grid, Measure measure)
{
  StressPeak peak;
  for (int column = 0; column < grid.ny; ++column)
  {
    for (int row = 0; row < grid.nx; ++row)
    {
      const double value = measure(layer.at(row, column));
      if (value > peak.value)
      {
        peak = {value, grid.x(row), grid.y(column), layer.depth};
      }
    }
  }
  return peak;
}

/// Top of the parabola through three equidistant values.
struct Top
{
  double offset = 0;  ///< of its place from the middle, in steps [-]
  double gain = 0;    ///< of its value over the middle one
};

Top topOf(double before, double middle, double after)
{
  const double slope = 0.5 * (after - before), bend = before + after - 2 * middle;
  return bend < 0 ? Top{-slope / bend, -0.5 * slope * slope / bend} : Top{};
}

/// Moves the place between the cells, by the neighbours of the highest cell. The pressure of a usable patch does not
/// reach the border of its grid, so the highest stress has all neighbours.
void moveInLayer(const StressLayer& layer, const PatchGrid& grid, Measure measure, StressPeak& peak)
{
  const auto row = static_cast<Eigen::Index>(std::lround((peak.x - grid.x0) / grid.dx));
  const auto column = static_cast<Eigen::Index>(std::lround((peak.y - grid.y0) / grid.dy));
  if (row > 0 && column > 0 && row + 1 < grid.nx && column + 1 < grid.ny)
  {
    const auto at = [&](Eigen::Index i, Eigen::Index j) { return measure(layer.at(i, j)); };
    const double middle = at(row, column);
    const Top along = topOf(at(row - 1, column), middle, at(row + 1, column));
    const Top across = topOf(at(row, column - 1), middle, at(row, column + 1));
    peak.x += along.offset * grid.dx;
    peak.y += across.offset * grid.dy;
    peak.value += along.gain + across.gain;
  }
}

/// Highest value in each layer, on parabolas along and across the track.
std::vector<StressPeak> peaksOf(const std::vector<StressLayer>& layers, const PatchGrid& grid, Measure measure)
{
  std::vector<StressPeak> peaks;
  for (const StressLayer& layer : layers)
  {
    peaks.push_back(highestIn(layer, grid, measure));
    moveInLayer(layer, grid, measure, peaks.back());
  }
  return peaks;
}

/// The highest one, on a parabola through three of the close depths.
StressPeak highestOf(const std::vector<StressPeak>& peaks)
{
  const auto highest = std::max_element(peaks.begin(), peaks.end(),
                                        [](const StressPeak& a, const StressPeak& b) { return a.value < b.value; });
  if (highest == peaks.begin() || highest - peaks.begin() >= close_depths.steps)
  {
    throw std::runtime_error("the highest stress is not within the close depths: found at " +
                             std::to_string(highest->depth) + " m");
  }
  const Top top = topOf((highest - 1)->value, highest->value, (highest + 1)->value);
  StressPeak peak = *highest;
  peak.value += top.gain;
  peak.depth += top.offset * ((highest + 1)->depth - highest->depth);
  return peak;
}

/// Largest depth at which the highest value is above a limit, linear between the layers [m]; 0 if it is nowhere.
double depthAbove(const std::vector<StressPeak>& peaks, double limit)
{
  if (peaks.back().value > limit)
  {
    throw std::runtime_error("the von Mises stress is above the yield stress at the largest searched depth");
  }
  for (std::size_t k = peaks.size() - 1; k > 0; --k)
  {
    const StressPeak &above = peaks[k - 1], &below = peaks[k];
    if (above.value > limit)
    {
      return below.depth - (limit - below.value) / (above.value - below.value) * (below.depth - above.depth);
    }
  }
  return 0;
}
}  // namespace

StressMaxima stressMaxima(const PatchResult& patch, double poisson, double yield)
{
  const double unit = std::min(patch.semi_axis_along, patch.semi_axis_across);
  std::vector<double> depths = close_depths.values();
  const std::vector<double> far = far_depths.values();
  depths.insert(depths.end(), far.begin(), far.end());
  std::for_each(depths.begin(), depths.end(), [unit](double& depth) { depth *= unit; });
  const std::vector<StressLayer> layers = stressLayers(patch.grid, patch.pressure, poisson, depths);
  const std::vector<StressPeak> von_mises = peaksOf(layers, patch.grid, vonMises);
  const StressPeak peak = highestOf(von_mises);
  const Stress stress = stressAt(patch.grid, patch.pressure, poisson, {peak.x, peak.y, peak.depth});
  return {peak, highestOf(peaksOf(layers, patch.grid, maxShear)),
          highestOf(peaksOf(layers, patch.grid, alternating)).value, depthAbove(von_mises, yield),
          principalStresses(stress)};
}
}  // namespace wheel_rail_contact::core::paper
