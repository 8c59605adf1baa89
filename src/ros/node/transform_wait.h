// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <functional>

#include "ros/evaluation/contact_input.h"

namespace wheel_rail_contact
{
/// Waits until tf has the transform of an input, or until InputPreparation::transform_timeout after its arrival.
/// Because the deadline counts from the arrival, a transform that never arrives delays the results but does not reduce
/// their rate.
/// @param ended true: the wait ends at once
void waitForTransform(const InputPreparation& preparation, const ContactInput& input, const tf2::BufferCore& transforms,
                      const std::function<bool()>& ended);
}  // namespace wheel_rail_contact
