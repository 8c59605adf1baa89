// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress_beneath.h"

#include "core/balance/patch_result.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double last_depth = 2;  ///< depth of the last layer of a field, in units of the shorter semi-axis [-]

/// Equally spaced depths from the surface [m].
std::vector<double> layerDepths(const SemiAxes& axes, int count)
{
  std::vector<double> depths(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < depths.size(); ++k)
  {
    depths[k] = static_cast<double>(k) * last_depth * std::min(axes.along, axes.across) / (count - 1);
  }
  return depths;
}

/// Mirrors the stress about the vertical plane along the track.
void mirror(PatchStress& stress)
{
  constexpr std::size_t yz = 3, xy = 5;
  stress.von_mises.y *= -1;
  stress.shear.y *= -1;
  for (StressLayer& layer : stress.field)
  {
    for (std::size_t c = 0; c < layer.components.size(); ++c)
    {
      layer.components[c] = layer.components[c].rowwise().reverse().eval();
      layer.components[c] *= c == yz || c == xy ? -1 : 1;
    }
  }
}
}  // namespace

void StressBeneath::fill(Side side, const WheelsetBalance& balance, std::size_t island, PatchResult& patch)
{
  patch.wheel_stress = patch.rail_stress = PatchStress();
  const SemiAxes axes{patch.semi_axis_along, patch.semi_axis_across};
  if (config_.stress.depths == 0 || !(std::min(axes.along, axes.across) > 0))
  {
    return;
  }
  // Both sides are computed in side axes, so that mirrored states have mirrored results.
  const Island& of = balance.islands(side).islands()[island];
  const PatchPressure& whole = balance.wheel(side).contact().solution().patches[of.patch];
  wholePressure(Side::left, whole.grid, whole.pressure, pressure_);
  grid_ = patch.grid;
  grid_.y0 = side == Side::left ? patch.grid.y0 : -patch.grid.y(patch.grid.ny - 1);
  grid_.y0 -= static_cast<double>(of.begin) * grid_.dy;
  grid_.ny = whole.grid.ny;
  const ColumnRange columns{of.begin, of.columns};
  search_.set(grid_, pressure_, columns, axes);
  fillBody(config_.rail_material[side].poisson, columns, axes, patch.max_pressure, patch.rail_stress);
  if (config_.wheel_material[side].poisson == config_.rail_material[side].poisson)
  {
    patch.wheel_stress = patch.rail_stress;
  }
  else
  {
    fillBody(config_.wheel_material[side].poisson, columns, axes, patch.max_pressure, patch.wheel_stress);
  }
  patch.rail_stress.load_factor = loadFactor(patch.max_pressure, config_.rail_material[side].yield);
  patch.wheel_stress.load_factor = loadFactor(patch.max_pressure, config_.wheel_material[side].yield);
  if (side == Side::right)
  {
    mirror(patch.wheel_stress);
    mirror(patch.rail_stress);
  }
}

void StressBeneath::fillBody(double poisson, const ColumnRange& columns, const SemiAxes& axes, double max_pressure,
                             PatchStress& stress)
{
  const HighestStresses highest = search_.find(poisson);
  stress.von_mises = highest.von_mises;
  stress.shear = highest.shear;
  stress.shakedown_limit = shakedownLimit(max_pressure, highest.orthogonal.value, highest.von_mises.value);
  if (!config_.stress.field)
  {
    return;
  }
  stress.field = stressLayers(grid_, pressure_, poisson, layerDepths(axes, config_.stress.depths));
  for (StressLayer& layer : stress.field)
  {
    for (Eigen::ArrayXXd& component : layer.components)
    {
      component = component.middleCols(columns.begin, columns.count).eval();
    }
  }
}
}  // namespace wheel_rail_contact::core
