// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// How the pressure of one cell displaces the centre of another.
enum class Kernel
{
  rectangle,   ///< constant pressure on the cell, exact
  point_force  ///< the cell's force at its centre (the paper's form); exact on the cell itself
};

/// Integral of 1/rho over a rectangle dx × dy, rho being the distance to a point at (x, y) from its centre [m].
///
/// A constant pressure p on the rectangle displaces that point by p / (pi E*) times this (Boussinesq 1885; closed form:
/// Love 1929; Johnson 1985, eq. 3.25). Far from the rectangle, where the closed form would lose digits by cancellation,
/// Gauss–Legendre quadrature of the same integral is used. Relative error below 1e-12.
double rectangleInfluence(double x, double y, double dx, double dy);

/// The same with the cell's force put into its centre: dx dy / rho (Golubenko et al. 2011). On the cell itself this has
/// no value and the exact integral stands, for a square of side h: 4 h ln(1 + sqrt 2) (the paper's print lacks the h).
///
/// The matrix of these coefficients has negative directions on cells longer than 4.70 times their width.
double pointInfluence(double x, double y, double dx, double dy);

/// One of the two above.
double influence(Kernel kernel, double x, double y, double dx, double dy);
}  // namespace wheel_rail_contact::core
