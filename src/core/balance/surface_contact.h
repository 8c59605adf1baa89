// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/contact_tangent.h"
#include "core/track/contact_search.h"
#include "core/track/surface_gap.h"
#include "wheel_rail_contact/core/normal_solver.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Options of SurfaceContact.
struct SurfaceContactOptions
{
  int cells_along = 32;        ///< cells along the track, > 1, even
  int cells_across = 64;       ///< cells across the track, > 1
  double approach = 1e-3;      ///< largest remaining approach, over the overlap of the undeformed bodies [-], in (0, 1)
  bool turned_normals = true;  ///< the displacement is projected onto the normal of each column
};

/// Contact of one wheel with its rail, on the surface of the rail: each column of the grid has its own normal. Side
/// axes.
///
/// The contact lies inside the overlap of the undeformed bodies, because the surfaces only move apart under a pressure.
/// The grid covers the overlap, which ContactSearch finds. Nothing is learned from earlier solutions. All intervals of
/// the overlap are in one grid. The forces follow from the derivatives of the gap (SurfaceColumn); they are therefore
/// the derivatives of the elastic energy.
class SurfaceContact
{
 public:
  /// Keeps references to `wheel`, `wheelset` and `solver`, which must outlive the object. `modulus`: contact modulus E*
  /// [Pa].
  SurfaceContact(const Profile& wheel, const WheelsetConfig& wheelset, const PlacedRail& rail, double modulus,
                 ConjugateGradients& solver, const SurfaceContactOptions& options);

  /// Solves the contact at a pose.
  SolveStatus solveAt(const WheelsetPose& pose);

  /// Finds the height at which the wheel carries a load [N], > 0; the height of `pose` is the start. The load falls as
  /// the height grows: each solution shows on which side the height lies, and bisection takes over where the step
  /// leaves the bracket.
  SolveStatus solveLoad(const WheelsetPose& pose, double load);

  /// One pass of solveLoad(): solves the contact under the load with the gap of a pose. If the bodies do not overlap,
  /// the pose is first lowered. SolveStatus::invalid_problem if the wheel is beside the rail or the load is not
  /// positive.
  SolveStatus pass(const WheelsetPose& pose, double load);
  /// Remaining approach of the last pass: the height of its gap minus height() [m].
  double remaining() const { return solution_.approach; }
  /// Change of the height by roll about the axle centre, under the same load [m/rad]; zero without a usable solution.
  /// Only the elastic part (ContactTangent): on the flange up to a quarter is missing, which slows the search of the
  /// roll down but does not change its result.
  double heightPerRoll();

  /// Height of the axle centre in the last solution [m]. Under a load, the height to which the remaining approach
  /// leads.
  double height() const { return height_; }
  /// Largest overlap of the undeformed bodies in the last solution [m].
  double overlap() const { return -touch_.separation; }
  /// Vertical force of the wheel on the rail [N], down positive.
  double verticalForce() const;
  /// Lateral force of the wheel on the rail [N], outward positive.
  double outwardForce() const;
  /// Elastic energy of the last solution of solveAt() [J].
  double energy() const;
  /// Normal problem and solution, with one patch.
  const NormalProblem& problem() const { return problem_; }
  const NormalSolution& solution() const { return solution_; }
  /// Columns of the grid.
  const std::vector<SurfaceColumn>& columns() const { return columns_; }
  /// Number of normal problems since solveAt() or solveLoad() was called.
  int solutions() const { return solutions_; }

 private:
  static constexpr double tangent_residual = 0.03;  ///< slopes need no more

  /// Relation of the undeformed bodies at a pose.
  enum class Overlap
  {
    none,    ///< they do not overlap
    found,   ///< they overlap, and the problem was built
    beside,  ///< the wheel is beside the rail, or has no column over it
  };

  Overlap build(const WheelsetPose& pose);
  SurfaceOrigin layGrid(const PlacedWheel& wheel, Grid& grid) const;
  bool setNormals(PatchGap& patch);
  SolveStatus fail(SolveStatus status);
  SolveStatus solve(NormalProblem::Control control, double value);
  double columnForce(std::size_t column) const;

  const Profile& wheel_;
  const WheelsetConfig& wheelset_;
  PlacedRail rail_;
  ConjugateGradients& solver_;
  SurfaceContactOptions options_;
  ContactSearch search_;
  InitialContact touch_;  ///< position of the smallest separation
  std::vector<OverlapInterval> intervals_;
  std::vector<SurfaceColumn> columns_;
  NormalProblem problem_;
  NormalSolution solution_;
  ContactTangent tangent_{tangent_residual};
  std::vector<Eigen::ArrayXXd> openings_;  ///< by the wheel's displacement upwards, and by its roll
  double gap_height_ = 0;                  ///< height of the axle centre for which the gap was built [m]
  double axle_y_ = 0;                      ///< y of the axle centre in the last solution [m]
  double height_ = 0;
  int solutions_ = 0;
};
}  // namespace wheel_rail_contact::core
