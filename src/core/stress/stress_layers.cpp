// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/corner_stress.h"
#include "core/stress/layer_products.h"
#include "core/stress/stress_check.h"
#include "wheel_rail_contact/core/stress.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Components of a stress in the order of StressLayer, and their parities along x and y.
constexpr std::array<double Stress::*, 6> components{&Stress::xx, &Stress::yy, &Stress::zz,
                                                     &Stress::yz, &Stress::xz, &Stress::xy};
constexpr std::array<LayerProducts::Parity, 6> parities{{{0, 0}, {0, 0}, {0, 0}, {0, 1}, {1, 0}, {1, 1}}};

using Kernels = std::array<Eigen::ArrayXXd, 6>;

/// Stress by a unit pressure on a cell, at the distances 0 … nx - 1 and 0 … ny - 1 from its centre [-].
Kernels kernelsAt(const PatchGrid& grid, double poisson, double depth)
{
  Kernels corners, kernels;
  corners.fill(Eigen::ArrayXXd(grid.nx + 1, grid.ny + 1));
  for (int j = 0; j <= grid.ny; ++j)
  {
    for (int i = 0; i <= grid.nx; ++i)
    {
      const Stress stress = cornerStress((i - 0.5) * grid.dx, (j - 0.5) * grid.dy, depth, poisson);
      for (std::size_t c = 0; c < components.size(); ++c)
      {
        corners[c](i, j) = stress.*components[c];
      }
    }
  }
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const Eigen::ArrayXXd along = corners[c].bottomRows(grid.nx) - corners[c].topRows(grid.nx);
    kernels[c] = along.rightCols(grid.ny) - along.leftCols(grid.ny);
  }
  return kernels;
}
}  // namespace

std::vector<StressLayer> stressLayers(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson,
                                      const std::vector<double>& depths)
{
  requireStressInput(grid, pressure, poisson);
  const LayerProducts products(pressure);
  std::vector<StressLayer> layers;
  layers.reserve(depths.size());
  for (const double depth : depths)
  {
    requireDepth(depth);
    const Kernels kernels = kernelsAt(grid, poisson, depth);
    StressLayer& layer = layers.emplace_back();
    layer.depth = depth;
    for (std::size_t c = 0; c < components.size(); ++c)
    {
      layer.components[c] = products.product(kernels[c], parities[c]);
    }
  }
  return layers;
}
}  // namespace wheel_rail_contact::core
