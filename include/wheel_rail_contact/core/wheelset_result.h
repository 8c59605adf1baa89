// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "wheel_rail_contact/core/rail_compliance.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Whether an answer may be used, and if not, why.
enum class ContactStatus
{
  ok,             ///< every loaded wheel in contact, usable
  lift_off,       ///< at least one wheel carries nothing, the rest is solved; usable
  off_profile,    ///< contact would lie beyond the end of a profile
  not_converged,  ///< normal solution, balance or coupling did not converge
  invalid_input   ///< NaN or infinite input, or angles out of range
};

/// What a rail does under its forces, axes of its side.
struct RailResult
{
  RailDeflection deflection;  ///< of the head
  double lateral_force = 0;   ///< that bends the rail, outward [N]
  double vertical_force = 0;  ///< down [N]
  double moment = 0;          ///< of both about the head's reference point, outward roll positive [N m]
  /// True if the contact was solved on the rail as these forces bend it. False where nothing bends it, or too little to
  /// change the contact by a good part of the tolerance: then the deflection is reported, and counts in the axle's
  /// height, but the gap is that of the rail without it.
  bool coupled = false;
};

/// True if the answer's pressures may be used.
inline bool isUsable(ContactStatus status)
{
  return status == ContactStatus::ok || status == ContactStatus::lift_off;
}
/// Pose of a patch frame: origin at the reference point on the rail, x forward, y left in the tangent plane, z the
/// common normal out of the rail. The frame is turned about x only.
struct PatchPose
{
  double x = 0, y = 0, z = 0;  ///< [m], track frame
  double angle = 0;            ///< rotation about x [rad]
};

/// Grid of a patch's pressure: nx x ny rectangular cells in the patch frame. Cell (i, j) has its centre at (x(i),
/// y(j)).
struct PatchGrid
{
  int nx = 0;     ///< cells along the track
  int ny = 0;     ///< cells across
  double dx = 0;  ///< cell length along the track [m]
  double dy = 0;  ///< cell width across [m]
  double y0 = 0;  ///< y of the centres of the first column [m]

  /// Centre of row `row` [m]; the rows are symmetric about x = 0.
  double x(int row) const { return (row + 0.5 - 0.5 * nx) * dx; }
  /// Centre of column `column` [m].
  double y(int column) const { return y0 + column * dy; }
  /// Area of one cell [m^2].
  double cellArea() const { return dx * dy; }
};

/// One contact patch of an answer.
struct PatchResult
{
  Side side = Side::left;       ///< of the wheel
  std::string_view method;      ///< that solved it, named as in `contact/method`
  PatchPose pose;               ///< of the patch frame
  double contact_angle = 0;     ///< >= 0 [rad]
  double normal_force = 0;      ///< [N]
  double approach = 0;          ///< along the patch's normal [m]
  double area = 0;              ///< [m²]
  double max_pressure = 0;      ///< highest, between the cells; may be below the highest cell [Pa]
  double error_estimate = 0;    ///< relative [-]
  int iterations = 0;           ///< products with the influence matrix
  double residual = 0;          ///< violation of the contact conditions over the approach [-]
  double half_space_ratio = 0;  ///< half the angle through which wheel or rail turns over the patch [rad]
  PatchGrid grid;               ///< cells of `pressure`
  Eigen::ArrayXXd pressure;     ///< nx × ny [Pa]
};

/// The answer to one state.
struct WheelsetResult
{
  ContactStatus status = ContactStatus::invalid_input;  ///< whether the rest may be used
  std::string reason;                                   ///< one sentence, empty when ok and within the tolerance
  bool above_tolerance = false;                         ///< a patch's error estimate is above contact/tolerance
  double x = 0, y = 0, z = 0;                           ///< axle centre, with the solved height [m]
  double yaw = 0, roll = 0;                             ///< with the solved roll [rad]
  std::array<RailResult, 2> rail;                       ///< by Side
  std::vector<PatchResult> patches;                     ///< empty unless usable
};
}  // namespace wheel_rail_contact::core
