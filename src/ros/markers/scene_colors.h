// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>

#include "ros/markers/marker_tools.h"

namespace wheel_rail_contact
{
/// Colour of a value from 0 (dark violet) to 1 (yellow); values outside are clamped, and NaN gives the colour of 0.
///
/// The colours are polynomials of degree 6, fitted by least squares to the colour map viridis (van der Walt and Smith
/// 2015, public domain), with deviations of at most 0.017. Viridis is perceptually uniform, and readable in grey and
/// with the common types of colour blindness.
std_msgs::ColorRGBA colorOf(double value);

/// Colours that the markers and the legend of the screen panel share.
namespace scene_colors
{
/// Text without a fault.
inline const std_msgs::ColorRGBA text = makeColor(0.95, 0.95, 0.95);
/// A usable result with a warning, or with a wheel that carries no load.
inline const std_msgs::ColorRGBA warning = makeColor(1.0, 0.75, 0.25);
/// Values above the scale: magenta, which is not a colour of colorOf().
inline const std_msgs::ColorRGBA above_scale = makeColor(1, 0.1, 0.8);
/// A result that is not usable.
inline const std_msgs::ColorRGBA error = makeColor(1.0, 0.35, 0.30);
/// Normal force of a wheel on its rail.
inline const std_msgs::ColorRGBA force = makeColor(0.90, 0.30, 0.20);
/// Friction of a wheel on its rail.
inline const std_msgs::ColorRGBA friction = makeColor(0.35, 0.55, 1.0);
/// Section of a rail at rest.
inline const std_msgs::ColorRGBA rail_at_rest = makeColor(0.95, 0.65, 0.2, 0.9);
/// Section of a wheel.
inline const std_msgs::ColorRGBA wheel_section = makeColor(0.45, 0.80, 1.0);
}  // namespace scene_colors

/// Colour of a pressure or a von Mises stress: colorOf() within the scale, and scene_colors::above_scale above its
/// upper end.
/// @param pressure or stress [Pa]
/// @param max_pressure upper end of the scale [Pa], > 0
inline std_msgs::ColorRGBA pressureColor(double pressure, double max_pressure)
{
  return pressure > max_pressure ? scene_colors::above_scale : colorOf(pressure / max_pressure);
}
}  // namespace wheel_rail_contact
