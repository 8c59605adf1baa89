// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "wheel_rail_contact/core/stress.h"

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

/// Pressure on the cells of a grid, replaced by point forces: a fast approximation of stressAt().
///
/// The forces of a column are those of a semi-ellipse with its force, its centre and its variance along x, at the nodes
/// of the Gauss-Chebyshev quadrature of the second kind. Below few cells along the track it is closer to the stress of
/// a smooth pressure than stressAt(), above all |xz| at the ends of a column. The sum over a lattice of forces with the
/// distance d differs from that over a smooth pressure by up to 4 (1 + k z) exp(-k z), k = 2 pi / d, of the pressure at
/// the depth z (Poisson's summation formula): 5 % for z = d, 1 % for z = 1.3 d.
class PointSources
{
 public:
  /// Places in units of the length that set() was given.
  using Places = PointsBelow;

  /// Pressure of a column, or of several joined ones, as a semi-ellipse along x. Lengths are in a given unit.
  struct Line
  {
    double y = 0;       ///< place
    double force = 0;   ///< [Pa]; 0 without pressure
    double centre = 0;  ///< along x
    double half = 0;    ///< half length of the semi-ellipse, at least half a cell
  };
  /// Line of the columns `begin` to `end` - 1.
  static Line lineOf(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, Eigen::Index begin, Eigen::Index end,
                     double unit);

  /// Takes a pressure [Pa], nx × ny. Narrow columns are joined, wide ones divided, so that the distance of the forces
  /// is at most `spacing`. Allocates only for more forces than ever before.
  /// @param unit     unit of all lengths [m]
  /// @param spacing  in this unit [-]
  /// @param places   y of the points at which the stress is computed, in this unit. The distance of the forces grows
  /// with
  ///                 the distance of a column from them. Empty: the stress is computed anywhere
  void set(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double unit, double spacing,
           const std::vector<double>& places);

  /// Takes the pressure of the cells themselves, for stresses close to one place, in the unit. Near cells are divided.
  void setCells(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double unit, const Eigen::Vector3d& place);

  /// Stress [Pa] at the places.
  std::array<Stress, point_batch> at(const Places& places, double poisson) const;

 private:
  void addParts(const Line& line, double width, double spacing);
  void addLine(const Line& line, double spacing);

  std::vector<float> x_, y_, force_;
};
}  // namespace wheel_rail_contact::core
