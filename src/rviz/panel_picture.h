// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <string>
#include <vector>

namespace wheel_rail_contact
{
/// Lines of text over a bar of the pressure colours with its scale in MPa, on a dark translucent ground.
/// @param max_pressure upper end of the scale [Pa]
/// @param letter_size height of the text's letters [pixels]
QImage panelPicture(const std::vector<std::string>& lines, double max_pressure, int letter_size);
}  // namespace wheel_rail_contact
