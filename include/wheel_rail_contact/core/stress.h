// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Stress at a point of a body [Pa], tension positive. Axes: x and y of the grid of the pressure, z into the body. In
/// the patch frame, whose z points out of the rail, xz and yz of the rail therefore change their sign.
struct Stress
{
  double xx = 0;  ///< normal stress along the track [Pa]
  double yy = 0;  ///< normal stress across the track [Pa]
  double zz = 0;  ///< normal stress along the depth [Pa]
  double yz = 0;  ///< shear stress [Pa]
  double xz = 0;  ///< shear stress in planes along the track [Pa]
  double xy = 0;  ///< shear stress [Pa]
};

/// Strain at a point of a body [-], lengthening positive; axes as for Stress. yz, xz and xy are those of the tensor:
/// half the change of the angle.
struct Strain
{
  double xx = 0;  ///< along the track [-]
  double yy = 0;  ///< across the track [-]
  double zz = 0;  ///< along the depth [-]
  double yz = 0;  ///< shear [-]
  double xz = 0;  ///< shear [-]
  double xy = 0;  ///< shear [-]
};

/// Von Mises stress [Pa].
double vonMises(const Stress& stress);

/// Principal stresses [Pa], the largest first.
std::array<double, 3> principalStresses(const Stress& stress);

/// Highest shear stress [Pa]: half the difference of the largest and the smallest principal stress. The Tresca stress
/// is twice this value.
double maxShear(const Stress& stress);

/// Strain by Hooke's law.
/// @throw std::invalid_argument if the material is out of range.
Strain strainOf(const Stress& stress, const Material& material);

/// Stress in an elastic half-space by the frictionless pressure on the cells of a grid, at a point.
///
/// Each cell carries a constant pressure; the sum of the closed forms of all cells is exact (Love 1929; Johnson 1985,
/// sec. 3.4). The stress does not depend on Young's modulus.
/// @param pressure  nx × ny [Pa], compressive positive
/// @param poisson   Poisson's ratio of the body, in (-1, 0.5]
/// @param point     x and y on the grid, and depth below the surface, >= 0 [m]. The stress at depth 0 jumps between the
///                  cells.
/// @throw std::invalid_argument if the shape of the pressure is not that of the grid, a value is not finite, Poisson's
///        ratio is out of range, the depth is negative, or the point is a corner of a cell at depth 0, where xy is
///        infinite.
Stress stressAt(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson, const Eigen::Vector3d& point);

/// Stress at one depth below the centres of the cells of a grid.
struct StressLayer
{
  double depth = 0;  ///< below the surface [m]
  /// Components xx, yy, zz, yz, xz, xy, as in Stress [Pa]; nx × ny each.
  std::array<Eigen::ArrayXXd, 6> components;

  /// Stress below cell (row, column) [Pa].
  Stress at(Eigen::Index row, Eigen::Index column) const;
};

/// Stress at several depths below the centres of all cells: the same stress as stressAt(), by fast products with
/// influence coefficients.
/// @param depths  [m], each >= 0
/// @return one layer for each depth
/// @throw std::invalid_argument as stressAt().
std::vector<StressLayer> stressLayers(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson,
                                      const std::vector<double>& depths);

/// A highest stress and its place.
struct StressPeak
{
  double value = 0;  ///< [Pa]
  double x = 0;      ///< place along the track, from the origin of the patch frame [m]
  double y = 0;      ///< place along the arc of the section of the rail, left positive, from the same origin [m]
  double depth = 0;  ///< below the surface of the body, along its normal [m]
};

/// Stress beneath a patch in one of the bodies, by the half-space model and the pressure on the grid of the patch,
/// which may contain other patches. The search finds the maxima within about 2 % (doc/theory.md).
struct PatchStress
{
  StressPeak von_mises;  ///< highest von Mises stress
  StressPeak shear;      ///< highest shear stress, see maxShear()
  /// p0 / k [-]: highest pressure over the yield stress in shear, k = yield / sqrt 3. 0 if Material::yield is not
  /// given.
  double load_factor = 0;
  /// Load factor above which the body cannot shake down to an elastic state under repeated frictionless rolling along
  /// the track [-]: p0 over half a change of the stress during a passage, as a shear stress. Two changes are taken:
  /// that of xz, from its highest value to the opposite one, and that from no stress to the highest von Mises stress.
  /// It is 4.00 for a line contact across the track and 4.68 for a circular one. There it is the shakedown limit itself
  /// (Johnson 1985, sec. 9.2; Ponter, Hearle and Johnson 1985), elsewhere an upper bound of it; under yaw within 1 %.
  double shakedown_limit = 0;
  std::vector<StressLayer> field;  ///< only with StressConfig::field: on PatchResult::grid
};

/// Stress in the bodies beneath each patch: PatchResult::wheel_stress and rail_stress.
struct StressConfig
{
  /// 0: no stress is computed. Otherwise the number of layers of the field, 4 to 64, equally spaced from the surface to
  /// twice the shorter semi-axis of the patch. The search for the highest stresses does not depend on it.
  int depths = 0;
  bool field = false;  ///< also fills PatchStress::field
};

/// Checks that every parameter is within its range.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const StressConfig& stress);
}  // namespace wheel_rail_contact::core
