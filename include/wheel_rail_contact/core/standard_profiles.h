// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact::core
{
/// Wheel S1002 (EN 13715, UIC 510-2), flange height 28 mm, flange thickness 32.5 mm, built from its eight
/// sections H G F E D C B A with the standard's own numbers, from the flange back (y = -70 mm) to y = +60 mm.
///
/// The numbers are rounded in the standard, so its sections meet with steps: 0.118 um at y = -35 mm (polynomial C, arc
/// D), 0.037 um at -26 mm (C, B), below 0.1 nm elsewhere. They are kept.
Profile s1002Wheel();

/// Upright rail 60E1 (EN 13674-1): arcs R300, R80, R13 and the 1:20 side, symmetric about y = 0. The R300 arc is
/// 20.456 mm wide, the R80 arcs end 52.053 mm apart; centres and other joints follow from tangency. The side ends where
/// the rounding of the head's lower corner begins.
Profile rail60E1();

/// Upright rail UIC60 as sampled for the Manchester contact benchmark (Shackleton and Iwnicki, 2006): the same arcs,
/// but R300 is 21 mm wide and the R13 arcs end on the 1:20 sides 72 mm apart, which puts the gauge corner 0.040 mm off
/// rail60E1(). The sampled R13 arcs lie 0.044 um inside the R80 arcs where they meet; the step is kept. The sides end
/// 37.5 mm below the crown.
Profile railUic60Manchester();
}  // namespace wheel_rail_contact::core
