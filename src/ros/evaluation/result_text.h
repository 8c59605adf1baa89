// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "ros/evaluation/contact_evaluator.h"

namespace wheel_rail_contact
{
/// A result as lines of text. First line: lateral displacement and yaw of the wheelset. For each given side: a line
/// with the deflection of the rail, and a line for each patch with highest pressure, area, normal force, contact angle,
/// estimated error and method. For an unusable result: a line with the status and a line with the reason.
std::vector<std::string> resultLines(const ContactOutput& output, const std::vector<core::Side>& sides);
}  // namespace wheel_rail_contact
