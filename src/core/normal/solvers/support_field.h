// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/normal/solvers/column_fields.h"

namespace wheel_rail_contact::core
{
/// Compliant support of a problem in the cell order of the solver: its displacement under a pressure, and the opening
/// of the gap by this displacement.
class SupportField
{
 public:
  /// `length`: length of the arrays that contain the patches.
  void begin(const NormalProblem& problem, const std::vector<PatchLayout>& patches, int length);

  /// Scales the openings, as ColumnFields scales the gap.
  void scale(const ColumnFields& columns);

  bool compliant() const { return support_.compliant; }
  const Eigen::Matrix3d& compliance() const { return support_.compliance; }
  const Eigen::Vector3d& placed() const { return support_.placed; }

  /// Forces of a pressure along the coordinates of the support [N], [N m].
  Eigen::Vector3d force(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure) const;
  /// Coordinates of the support under a pressure [m], [rad].
  Eigen::Vector3d coordinates(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure) const;
  /// Adds the opening of the gap by the coordinates to a displacement [m].
  void open(const Eigen::Vector3d& coordinates, LaneBuffer& displacement) const;

 private:
  Support support_;
  int length_ = 0;
  std::array<LaneBuffer, 3> openings_;
};
}  // namespace wheel_rail_contact::core
