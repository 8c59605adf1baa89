// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact
{
/// How the contact is drawn.
struct MarkerConfig
{
  double rate = 20;               ///< most pictures in a second of wall time [Hz], > 0
  double rail_length = 0.4;       ///< drawn length of both rails [m], > 0
  double force_scale = 2.5e-6;    ///< length of a force arrow [m/N], >= 0; 0: no arrows
  double max_pressure = 2e9;      ///< upper end of the colour scale [Pa], > 0
  double zoom = 30;               ///< magnification of the patches drawn above the rails [-], >= 0; 0: none
  double zoom_height = 0.18;      ///< of these patches above the true ones [m], >= 0
  double pressure_height = 0.15;  ///< height of the pressure surface at `max_pressure`, magnified patch [m], >= 0
};
}  // namespace wheel_rail_contact
