// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace wheel_rail_contact::core
{
/// Isotropic elastic material. The default is steel.
struct Material
{
  double young = 2.1e11;  ///< Young's modulus [Pa], finite, > 0
  double poisson = 0.28;  ///< Poisson's ratio [-], in (-1, 0.5]
  double yield =
      0;  ///< yield stress in tension [Pa], finite, >= 0; 0: not known. Only PatchStress::load_factor uses it
};

/// True if all constants are equal.
inline bool operator==(const Material& a, const Material& b)
{
  return a.young == b.young && a.poisson == b.poisson && a.yield == b.yield;
}

/// Checks that all constants are within their range. `option` is the name of the material in the message.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const Material& material, const std::string& option);

/// Contact modulus E* of two half-spaces [Pa]: 1/E* = (1-nu1²)/E1 + (1-nu2²)/E2 (Johnson 1985, eq. 4.20).
/// @throw std::invalid_argument if a material is out of range.
double contactModulus(const Material& first, const Material& second);

/// Rectangular grid of nx × ny cells: x along the track, y across it; along the arc on a curved surface.
///
/// A symmetric grid stores only its half x > 0, because the pressure is even in x. Row i of the stored cells has its
/// centres at x(i), column j at y(j).
struct Grid
{
  int nx = 0;              ///< number of cells along the track, of the whole grid; even if symmetric
  int ny = 0;              ///< number of cells across the track
  double dx = 0;           ///< length of a cell along the track [m]
  double dy = 0;           ///< width of a cell across the track [m]
  double y0 = 0;           ///< y of the centres of the first column [m]
  bool symmetric = false;  ///< only the half x > 0 is stored

  /// Number of stored rows: nx, or nx/2 if symmetric.
  int rows() const { return symmetric ? nx / 2 : nx; }
  /// x of the centres of stored row `row` [m]: (row + 1/2 - nx/2) dx, or (row + 1/2) dx if symmetric.
  double x(int row) const { return (row + (symmetric ? 0.5 : 0.5 - 0.5 * nx)) * dx; }
  /// y of the centres of column `column` [m].
  double y(int column) const { return y0 + column * dy; }
  /// Area that is represented by one stored cell [m²]: dx dy, or twice as much if symmetric.
  double cellArea() const { return (symmetric ? 2 : 1) * dx * dy; }
};

/// Grid of the pressure of a patch: nx × ny equal rectangular cells. The centre of cell (i, j) is at (x(i), y(j)): x
/// along the track and y along the arc of the rail's section, from the origin of the patch frame. On a curved section
/// the cells leave the tangent plane.
struct PatchGrid
{
  int nx = 0;     ///< number of cells along the track
  int ny = 0;     ///< number of cells across the track
  double dx = 0;  ///< length of a cell along the track [m]
  double dy = 0;  ///< width of a cell across the track [m]
  double x0 = 0;  ///< x of the centres of the first row [m]
  double y0 = 0;  ///< y of the centres of the first column [m]

  /// x of the centres of row `row` [m].
  double x(int row) const { return x0 + row * dx; }
  /// y of the centres of column `column` [m].
  double y(int column) const { return y0 + column * dy; }
  /// Area of one cell [m²].
  double cellArea() const { return dx * dy; }
};

/// Gap of one patch. Arrays have rows() × ny elements; x runs fastest in memory (column-major).
struct PatchGap
{
  Grid grid;  ///< cells of the patch
  /// Distance of the undeformed surfaces along the normal of the column at zero approach, at the centres of the cells
  /// [m]; negative where they overlap.
  Eigen::ArrayXXd gap;
  /// For each column, the part of the gap's slope across the track that the cells do not resolve [-], >= 0. It is the
  /// difference between the true slope and the slope between the neighbouring columns, less the amount that a kink or a
  /// curvature discontinuity between columns explains. Only error estimates use it. Empty if only the cells are known.
  Eigen::ArrayXd unseen_slope;
  /// Opening of the gap per unit of the common displacement [-]: for bodies with a common normal, the cosine of its
  /// angle to the direction of the load. The patch is closed by weight times the common approach, and weight times its
  /// normal force counts in the common load. 1 for a single patch that is pressed along its normal.
  double weight = 1;
};

/// Frictionless contact of half-spaces, in one or several patches.
///
/// Find the pressure p >= 0 with w = A p + gap - weight * approach >= 0 and p w = 0 in every patch. A is the influence
/// matrix, w the remaining distance of the deformed surfaces. All patches have one common approach. Either the approach
/// is given, or the load: sum(weight * N_k) = load, with the normal force N_k of patch k. Patches do not deform one
/// another: contacts close to one another must be in one grid, as one patch.
struct NormalProblem
{
  /// The given quantity.
  enum class Control
  {
    load,     ///< `value` is the load [N], > 0
    approach  ///< `value` is the common approach [m]
  };

  std::vector<PatchGap> patches;    ///< gaps of all patches
  double modulus = 0;               ///< contact modulus E* [Pa], see contactModulus()
  Control control = Control::load;  ///< meaning of `value`
  double value = 0;                 ///< load [N] or approach [m]
};

/// Normals of the columns of a patch on a curved surface.
struct ColumnNormals
{
  /// Further factor of PatchGap::weight in each column [-], > 0; empty: 1 everywhere.
  Eigen::ArrayXd weight;
  /// Angle about x of the normal in each column, from that of the patch [rad]; empty: 0 everywhere. The displacement by
  /// a pressure in another column is projected onto the normal.
  Eigen::ArrayXd turn;

  /// True if the normals differ.
  bool areTurned() const { return (turn != 0).any(); }
};

/// A normal problem on curved surfaces: the columns of a patch have normals of their own, and the patches deform one
/// another. See NormalSolver::solveCurved().
struct CurvedProblem : NormalProblem
{
  std::vector<ColumnNormals> normals;  ///< of each patch; empty: the columns of a patch have its normal
  /// Displacement of a column by the normal force in another [m/N]: symmetric, with the columns of all patches one
  /// after another, and zero between columns of the same patch. Not used with one patch. Empty: patches do not deform
  /// one another.
  Eigen::MatrixXd coupling;

  /// True if the patches deform one another.
  bool isCoupled() const { return patches.size() > 1 && coupling.size() > 0; }
};

/// Reason for which a solution ended. It determines whether the solution is usable.
enum class SolveStatus
{
  converged,              ///< usable
  no_contact,             ///< with a given approach: no cell touches, the pressure is zero; usable
  iteration_limit,        ///< the largest number of iterations was reached; not usable
  stalled,                ///< the residual stopped decreasing above the tolerance; not usable
  indefinite,             ///< the influence matrix has a negative eigenvalue; not usable
  no_positive_curvature,  ///< the curvature of the gap is not positive where the method requires it; not usable
  invalid_problem  ///< a gap is not finite, the load or a weight is not positive, or a grid is too small; not usable
};

/// Text of a status for messages.
const char* toString(SolveStatus status);

/// True if the pressure of a solution with this status may be used.
inline bool isUsable(SolveStatus status)
{
  return status == SolveStatus::converged || status == SolveStatus::no_contact;
}

/// Solution of one patch.
///
/// `pressure` may be changed between two solutions without updating `displacement`: a solver that starts from an
/// earlier solution uses `displacement` only if it still belongs to `pressure`.
struct PatchPressure
{
  Grid grid;                 ///< grid of the pressure
  Eigen::ArrayXXd pressure;  ///< pressure of each cell [Pa], same shape as the gap
  /// Displacement of both surfaces away from one another by the pressure [m], same shape as the gap.
  Eigen::ArrayXXd displacement;
  double force = 0;  ///< normal force of the whole patch [N]
  /// Highest pressure [Pa], found between the cells and corrected for the bias of the grid. It may be below the
  /// pressure of the highest cell.
  double max_pressure = 0;
  double area = 0;  ///< contact area [m²]; its edge is located to a fraction of a cell
  /// Extent of the contact along the track over that across it [-]; 0 without a contact: ratio of the radii of gyration
  /// about its centre. They are sums over the lines of cell centres within the edge: along x over the columns, along y
  /// over the rows. Short lines at the tips hardly count.
  double axis_ratio = 0;
  /// Sum of the absolute area corrections at curvature discontinuities of the gap [m²]. Used by error estimates.
  double moved_at_discontinuities = 0;
  bool touches_border = false;  ///< an outer cell of the grid carries pressure: the grid may be too small
};

/// Result of a NormalSolver.
struct NormalSolution
{
  SolveStatus status = SolveStatus::invalid_problem;  ///< whether the solution is usable; check it first
  std::vector<PatchPressure> patches;                 ///< in the order of NormalProblem::patches
  double approach = 0;                                ///< common approach [m]
  /// Number of products with the influence matrix; of sweeps with the Seidel methods, of load evaluations with
  /// Kik-Piotrowski; 0 with Hertz.
  int iterations = 0;
  /// Largest violation of the contact conditions, relative to the largest overlap of the undeformed bodies [-]:
  /// max(|w| where p > 0, -w where p = 0) / max(weight * approach - gap). With Kik-Piotrowski the relative error of the
  /// load; 0 with Hertz.
  double residual = 0;
};

/// Estimated relative errors of one patch of a solution [-], all >= 0. They are estimates, not bounds. The effect of
/// the residual is included.
struct ErrorEstimate
{
  double max_pressure = 0;  ///< of the highest pressure
  double area = 0;          ///< of the contact area
  double approach = 0;      ///< of the approach of the patch, counted from its first touch

  /// Largest of max_pressure, area and approach [-].
  double largest() const;
};
}  // namespace wheel_rail_contact::core
