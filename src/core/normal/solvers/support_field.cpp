// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/support_field.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
void SupportField::begin(const NormalProblem& problem, const std::vector<PatchLayout>& patches, int length)
{
  support_ = problem.support;
  length_ = length;
  for (Eigen::Index m = 0; m < 3 && compliant(); ++m)
  {
    LaneBuffer& field = openings_[static_cast<std::size_t>(m)];
    field.resize(length);
    std::fill_n(field.data(), length, 0.0);
    for (std::size_t k = 0; k < patches.size(); ++k)
    {
      columnsToField(patches[k], problem.patches[k].opening.col(m), field);
    }
  }
}

void SupportField::scale(const ColumnFields& columns)
{
  for (std::size_t m = 0; m < openings_.size() && compliant(); ++m)
  {
    columns.scaleOpening(openings_[m]);
  }
}

Eigen::Vector3d SupportField::force(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure) const
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (const PatchLayout& patch : patches)
  {
    for (Eigen::Index m = 0; m < 3; ++m)
    {
      const double* opening = openings_[static_cast<std::size_t>(m)].data() + patch.begin;
      force[m] += patch.force * laneKernels().dot(patch.size, opening, pressure.data() + patch.begin);
    }
  }
  return force;
}

Eigen::Vector3d SupportField::coordinates(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure) const
{
  return support_.compliance * force(patches, pressure);
}

void SupportField::open(const Eigen::Vector3d& coordinates, LaneBuffer& displacement) const
{
  for (std::size_t m = 0; m < openings_.size(); ++m)
  {
    laneKernels().add(length_, coordinates[static_cast<Eigen::Index>(m)], openings_[m].data(), displacement.data());
  }
}
}  // namespace wheel_rail_contact::core
