// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/track/placement.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// The model's rail, straight; none without a model.
std::optional<core::PlacedRail> restingRail(const core::ContactModelConfig* model);

/// The deflection, every part times `scale`.
core::RailDeflection scaled(const core::RailDeflection& deflection, double scale);

/// A pose that is fixed to the rail's head, after the head has moved from one deflection to another. For pictures with
/// exaggerated deflections: patches stay on the rail that is drawn.
core::PatchPose carriedByRail(const core::PlacedRail& at_rest, core::Side side, const core::RailDeflection& from,
                              const core::RailDeflection& to, const core::PatchPose& pose);
}  // namespace wheel_rail_contact
