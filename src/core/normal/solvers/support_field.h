// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/normal/solvers/patch_fields.h"

namespace wheel_rail_contact::core
{
/// A problem's support in the solver's order of cells: what a pressure moves it by, and what that opens.
class SupportField
{
 public:
  /// `length`: of the arrays that hold the patches.
  void begin(const NormalProblem& problem, const std::vector<PatchLayout>& patches, int length);

  bool compliant() const { return support_.compliant; }
  const Eigen::Matrix3d& compliance() const { return support_.compliance; }
  const Eigen::Vector3d& placed() const { return support_.placed; }

  /// Forces of a pressure along the coordinates [N], [N m].
  Eigen::Vector3d force(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure) const;
  /// Coordinates under a pressure [m], [rad].
  Eigen::Vector3d coordinates(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure) const;
  /// Adds what the coordinates open to a displacement [m].
  void open(const Eigen::Vector3d& coordinates, LaneBuffer& displacement) const;

 private:
  Support support_;
  int length_ = 0;
  std::array<LaneBuffer, 3> openings_;
};
}  // namespace wheel_rail_contact::core
