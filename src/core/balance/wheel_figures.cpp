// SPDX-License-Identifier: BSD-3-Clause
// Measures of the last solution of WheelContact. The other members of WheelContact are in wheel_contact.cpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/balance/wheel_contact.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double rigid_tilt = 0.1;  ///< see tilts() [rad]

/// Largest value of `error_of(k)` over the patches [-].
template <typename ErrorOf>
double largestError(std::size_t patches, const ErrorOf& error_of)
{
  double largest = 0;
  for (std::size_t k = 0; k < patches; ++k)
  {
    largest = std::max(largest, error_of(k));
  }
  return largest;
}
}  // namespace

double WheelContact::patchApproach(std::size_t patch) const
{
  const WheelPatch& p = patches_[patch];
  const double at_first_touch = (elasticPenetration() - p.touch_gap) / std::hypot(1, p.interval.contact.slope);
  return std::max(at_first_touch, problem_.patches[patch].weight * elasticPenetration() - p.least_gap);
}

const std::vector<ErrorEstimate>& WheelContact::estimateErrors()
{
  solver_->estimateErrors(problem_, solution_, errors_);
  return errors_;
}

/// Relative error of a patch by a displacement of the wheel along the plane [m] that is not included in its gap [-].
double WheelContact::slipError(std::size_t patch, double slip) const
{
  const WheelPatch& p = patches_[patch];
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (int j = p.extent.first_column; !p.extent.empty() && j <= p.extent.last_column; ++j)
  {
    least = std::min(least, p.columns[static_cast<std::size_t>(j)].slope);
    most = std::max(most, p.columns[static_cast<std::size_t>(j)].slope);
  }
  return p.extent.empty() ? 0 : (most - least) * std::abs(slip) / (2 * patchApproach(patch));
}

/// Displacement of the wheel along the plane as it moves down with the deflection of the rail [m]. The rail's own
/// downward displacement is subtracted: if both move down together, nothing slides.
double WheelContact::deflectionSlip(const WheelPatch& patch) const
{
  return (deflected_ + railDisplacement(patch)[1]) * std::sin(patch.plane.angle);
}

/// Displacement of the wheel along the plane since the gap was built [m].
double WheelContact::slip(const WheelPatch& patch) const
{
  return (solution_.approach - boxed_penetration_) * std::sin(patch.plane.angle) + deflectionSlip(patch);
}

double WheelContact::slipError() const
{
  return largestError(patches_.size(), [this](std::size_t k) { return slipError(k, slip(patches_[k])); });
}

double WheelContact::layoutError(std::size_t patch, double open_roll) const
{
  const WheelPatch& p = patches_[patch];
  return slipError(patch, slip(p)) + std::abs(p.slope * std::tan(p.plane.angle)) + rollError(patch, open_roll);
}

/// At constant load, roll moves a patch sideways by its depth below the axle, and thereby up its plane.
double WheelContact::rollError(std::size_t patch, double open_roll) const
{
  const WheelPatch& p = patches_[patch];
  const double slip = (wheel_->pose().z - p.plane.z) / std::cos(p.plane.angle) * open_roll;
  const double normal_displacement = std::cos(p.plane.angle) * (leverOf(p) - lever()) * open_roll;
  return slipError(patch, slip) + std::abs(normal_displacement) / patchApproach(patch);
}

double WheelContact::rollError(double open_roll) const
{
  return largestError(patches_.size(),
                      [&](std::size_t k) { return patches_[k].extent.empty() ? 0 : rollError(k, open_roll); });
}

double WheelContact::deflectionError() const
{
  return largestError(patches_.size(), [this](std::size_t k) { return slipError(k, deflectionSlip(patches_[k])); });
}

double WheelContact::halfSpaceRatio(std::size_t patch) const
{
  const WheelPatch& p = patches_[patch];
  const auto turn = [&p](double (GapColumn::*slope_of)() const)
  {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (int j = p.extent.first_column; j <= p.extent.last_column; ++j)
    {
      const double slope = (p.columns[static_cast<std::size_t>(j)].*slope_of)();
      least = std::min(least, slope);
      most = std::max(most, slope);
    }
    return std::atan(most) - std::atan(least);
  };
  return p.extent.empty() ? 0 : 0.5 * std::max(turn(&GapColumn::wheelSlope), turn(&GapColumn::railSlope));
}

double WheelContact::penetrationError() const
{
  return solution_.approach / boxed_penetration_ - 1;
}

double WheelContact::planeError() const
{
  double force = 0;
  double error = 0;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    force += solution_.patches[k].force;
    error += solution_.patches[k].force * std::abs(patches_[k].slope);
  }
  return force > 0 ? error / force : 0;
}

bool WheelContact::tilts() const
{
  double tilt = 0;
  for (const WheelPatch& patch : patches_)
  {
    const double touched = std::atan(patch.interval.contact.slope);
    tilt = std::max(tilt, patch.extent.empty() ? 0 : std::abs(patch.plane.angle - touched));
  }
  return tilt > rigid_tilt;
}

double WheelContact::heightSlope() const
{
  double vertical = 0;
  double sum = 0;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const double angle = patches_[k].plane.angle;
    vertical += solution_.patches[k].force * std::cos(angle);
    sum += solution_.patches[k].force * std::sin(angle);
  }
  return vertical > 0 ? sum / vertical : 0;
}

double WheelContact::leverOf(const WheelPatch& patch) const
{
  const ContactPlane& plane = patch.plane;
  return plane.y - wheel_->pose().y + (plane.z - wheel_->pose().z) * std::tan(plane.angle);
}

double WheelContact::lever() const
{
  double vertical = 0;
  double moment = 0;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const double share = solution_.patches[k].force * std::cos(patches_[k].plane.angle);
    vertical += share;
    moment += share * leverOf(patches_[k]);
  }
  return vertical > 0 ? moment / vertical : 0;
}
}  // namespace wheel_rail_contact::core
