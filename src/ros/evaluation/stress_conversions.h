// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <wheel_rail_contact/PatchStress.h>

#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact
{
/// Stress beneath a patch as a message.
/// @param with_field  include the field
PatchStress toMessage(const core::PatchStress& stress, bool with_field);

/// Stress beneath a patch from a message.
/// @param grid  grid of the patch
/// @throw std::invalid_argument unless the field has six values for each cell and depth, or is empty.
core::PatchStress fromMessage(const PatchStress& message, const core::PatchGrid& grid);
}  // namespace wheel_rail_contact
