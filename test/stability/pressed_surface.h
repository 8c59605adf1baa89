// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../standard_headers.h"
#include "core/normal/operator/influence_operator.h"
#include "core/normal/operator/operator_cache.h"
#include "core/track/gap.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core::stability
{
/// A part of a surface: columns of one patch.
struct SurfacePart
{
  const PatchResult* patch;
  int first, columns;
};

/// The surface of a rail under the patches of a wheel that were cut from one grid. Side axes.
struct PressedSurface
{
  Grid grid;  ///< whole, never symmetric
  SurfaceOrigin origin;
  Eigen::ArrayXXd pressure;            ///< [Pa]
  Eigen::ArrayXXd gap;                 ///< of the rigid bodies [m]
  std::vector<SurfaceColumn> columns;  ///< one for each column of the grid
  std::vector<SurfacePart> parts;      ///< from the gauge side to the field side
};

/// Surfaces under the patches of a wheel, with the gaps of the rigid bodies. They are found from the patch frames, the
/// grids and the bodies alone.
/// @throw std::runtime_error if a body has no point anywhere on a grid
std::vector<PressedSurface> surfacesUnder(const std::vector<PatchResult>& patches, Side side, const PlacedWheel& wheel,
                                          const PlacedRail& rail);

/// Distance of the origin of a patch frame from the rail [m].
double distanceFromRail(const PatchResult& patch, const PlacedRail& rail);

/// Computes displacements of half-spaces with exact influence coefficients, projected onto the normal of each column.
class SurfaceDisplacement
{
 public:
  /// @param modulus  contact modulus [Pa]
  explicit SurfaceDisplacement(double modulus) : modulus_(modulus) {}

  /// Displacement of a surface by its own pressure and, as point forces in the cells, by that of the other ones [m].
  Eigen::ArrayXXd at(const PressedSurface& surface, const std::vector<PressedSurface>& all);

 private:
  Eigen::ArrayXXd product(const PressedSurface& surface, const Eigen::ArrayXd& share);
  void addOther(const PressedSurface& surface, const PressedSurface& other, Eigen::ArrayXXd& displacement) const;

  double modulus_;
  OperatorCache operators_;
  InfluenceOperator::Workspace workspace_;
};
}  // namespace wheel_rail_contact::core::stability
