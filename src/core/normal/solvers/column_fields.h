// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/solvers/patch_fields.h"

namespace wheel_rail_contact::core
{
/// Weights and normals of the columns of a problem, in the cell order of the solver.
///
/// Weights o that differ from column to column are removed by scaling: with the pressure o p, the displacement u / o,
/// the gap g / o and the matrix D^-1 A D^-1, D = diag(o), the problem has the same form and the weight 1 in every
/// column. The displacement by a pressure is projected onto the normal of each column: with the angles t of the
/// normals, the matrix is A_ij cos(t_i - t_j), that is C A C + S A S with C = diag(cos t), S = diag(sin t). It is
/// symmetric and positive definite, as A is, because for every p it is the sum of the energies of C p and S p.
/// CurvedProblem::coupling adds displacements by the forces in the columns of other patches.
class ColumnFields
{
 public:
  /// Sets the fields; `length`: length of the arrays that contain the patches. Scales the gap, also its smallest value
  /// in the layout. Without a problem, all columns have the normal of their patch.
  void begin(const CurvedProblem* problem, std::vector<PatchLayout>& patches, int length, LaneBuffer& gap);

  /// True if the normals differ from column to column.
  bool turned() const { return turned_; }
  /// True if the patches deform one another.
  bool coupled() const { return coupled_; }
  /// True if the weights differ from column to column; otherwise the next three functions do nothing.
  bool scaled() const { return scaled_; }
  void scale(LaneBuffer& pressure, LaneBuffer& displacement) const;
  void unscale(LaneBuffer& pressure, LaneBuffer& displacement) const;
  /// Divides displacements of the columns by their weights, as the gap is divided.
  void scaleOpening(LaneBuffer& opening) const;

  /// Product of the scaled matrix with `in`.
  void multiply(const std::vector<PatchLayout>& patches, const LaneBuffer& in, LaneBuffer& out,
                InfluenceOperator::Workspace& workspace);
  /// Approximate product of its inverse with `in`. The turning of the normals is neglected.
  void precondition(const PatchLayout& patch, const LaneBuffer& in, LaneBuffer& out,
                    InfluenceOperator::Workspace& workspace);

 private:
  void addCoupling(const std::vector<PatchLayout>& patches, const LaneBuffer& in, LaneBuffer& out);
  void multiplyTurned(const std::vector<PatchLayout>& patches, const LaneBuffer& in, LaneBuffer& out,
                      InfluenceOperator::Workspace& workspace);

  const LaneKernels& kernels_ = laneKernels();
  int length_ = 0;
  bool scaled_ = false, turned_ = false, coupled_ = false;
  const Eigen::MatrixXd* coupling_ = nullptr;
  Eigen::ArrayXd values_;  ///< of the columns of a patch
  Eigen::VectorXd column_force_, column_displacement_;
  LaneBuffer weight_, per_weight_;  ///< o and 1 / o [-]
  LaneBuffer cosine_, sine_;        ///< of t, over o [-]
  LaneBuffer work_, product_;
};
}  // namespace wheel_rail_contact::core
