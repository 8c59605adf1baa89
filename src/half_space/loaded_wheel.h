// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/balance/islands.h"
#include "core/balance/wheel_contact.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core::half_space
{
/// Residual [-] and number of products with the influence matrix: errors of the iteration are negligible.
const ConjugateGradientsOptions fine_solution{1e-5, 2000};

/// Where the pressure of one contact is. Side axes.
struct PressedPart
{
  double u_first = 0, u_last = 0;  ///< parameters of the rail profile at the outer loaded columns [m]
  double wheel_u = 0;              ///< parameter of the wheel profile at the first of them [m]
  double x_most = 0;               ///< end of the loaded cells along the track [m]
  double half_space_ratio = 0;     ///< PatchResult::half_space_ratio [-]
  bool is_turned = false;          ///< displacements are projected onto turned normals (PatchGap::turn)
};

/// The left wheel on its rail at rest, without roll and yaw, under a vertical load.
class LoadedWheel
{
 public:
  /// Keeps a reference to `config`, which must outlive the object.
  explicit LoadedWheel(const ContactModelConfig& config);

  /// Solves the contact. @throw std::runtime_error if there is no solution
  /// @param y     lateral position of the wheelset [m]
  /// @param load  vertical load [N], > 0
  void solve(double y, double load);

  /// Pose of the wheelset whose height carries the load. Side axes.
  const WheelsetPose& pose() const { return pose_; }
  const PlacedRail& rail() const { return rail_; }
  const WheelContact& contact() const { return contact_; }
  /// The separate contacts.
  const std::vector<PressedPart>& parts() const { return parts_; }

 private:
  void findParts();

  const ContactModelConfig& config_;
  PlacedRail rail_;
  ConjugateGradients solver_;
  WheelContact contact_;
  WheelsetPose pose_;
  std::vector<PressedPart> parts_;
};
}  // namespace wheel_rail_contact::core::half_space
