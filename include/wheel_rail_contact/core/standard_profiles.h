// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "wheel_rail_contact/core/profile.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Names of the standard profiles of a kind, as loadProfile() takes them. rail_section gives the names of rails.
std::vector<std::string> standardProfileNames(ProfileKind kind);

/// Wheel profile S1002 (EN 13715, UIC 510-2), flange height 28 mm, flange thickness 32.5 mm.
///
/// It consists of the eight sections H G F E D C B A of the standard, with the numbers of the standard, from the flange
/// back (y = -70 mm) to y = +60 mm. These numbers are rounded, and the sections therefore meet with steps: 0.118 um at
/// y = -35 mm (between arc D and polynomial C), 0.037 um at -26 mm (between C and B), below 0.1 nm elsewhere. The steps
/// are kept.
Profile s1002Wheel();

/// Upright rail profile 60E1 (EN 13674-1): arcs R300, R80 and R13 and the sides 1:20, symmetric about y = 0.
///
/// The R300 arc is 20.456 mm wide, and the outer ends of the R80 arcs are 52.053 mm apart. The centres of the arcs and
/// the other section boundaries follow from tangency. The sides end where the lower corners of the head begin.
Profile rail60E1();

/// Upright rail profile UIC60 as sampled for the Manchester contact benchmark (Shackleton and Iwnicki, 2006).
///
/// The arcs have the same radii as in rail60E1(), but the R300 arc is 21 mm wide, and the R13 arcs end on the 1:20
/// sides, 72 mm apart. The gauge corner therefore deviates by up to 0.040 mm from rail60E1(). The sampled R13 arcs lie
/// 0.044 um inside the R80 arcs where they meet; this step is kept. The sides end 37.5 mm below the crown.
Profile railUic60Manchester();
}  // namespace wheel_rail_contact::core
