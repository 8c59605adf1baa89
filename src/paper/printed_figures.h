// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core::paper
{
/// Highest pressure and area of a wheel's contact.
struct Figures
{
  double max_pressure;  ///< [Pa]
  double area;          ///< [m²]
};

/// What Golubenko, Kostyukevich, Tsyganovskiy and Nozhenko 2011 (TEKA XI, 78–84) print: S1002 on UIC60.
constexpr Figures printed_without_bending{1175e6, 185e-6};
constexpr Figures printed_with_bending{1330e6, 127e-6};
constexpr double printed_wheel_load = 100e3;        ///< vertical [N]; of each wheel, see doc/paper.md
constexpr double printed_lateral_force = 30e3;      ///< on the rail [N]
constexpr double printed_displacement = 0.2435e-3;  ///< of the rail's top, by that force [m]

/// Lateral position at which the printed figures without bending are met best (not stated in the paper), towards the
/// flange of the wheel looked at [m].
constexpr double case_position = 0.572e-3;

/// Outward turn of the rail that, with the printed displacement, meets the printed figures with bending best [rad].
constexpr double case_turn = -13e-3;

/// The larger of both relative deviations [-].
inline double deviation(const Figures& found, const Figures& printed)
{
  return std::max(std::abs(found.max_pressure / printed.max_pressure - 1), std::abs(found.area / printed.area - 1));
}
}  // namespace wheel_rail_contact::core::paper
