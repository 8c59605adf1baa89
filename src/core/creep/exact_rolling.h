// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/creep/creep_strips.h"
#include "core/creep/tangential_influence.h"
#include "wheel_rail_contact/core/creep.h"

namespace wheel_rail_contact::core
{
/// Columns of a row, from `first` to below `end`.
struct LoadedColumns
{
  int first = 0, end = 0;

  bool isEmpty() const { return end <= first; }
};

/// A vector in each cell, in rows from the leading edge; the columns of a row are contiguous and padded.
struct VectorField
{
  LaneBuffer x, y;

  void resize(int size);
};

/// Steady rolling of half-spaces with Coulomb friction (Kalker 1990, chapter 4): in each cell, either the wheel does
/// not slip and the traction is below its bound, or the traction is at the bound and opposite to the slip.
///
/// The slip of a cell is that of a particle on its way from the cell ahead, over one cell: its rigid slip, and the
/// difference of the displacements u(x) - u(x + dx). With the displacement A p, this is A (p - p ahead), summed from
/// the leading edge to one row behind the patch. The unknowns are therefore the steps q of the traction from row to
/// row: their matrix A is symmetric and positive definite, as that of the tractions is not, and Gauss-Seidel converges.
/// A sweep visits the rows from the leading edge. A change of traction moves on to the rows behind, as in rolling,
/// until these are solved in turn, each cell exactly. The method is our own.
class ExactRolling : public CreepSolver
{
 private:
  CreepStatus fill(const CreepProblem& problem, bool warm, CreepSolution& solution) override;
  void prepare(const CreepProblem& problem);
  void setRow(const CreepProblem& problem, int row);
  void widenRanges();
  void startOnStrips(const CreepProblem& problem);
  void startFrom(const CreepSolution& solution);
  void findSlip();
  /// Adds the rigid slip, times a factor, to the slip.
  void addRigid(double factor);
  /// Adds the displacements by the steps of a row to the slip.
  void addSteps(int row, bool to_itself);
  /// Sums over all cells [Pa].
  struct SweepSums
  {
    double change = 0;    ///< of the changes of the tractions, both components
    double traction = 0;  ///< of the tractions
  };
  /// Solves all rows once.
  SweepSums sweep();
  void solve(int row, const LoadedColumns& range, SweepSums& sums);
  void store(const CreepProblem& problem, CreepSolution& solution) const;
  /// Row of the pressure that is `row` rows behind the leading edge, and column on it.
  int gridRow(int row) const { return direction_ > 0 ? nx_ - 1 - row : row; }
  int gridColumn(int column) const { return direction_ > 0 ? column : ny_ - 1 - column; }

  CreepStrips strips_;
  TangentialTables tables_;
  const TangentialTable* table_ = nullptr;
  double direction_ = 1;
  int nx_ = 0, ny_ = 0, line_ = 0;
  /// Of each row and one more: columns with pressure there or in the row ahead. The last one is empty, for rows
  /// outside.
  std::vector<LoadedColumns> ranges_;
  LaneBuffer friction_;       ///< of each column: coefficient of friction times the scale of the pressure [-]
  LaneBuffer bound_;          ///< friction limit [Pa]
  double bound_sum_ = 0;      ///< of all cells [Pa]
  VectorField traction_;      ///< [Pa]
  VectorField rigid_;         ///< rigid slip over one cell, in the unit of A p: times pi G / dy [Pa]
  VectorField slip_;          ///< slip over one cell [Pa]
  VectorField step_, moved_;  ///< of one row: change of q; change of the traction in this sweep [Pa]
  std::vector<int> stepped_;  ///< columns where q changes
};
}  // namespace wheel_rail_contact::core
