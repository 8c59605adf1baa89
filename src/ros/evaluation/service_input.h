// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <wheel_rail_contact/EvaluateWheelset.h>
#include "ros/evaluation/input_pairing.h"
#include "ros/parameters/parameters.h"

namespace wheel_rail_contact
{
/// Input of a service request: the messages that the configuration requires (inputTopics()); the others are null.
ContactInput inputOf(const EvaluateWheelset::Request& request, const NodeConfig& config);
}  // namespace wheel_rail_contact
