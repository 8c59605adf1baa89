// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Numbers that steer the search of an equilibrium and the choice of grids. Smallest values that only guard against
/// rounding, and limits of a status, stand where they are used.
namespace wheel_rail_contact::core::tuning
{
// Accuracy.

/// Stopping limit of the search of height, roll and deflection. The next step would open the gap by at most this part
/// of the overlap, per unit of contact/tolerance [-]. The pressure changes by about half of the opening, which is a
/// fiftieth of the tolerance.
constexpr double opening_per_tolerance = 0.04;
/// The same limit is this many times larger where the forces jump because the grid changes: the jumps are up to the
/// errors of the grids [-].
constexpr double jump_share = 20;
/// Largest tolerance of grids and searches with a given height: at 1 % the forces rise with each four-hundredth of the
/// way from first touch to 150 kN [-].
constexpr double given_height_tolerance = 0.01;
/// Factor of the same limit while the height per roll is estimated with a constant distribution of the pressure, which
/// makes it up to three times too small [-].
constexpr double unknown_share = 0.3;
/// Accuracy of a linear step: residual of its stiffness, and the most that the last step may change. That is the
/// difference of the forces of contact and rail, over the forces, and the approach from the height of the gap to the
/// final one, over the overlap [-]. The normals of the rail are those of the columns at both heights. Energies and
/// heights are wrong by the square of such a step.
constexpr double last_step = 0.03;

/// Residual of the normal solution per unit of contact/tolerance [-]. In 150 random wheelsets the errors of pressure
/// and area due to the residual were below the residual in 90 % of the cases and below three times the residual in 99 %
/// of them.
constexpr double residual_per_tolerance = 0.02;

// Steps.

/// Number of solutions of one wheel in one search, and of passes over both wheels. A longer search does not end.
constexpr int most_solutions = 25;
/// Solutions after which a search is taken to be slow: it then keeps its grids and computes its own slopes.
constexpr int early_solutions = 3;
/// Largest movement of wheel or rail at the contact in one step, and step from the centre to a state without a result
/// from a cold start [m]. Profiles are nearly straight over it.
constexpr double longest_step = 1e-3;
/// Smallest share of a step that is shortened further. A shortened step keeps or loses at least as much [-].
constexpr double shortest_share = 0.1;

// Grids.

/// Number of sizes above the first one.
constexpr int most_refinements = 3;

/// Width of a grid over that of the expected contact [-].
constexpr double contact_margin = 1.2;
/// Part that is added to the overlap on each side of a grid over all of it [-]. Its length is approximate.
constexpr double overlap_margin = 0.08;
/// Largest length of a kept grid over that of the area, and largest distance of intervals in it over their width [-].
constexpr double most_larger = 1.5;
}  // namespace wheel_rail_contact::core::tuning
