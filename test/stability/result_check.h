// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pressed_surface.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::stability
{
/// Checks a result independently of balance and solver: the bodies are placed by the pose and the rail deflections of
/// the result. The gap on the surface of the rail is built under the patch frames, the displacement is computed again
/// from the pressures with exact influence coefficients, and the forces are summed up again from pressures and normals.
///
/// Patches that were cut from one grid are joined to it again, so that all of it is checked. Between patches of
/// different grids of a wheel, the check uses point forces in the cells; the balance uses the mean distance of two
/// columns. The difference of both counts as a violation.
class ResultCheck
{
 public:
  /// Keeps a reference to `config`, which must outlive this object.
  explicit ResultCheck(const ContactModelConfig& config);

  /// Faults of a result; empty if there are none. Valid until the next call.
  const std::vector<std::string>& faults(const WheelsetState& state, const WheelsetResult& result);

  /// Largest violation of the contact conditions in the last result, over the depth of overlap of its wheel [-]; 0 for
  /// hertz and kik_piotrowski, which do not meet them in each cell, and for refusals.
  double violation() const { return violation_; }

 private:
  void fault(const char* what, double value);
  void checkNumbers(const WheelsetResult& result);
  void checkPatch(const PatchResult& patch);
  void checkWheel(const WheelsetState& state, const WheelsetResult& result, Side side);
  void checkFrame(const PressedSurface& surface, const SurfacePart& part);
  void checkLoads(const WheelsetState& state, const WheelsetResult& result, Side side);
  void checkDeflection(const WheelsetState& state, const WheelsetResult& result, Side side);
  void checkRailForces(const WheelsetState& state, const WheelsetResult& result,
                       const std::vector<PressedSurface>& surfaces, const PlacedRail& rail, Side side);
  void checkConditions(const std::vector<PressedSurface>& surfaces, Side side);

  const ContactModelConfig& config_;
  Sides<SurfaceDisplacement> displacement_;
  std::vector<std::string> faults_;
  double violation_ = 0;
};
}  // namespace wheel_rail_contact::core::stability
