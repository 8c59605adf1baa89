// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/track/placement.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// Rails of the model without displacement, at a place of the line [m]; none without a model.
std::optional<core::Sides<core::PlacedRail>> restingRails(const core::ContactModelConfig* model, double distance);

/// Displacement of a rail with a magnified deflection: only the part that was not given (RailResult::given) is
/// multiplied by `scale`.
core::RailDeflection magnified(const core::RailResult& rail, double scale);

/// Pose of a patch that moves with the rail head from one deflection to another. Used for pictures with magnified
/// deflections, in which the patches stay on the drawn rail.
/// @param pose track frame
core::PatchPose carriedByRail(const core::PlacedRail& at_rest, core::Side side, const core::RailDeflection& from,
                              const core::RailDeflection& to, const core::PatchPose& pose);

/// The result with magnified deflections of the rails (magnified()), and with patches that move with these rails.
core::WheelsetResult withMagnifiedDeflection(const core::WheelsetResult& result,
                                             const core::Sides<core::PlacedRail>& at_rest, double scale);
}  // namespace wheel_rail_contact
