// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Result of the reference code CONTACT (version of 2024), conformal with turned normals ("fast"), for the right wheel
/// of S1002 on UIC60 of the Manchester benchmark under 100 kN. At -6.3 mm it has two peaks of nearly equal
/// height. The one on the flange is only about 1 mm wide, so that its height depends on the cells; no row has this y.
struct ConformalReference
{
  double y;             ///< [m]
  double max_pressure;  ///< [Pa]
  double area;          ///< [m²]
};
constexpr ConformalReference conformal_references[] = {
    {-3e-3, 1533.9e6, 106.64e-6},     {-5.5e-3, 3300.6e6, 53.28e-6},    {-6e-3, 2656.5e6, 67.03e-6},
    {-6.2e-3, 2065.3e6, 110.47e-6},   {-6.225e-3, 1947.1e6, 127.23e-6}, {-6.25e-3, 1812.7e6, 154.34e-6},
    {-6.275e-3, 1658.3e6, 184.51e-6}, {-6.325e-3, 2063.1e6, 200.07e-6}, {-6.35e-3, 2521.3e6, 200.28e-6},
    {-6.375e-3, 2966.7e6, 195.13e-6}, {-6.4e-3, 3405.3e6, 182.83e-6},   {-7e-3, 6330.2e6, 52.49e-6}};
}  // namespace wheel_rail_contact::core
