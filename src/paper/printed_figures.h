// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core::paper
{
/// Highest pressure and total area of the contact of a wheel.
struct Figures
{
  double max_pressure;  ///< [Pa]
  double area;          ///< [m²]
};

/// Printed results of Golubenko, Kostyukevich, Tsyganovskiy and Nozhenko 2011 (TEKA XI, 78–84): S1002 on UIC60.
constexpr Figures printed_without_bending{1175e6, 185e-6};
constexpr Figures printed_with_bending{1330e6, 127e-6};
constexpr double printed_wheel_load = 100e3;        ///< vertical load of each wheel [N], see doc/paper.md
constexpr double printed_lateral_force = 30e3;      ///< outward force on the rail [N]
constexpr double printed_displacement = 0.2435e-3;  ///< outward displacement of the top of the rail by this force [m]

/// Lateral position that best reproduces the printed results without bending [m]; towards the flange of the evaluated
/// wheel positive. The paper does not state it.
constexpr double case_position = 0.572e-3;

/// Outward roll of the rail that, with the printed displacement, best reproduces the printed results with bending
/// [rad].
constexpr double case_turn = -13e-3;

/// Larger relative deviation of pressure and area [-].
inline double deviation(const Figures& found, const Figures& printed)
{
  return std::max(std::abs(found.max_pressure / printed.max_pressure - 1), std::abs(found.area / printed.area - 1));
}
}  // namespace wheel_rail_contact::core::paper
