// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace wheel_rail_contact::core
{
/// Isotropic elastic material.
struct Material
{
  double young = 2.1e11;  ///< Young's modulus [Pa], > 0
  double poisson = 0.28;  ///< Poisson's ratio [-], in (-1, 0.5]
};

/// Checks a material against its rules; `option` is its name in the message.
/// @throw std::invalid_argument with the option, its value and the broken rule.
void validate(const Material& material, const std::string& option);

/// Contact modulus E* of two half-spaces [Pa]: 1/E* = (1-nu1²)/E1 + (1-nu2²)/E2 (Johnson 1985, eq. 4.20).
/// @throw std::invalid_argument for a material out of range.
double contactModulus(const Material& first, const Material& second);

/// Rectangular grid of nx × ny cells in the tangent plane; x along the track, y across.
///
/// With `symmetric` the pressure is even in x and only the half x > 0 is stored: rows() = nx/2 (nx is even then) and
/// row i lies at x = (i + 1/2) dx. Without it rows() = nx and row i lies at x = (i + 1/2 - nx/2) dx. Column j lies at
/// y0 + j dy.
struct Grid
{
  int nx = 0;              ///< cells along, of the whole grid
  int ny = 0;              ///< cells across
  double dx = 0;           ///< cell length along [m]
  double dy = 0;           ///< cell width across [m]
  double y0 = 0;           ///< y of the first column's centres [m]
  bool symmetric = false;  ///< even in x, half stored

  /// Stored cells along.
  int rows() const { return symmetric ? nx / 2 : nx; }
  /// Centre of a stored row [m].
  double x(int row) const { return (row + (symmetric ? 0.5 : 0.5 - 0.5 * nx)) * dx; }
  /// Centre of a column [m].
  double y(int column) const { return y0 + column * dy; }
  /// Area that one stored cell stands for [m²] (twice the cell on a symmetric grid).
  double cellArea() const { return (symmetric ? 2 : 1) * dx * dy; }
};

/// Gap of one patch. Arrays are rows() × ny, so that x runs fastest in memory.
struct PatchGap
{
  Grid grid;  ///< cells in the patch's plane
  /// Distance of the undeformed surfaces along the patch's normal at zero approach [m]; negative: they overlap.
  Eigen::ArrayXXd gap;
  /// By how much the gap's own slope across differs, in each column, from that which the columns beside it show, beyond
  /// what a kink or a jump of the curvature between columns makes [-]: features narrower than the cells. Only error
  /// estimates use it; empty where nothing is known but the cells. fillUnseenSlope() (unseen_slope.h) fills it.
  Eigen::ArrayXd unseen_slope;
  /// Share of the common approach that closes this patch, and of its normal force that counts in the common load [-]:
  /// the cosine between the patch's normal and the direction of the load; 1 for a single patch pressed straight.
  double weight = 1;
  /// By how much a unit of each of the support's coordinates opens the gap, the same all along a column: ny × 3; used
  /// only if the support yields [m/m] or [m/rad]. A rigid body's are linear across: max_pressure, which looks at how
  /// the gap bends, counts on that.
  Eigen::ArrayX3d opening;
};

/// What carries the patches may yield to their pressure, as a rigid body in three coordinates d (lengths [m] or angles
/// [rad]): d = compliance * f, with f_m the integral of opening_m * p over all patches, and gap + opening * (d -
/// placed) in place of the gap. With a symmetric compliance this is a displacement that belongs to the pressure, as the
/// half-spaces' does.
struct Support
{
  bool compliant = false;                                ///< false: it is rigid, the rest means nothing
  Eigen::Matrix3d compliance = Eigen::Matrix3d::Zero();  ///< symmetric, positive semidefinite
  Eigen::Vector3d placed = Eigen::Vector3d::Zero();      ///< coordinates for which the gaps are given
};

/// Frictionless contact of half-spaces: find p >= 0 with w = A p + gap - weight * approach >= 0 and p w = 0 in every
/// patch, the approach being common to all of them, and either sum(weight * N_k) = load or the approach given. Patches
/// do not deform one another (patches near one another belong in one grid); they share the support.
struct NormalProblem
{
  /// What is given.
  enum class Control
  {
    load,     ///< `value` is the load [N], > 0
    approach  ///< `value` is the common approach [m]
  };

  std::vector<PatchGap> patches;    ///< at one approach
  Support support;                  ///< only for methods that solvesSupport()
  double modulus = 0;               ///< contact modulus E* [Pa]
  Control control = Control::load;  ///< what `value` is
  double value = 0;                 ///< load [N] or approach [m]
};

/// Why a solution ended, and whether it may be used.
enum class SolveStatus
{
  converged,              ///< usable
  no_contact,             ///< approach control: nothing touches; pressure zero, usable
  iteration_limit,        ///< not usable
  stalled,                ///< the residual stopped falling above the tolerance; not usable
  indefinite,             ///< the influence matrix has a negative direction; not usable
  no_positive_curvature,  ///< the gap is no bowl where the method needs one; not usable
  invalid_problem         ///< NaN in the gap, no load, no cells, no positive weight; not usable
};

/// Text of a status for people.
const char* toString(SolveStatus status);

/// True if the solution's pressure may be used.
inline bool isUsable(SolveStatus status)
{
  return status == SolveStatus::converged || status == SolveStatus::no_contact;
}

/// Solution of one patch.
///
/// A solver that starts from an earlier solution makes use of `displacement` only if it still belongs to `pressure`;
/// whoever changes one may leave the other as it is.
struct PatchPressure
{
  Grid grid;                            ///< where the pressure was found
  Eigen::ArrayXXd pressure;             ///< [Pa], shape of the gap
  Eigen::ArrayXXd displacement;         ///< of both half-spaces, apart along the normal [m], shape of the gap
  double force = 0;                     ///< normal force of the whole patch [N]
  double max_pressure = 0;              ///< highest, between the cells less their excess; may be below theirs [Pa]
  double area = 0;                      ///< contact area with sub-cell edge [m²]
  double moved_at_discontinuities = 0;  ///< what jumps of the gap's curvature move the edge by, sizes summed [m²]
  bool touches_border = false;          ///< pressure in an outer cell of the grid: the box cut the patch
};

/// Answer of a NormalSolver.
struct NormalSolution
{
  SolveStatus status = SolveStatus::invalid_problem;  ///< whether the rest may be used
  std::vector<PatchPressure> patches;                 ///< in the problem's order
  double approach = 0;                                ///< common approach [m]
  /// The support's coordinates under the pressure, where it yields.
  Eigen::Vector3d support = Eigen::Vector3d::Zero();
  int iterations = 0;  ///< products with the influence matrix
  /// Largest violation of the contact conditions relative to the approach's scale [-]; see ConjugateGradients.
  double residual = 0;
};

/// Estimated relative errors of one patch of a solution [-], all >= 0.
struct ErrorEstimate
{
  double max_pressure = 0;  ///< of the highest pressure
  double area = 0;          ///< of the contact area
  double approach = 0;      ///< of the patch's own approach, from its first touch on
  /// The part of `area` that columns make on which the pressure is narrower than the cells tell, as in a tail: it falls
  /// with the cells along, hardly with those across.
  double narrow_ends = 0;
  /// The residual over the patch's own approach, of which ofResidual() tells the parts in the first three: they do not
  /// fall with the cells.
  double residual = 0;

  /// The largest of the first three [-].
  double largest() const;
};
}  // namespace wheel_rail_contact::core
