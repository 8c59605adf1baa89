// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>

namespace wheel_rail_contact
{
/// Colour of a value from 0 (dark violet) to 1 (yellow); values outside are clamped, and NaN gives the colour of 0.
///
/// The colours are polynomials of degree 6, fitted by least squares to the colour map viridis (van der Walt and Smith
/// 2015, public domain), with deviations of at most 0.017. Viridis is perceptually uniform, and readable in grey and
/// with the common types of colour blindness.
std_msgs::ColorRGBA colorOf(double value);

/// Magenta, which is not a colour of colorOf(): values above the scale.
std_msgs::ColorRGBA aboveScaleColor();
}  // namespace wheel_rail_contact
