// SPDX-License-Identifier: BSD-3-Clause
// Position, forces and deflection of the rail under a wheel. The other members of WheelContact are in
// wheel_contact.cpp.
#include <algorithm>
#include <cmath>

#include "core/balance/wheel_contact.h"

namespace wheel_rail_contact::core
{
void WheelContact::setRail(const PlacedRail& rail, const Support& support)
{
  rail_ = rail;
  support_ = support;
  deflected_ = 0;
  search_.setRail(rail);
  touch_.reset();
}

WheelForces WheelContact::sumOfForces() const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const PatchGap& gap = problem_.patches[k];
    for (Eigen::Index j = 0; j < gap.opening.rows(); ++j)
    {
      const double force = gap.grid.cellArea() * solution_.patches[k].pressure.col(j).sum();
      sum += force * gap.opening.row(j).matrix().transpose();
    }
  }
  return {sum[0], -sum[1], sum[2]};
}

double WheelContact::heightOverReference() const
{
  double force = 0;
  double moment = 0;
  const double reference = rail_->referencePoint().z;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    force += solution_.patches[k].force;
    moment += solution_.patches[k].force * (patches_[k].plane.z - reference);
  }
  return force > 0 ? moment / force : 0;
}

/// Moves the problem to the deflected position of the rail.
void WheelContact::settleSupport()
{
  deflected_ = 0;
  if (!support_.compliant || !(forces_.vertical > 0))
  {
    return;
  }
  const Eigen::Vector3d along(forces_.outward, -forces_.vertical, forces_.moment);
  const Eigen::Vector3d move = solution_.support - support_.placed;
  deflected_ = along.dot(move) / forces_.vertical;
  problem_.support.placed = solution_.support;
  takeIntoGaps(move);
}

/// Converts gaps, first touches and approach to those of a rail that had been set at the end of the displacement.
void WheelContact::takeIntoGaps(const Eigen::Vector3d& move)
{
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    WheelPatch& patch = patches_[k];
    PatchGap& gap = problem_.patches[k];
    for (Eigen::Index j = 0; j < gap.opening.rows(); ++j)
    {
      gap.gap.col(j) += gap.opening.row(j).matrix().dot(move) - gap.weight * deflected_;
    }
    const double before = patch.least_gap;
    patch.least_gap = leastGap(gap.grid, gap.gap);
    patch.touch_gap += (patch.least_gap - before) / gap.weight;
  }
  solution_.approach -= deflected_;
}

Eigen::Vector2d WheelContact::railDisplacement(const WheelPatch& patch) const
{
  return displacementOf(*rail_, patch.plane.y, patch.plane.z, support() - support_.placed);
}

double WheelContact::railSlip() const
{
  double slip = 0;
  for (const WheelPatch& patch : patches_)
  {
    const Eigen::Vector2d tangent(std::cos(patch.plane.angle), std::sin(patch.plane.angle));
    slip = std::max(slip, std::abs(tangent.dot(railDisplacement(patch))));
  }
  return slip;
}
}  // namespace wheel_rail_contact::core
