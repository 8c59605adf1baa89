// SPDX-License-Identifier: BSD-3-Clause
// How the rail under a wheel's contact is set, loaded and yields: the rest of WheelContact stands in wheel_contact.cpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/balance/wheel_contact.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double steepest_slope = 3.0;   ///< of flanks that may touch [-]
constexpr double rail_head_size = 0.08;  ///< [m]
}  // namespace

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

/// Brings the problem to where the rail has yielded to.
void WheelContact::settleSupport()
{
  deflected_ = 0;
  if (support_.compliance.isZero(0) || !(forces_.vertical > 0))
  {
    return;
  }
  const Eigen::Vector3d along(forces_.outward, -forces_.vertical, forces_.moment);
  const Eigen::Vector3d coordinates =
      support_.compliant ? solution_.support : Eigen::Vector3d(support_.compliance * along);
  const Eigen::Vector3d way = coordinates - support_.placed;
  deflected_ = along.dot(way) / forces_.vertical;
  problem_.support.placed = coordinates;
  if (support_.compliant)
  {
    takeIntoGaps(way);
  }
}

/// Gaps, first touches and approach as if the rail had been set at the end of the way.
void WheelContact::takeIntoGaps(const Eigen::Vector3d& way)
{
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    WheelPatch& patch = patches_[k];
    PatchGap& gap = problem_.patches[k];
    for (Eigen::Index j = 0; j < gap.opening.rows(); ++j)
    {
      gap.gap.col(j) += gap.opening.row(j).matrix().dot(way) - gap.weight * deflected_;
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

double WheelContact::effectOf(const Eigen::Vector3d& way, double limit)
{
  double effect = 0;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const PressureExtent& extent = patches_[k].extent;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (Eigen::Index j = extent.first_column; !extent.empty() && j <= extent.last_column; ++j)
    {
      const double opened = problem_.patches[k].opening.row(j).matrix().dot(way);
      least = std::min(least, opened);
      most = std::max(most, opened);
    }
    const bool flange = std::tan(patches_[k].plane.angle) > flange_slope;
    const double change = flange ? std::numeric_limits<double>::infinity() : (most - least) / (2 * patchApproach(k));
    effect = extent.empty() ? effect : std::max(effect, change);
  }
  if (effect > limit)
  {
    return effect;
  }
  const double reach = steepest_slope * (std::hypot(way[0], way[1]) + rail_head_size * std::abs(way[2]));
  search_.overlapIntervals(touch_separation_ + solution_.approach + reach, intervals_);
  return intervals_.size() == patches_.size() ? effect : std::numeric_limits<double>::infinity();
}
}  // namespace wheel_rail_contact::core
