// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// Highest pressure about a cell that no neighbour exceeds, between the cells if it lies there [Pa]; the cell's own
/// where a cell beside it across is not loaded. `pressure` is the solution of `gap` on its grid, `modulus` E* [Pa].
///
/// Constant pressures on cells that meet the contact condition in their centres differ from the true pressure there.
/// What is known of that is taken off the cells across, q = p² is raised to its top between them, and an excess that
/// depends on the bends along and across is taken off. Lengths in cells across (dy), pressures over the crest's:
/// * A curvature of the gap that jumps at s by D, the jump of the gap's second difference times E* / (dy p_crest), as
///   at the joint of two arcs: the true pressure has the part -(D / 2 pi) t ln|t|, t = y - s (Hilbert's transform of
///   the curvature; Johnson 1985, eq. 2.25b), which no parabola follows. The cells' differs from it by D
///   cellErrorAtJump(t). A jump shows as up to three steps of the second differences in a row: their sum is D, their
///   mean place s. Where jumps to and fro are close, see showsWaves(), none is told, and the cell's own pressure is the
///   least.
/// * The edge of the contact, see edgeDistance(): the cells' pressure next to it differs from the root of the distance.
/// * Smooth bends: numbers fitted to test/calibration's wheelsets.
/// All is of plane strain: a joint runs along the patch, whose cells are small against its length.
double crestPressure(const PatchGap& gap, double modulus, const Eigen::ArrayXXd& pressure, Eigen::Index row,
                     Eigen::Index column);

/// The gap's curvature jumps to and fro within a few cells of a crest, as on rough profiles: then nothing is known of
/// its jumps.
bool showsWaves(const PatchGap& gap, double modulus, const Eigen::ArrayXXd& pressure, Eigen::Index row,
                Eigen::Index column);

/// What the pressure of cells that meet the contact condition in their centres exceeds the true one by, a distance t
/// [cells] beside a jump of the gap's curvature, per jump of the gap's second difference as a pressure; odd in t [-].
/// As the jump moves through a cell the second differences are piecewise quadratic in its place, and so is the cells'
/// pressure: to that the true one's logarithm is added. Coefficients from the infinite row of strips, solved by
/// Fourier's transform; test/normal/crest_pressure_test.cpp does that again.
double cellErrorAtJump(double t);
}  // namespace wheel_rail_contact
