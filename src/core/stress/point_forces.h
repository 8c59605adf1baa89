// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace wheel_rail_contact::core
{
/// Number of points at which the stress is computed together.
constexpr int point_batch = 16;
/// A value for each of these points.
using PointValues = std::array<float, point_batch>;

/// Points below a surface that carries point forces.
struct PointsBelow
{
  PointValues x{}, y{};  ///< place on the surface
  PointValues depth{};   ///< > 0
};

/// Sums over point forces f at distances (x, y) from points at depth z, r² = x² + y² + z² (Boussinesq; Johnson 1985,
/// eq. 3.20).
struct PointForceSums
{
  PointValues one{}, x{}, y{}, xx{}, xy{}, yy{};  ///< of f / r⁵ times 1, x, y, x², x y, y²
  PointValues chi_xx{}, chi_yy{}, chi_xy{};       ///< of f times second derivatives of ln(r + z)
};

/// Point forces on a surface.
struct PointForces
{
  const float *x = nullptr, *y = nullptr;  ///< places
  const float* force = nullptr;
  std::size_t count = 0;
};

/// Sums over all forces, compiled for one instruction set. Relative error below 1e-5 of the largest terms. Lengths must
/// not be far from 1: fifth powers occur.
struct PointForceKernels
{
  const char* name = nullptr;
  void (*sums)(const PointForces& forces, const PointsBelow& points, PointForceSums& sums) = nullptr;
};

/// Kernels that this processor supports, widest registers first.
std::vector<const PointForceKernels*> supportedPointForceKernels();

/// The first of supportedPointForceKernels().
const PointForceKernels& pointForceKernels();
}  // namespace wheel_rail_contact::core
