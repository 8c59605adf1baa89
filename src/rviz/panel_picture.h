// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <string>
#include <vector>

namespace wheel_rail_contact
{
/// Lines of text above a colour scale of the pressure in MPa, on a dark translucent background.
/// @param max_pressure pressure at the upper end of the scale [Pa]
/// @param letter_size height of the letters [pixels]
QImage panelPicture(const std::vector<std::string>& lines, double max_pressure, int letter_size);
}  // namespace wheel_rail_contact
