// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/normal/solvers/column_fields.h"

namespace wheel_rail_contact::core
{
/// Stiffness of a solved contact: change of its generalised forces by small displacements of the bodies.
///
/// The cells under pressure stay in contact, and the others stay apart: the change of the contact area has an effect of
/// second order only. With the openings o_k of the gap by the displacements, and the influence matrix A_cc of the cells
/// under pressure, K_kl = o_k^T A_cc^-1 o_l (integrated over the cells). K is symmetric and positive semidefinite. It
/// contains the elastic part only: the change of the openings themselves by the displacements is left out.
class ContactTangent
{
 public:
  static constexpr int most = 8;  ///< displacements
  using Stiffness = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most, most>;
  using Forces = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1>;

  /// `residual`: largest remaining opening of the cells under pressure, over the largest opening [-], in (0, 1).
  explicit ContactTangent(double residual = 1e-3) : residual_(residual) {}

  /// Sets the largest remaining opening, see the constructor.
  void setResidual(double residual) { residual_ = residual; }

  /// Stiffness of a usable solution of the problem by ConjugateGradients [N/m], [N/rad] or [N m/rad].
  /// @param openings  for each patch an array ny × n: change of the gap in each column per unit of each displacement; n
  /// <= most
  /// @return n × n; zero if no cell is under pressure, not a number if the iteration fails
  Stiffness stiffness(const CurvedProblem& problem, const NormalSolution& solution,
                      const std::vector<Eigen::ArrayXXd>& openings);

  /// Column `displacement` of the same matrix, without the others.
  Forces stiffness(const CurvedProblem& problem, const NormalSolution& solution,
                   const std::vector<Eigen::ArrayXXd>& openings, Eigen::Index displacement);

  /// Changes of the pressure in the loaded cells by changes of the gap of each cell, one after the other.
  /// @param openings  for each displacement and patch an array rows() × ny
  /// @param changes   set to arrays of the same shape [Pa per unit]; not a number where the iteration fails
  void pressures(const CurvedProblem& problem, const NormalSolution& solution,
                 const std::vector<std::vector<Eigen::ArrayXXd>>& openings,
                 std::vector<std::vector<Eigen::ArrayXXd>>& changes);

  /// Number of products with the influence matrix since the object was made.
  int products() const { return products_; }

 private:
  void layOutLoaded(const CurvedProblem& problem, const NormalSolution& solution);
  void begin(const CurvedProblem& problem, const NormalSolution& solution,
             const std::vector<Eigen::ArrayXXd>& openings);
  Forces column(Eigen::Index displacement);
  double dot(const LaneBuffer& a, const LaneBuffer& b) const;
  double largest(const LaneBuffer& field) const
  {
    return Eigen::Map<const Eigen::ArrayXd>(field.data(), length_).abs().maxCoeff();
  }
  void mask(LaneBuffer& field) const { kernels_.multiply_by(length_, loaded_.data(), field.data()); }
  void precondition();
  void solve(const LaneBuffer& right);

  double residual_;
  OperatorCache cache_;
  InfluenceOperator::Workspace workspace_;
  const LaneKernels& kernels_ = laneKernels();
  std::vector<PatchLayout> patches_;
  ColumnFields columns_;
  int length_ = 0, products_ = 0;
  LaneBuffer gap_, loaded_;           ///< gap, not used; 1 in the cells under pressure, otherwise 0
  LaneBuffer x_, r_, z_, s_, q_;      ///< conjugate gradients: solution, residual, preconditioned, step, product
  std::vector<LaneBuffer> openings_;  ///< one field for each displacement
};
}  // namespace wheel_rail_contact::core
