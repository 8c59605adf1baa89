// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact
{
/// Appearance of the markers.
struct MarkerConfig
{
  double rate = 20;             ///< maximum rate of the markers, in wall time [Hz], > 0
  double rail_length = 0.4;     ///< drawn length of both rails [m], > 0
  double force_scale = 2.5e-6;  ///< length of a force arrow [m/N], >= 0; 0: no arrows
  double max_pressure = 0;      ///< upper end of the colour scale [Pa], >= 0; 0: follows the pressures (PressureScale)
  double zoom = 15;             ///< magnification of the patches above the rails [-], >= 0; 0: not drawn
  double zoom_height = 0.12;    ///< height of the magnified patches above the true patches [m], >= 0
  double pressure_height = 0.10;  ///< height of the magnified pressure surface at the upper end of the scale [m], >= 0
};
}  // namespace wheel_rail_contact
