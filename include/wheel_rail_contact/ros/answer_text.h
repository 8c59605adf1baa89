// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "wheel_rail_contact/ros/contact_evaluator.h"

namespace wheel_rail_contact
{
/// An answer in a few lines for people: the wheelset's lateral place, each rail's deflection, and for each patch of the
/// given sides its highest pressure, area, normal force, contact angle, method and estimated error. An answer that is
/// not usable has a line with its status and one with the reason.
std::vector<std::string> answerLines(const ContactAnswer& answer, const std::vector<Side>& sides);
}  // namespace wheel_rail_contact
