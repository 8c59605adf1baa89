// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>

namespace wheel_rail_contact
{
/// Colour of a value between 0 (dark violet) and 1 (yellow), clamped: perceptually even, readable with the common kinds
/// of colour blindness and in grey. Polynomials of degree 6 fitted by least squares to the colour map viridis (van der
/// Walt and Smith, 2015, placed in the public domain), within 0.017 of it.
std_msgs::ColorRGBA colorOf(double value);
}  // namespace wheel_rail_contact
