// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "wheel_rail_contact/geometry/placement.h"
#include "wheel_rail_contact/wheelset_contact.h"

namespace wheel_rail_contact
{
/// The model's rail, straight; none without a model.
std::optional<PlacedRail> restingRail(const ContactModelConfig* model);

/// The deflection, every part times `scale`.
RailDeflection scaled(const RailDeflection& deflection, double scale);

/// A pose that is fixed to the rail's head, after the head has moved from one deflection to another. For pictures with
/// exaggerated deflections: patches stay on the rail that is drawn.
PatchPose carriedByRail(const PlacedRail& at_rest, Side side, const RailDeflection& from, const RailDeflection& to,
                        const PatchPose& pose);
}  // namespace wheel_rail_contact
