// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Numbers that steer the search of an equilibrium and the choice of grids. Smallest values that only guard against
/// rounding stand where they are used.
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
/// Largest approach from the height of the gap to the final one, over the overlap [-]. The normals of the rail are
/// those of the columns at both heights.
constexpr double remaining_approach = 0.1;
/// Relative error of an energy or of an overlap that the residual of the solutions causes [-].
constexpr double noise = 1e-3;
/// Largest difference of the forces of contact and rail that the last step may remove, over the forces [-].
constexpr double last_step = 0.05;

/// Residual of the normal solution per unit of contact/tolerance [-]. In 150 random wheelsets the errors of pressure
/// and area due to the residual were below the residual in 90 % of the cases and below three times the residual in 99 %
/// of them.
constexpr double residual_per_tolerance = 0.02;
/// Residual of the stiffness in the search of an equilibrium [-]. Its steps need no more digits.
constexpr double rough_residual = 0.03;

// Steps.

/// Number of solutions of one wheel in one search. Bisection alone needs fewer.
constexpr int most_solutions = 80;
/// Number of passes over both wheels of one search. A longer one does not end.
constexpr int most_passes = 25;
/// Solutions after which a search is taken to be slow: it then keeps its grids and computes its own slopes.
constexpr int early_solutions = 3;
/// Largest movement of wheel or rail at the contact in one step [m]. Profiles are nearly straight over it.
constexpr double longest_step = 1e-3;
/// Smallest share of a step that is shortened further [-].
constexpr double shortest_share = 0.02;
/// Limit of the slope of the height difference over the roll [m/rad]. Without flange contact it is about -1.4; beyond
/// zero the wheelset is unstable.
constexpr double flattest_slope = -0.01;
/// A step is accepted if the slope of the energy falls below this part of it [-].
constexpr double smaller_slope = 0.9;

// Grids.

/// Expected error on the first grid, 1 / (cells along)², over the tolerance [-]. The true error is a quarter of it.
constexpr double first_share = 1.2;
/// Number of sizes above the first one.
constexpr int most_refinements = 3;

/// Width of a grid over that of the expected contact [-].
constexpr double contact_margin = 1.2;
/// Part that is added to the overlap on each side of a grid over all of it [-]. Its length is approximate.
constexpr double overlap_margin = 0.08;
/// Largest length of a kept grid over that of the area, and largest distance of intervals in it over their width [-].
constexpr double most_larger = 1.5;
/// Columns that a vertical displacement opens by less are left out: a wall [-].
constexpr double smallest_opening = 0.05;
/// Turn of the normals over a contact that is neglected [rad]. Its square halved is the error of a pressure's effect.
constexpr double plane_turn = 0.2;
}  // namespace wheel_rail_contact::core::tuning
