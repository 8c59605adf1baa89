// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "ros/node/contact_evaluator.h"

namespace wheel_rail_contact
{
/// An answer in a few lines for people: the wheelset's lateral place and yaw, and for each of the given sides its
/// rail's deflection and each patch's highest pressure, area, normal force, contact angle, estimated error and method.
/// Of an answer that is not usable, a line with its status and one with the reason.
std::vector<std::string> resultLines(const ContactOutput& output, const std::vector<core::Side>& sides);
}  // namespace wheel_rail_contact
