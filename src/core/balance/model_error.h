// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Bound of the relative error of maximum pressure and area due to the half-spaces [-]. It was calibrated on contacts
/// by finite elements, under the same force (doc/half_space.md). Where no contact was compared, it is 1: not known.
///
/// The constant part covers the finite size of the bodies. The displacement by a force on a curved surface differs from
/// that on a plane by terms of the order of distance over radius. They have opposite signs on a wheel and on a rail,
/// and cancel where both have the same radius, so the square remains.
/// @param half_space_ratio  PatchResult::half_space_ratio [rad]
/// @param is_turned         displacements are projected onto the normals of the columns (ColumnNormals::turn)
double modelError(double half_space_ratio, bool is_turned);
}  // namespace wheel_rail_contact::core
