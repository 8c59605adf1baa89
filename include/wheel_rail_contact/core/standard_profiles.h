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

/// Wheel profile LMA of Chinese high-speed trains (named in TB/T 449-2016), flange height 28 mm.
///
/// Arcs that meet without a kink: R25, R12 and R15 from the flange back (y = -70 mm), a flank of 70 degrees, R14, R90,
/// and R450 through the running circle; then a cone 1:40, and from y = 30 mm one of 1:15, with a kink between them, to
/// y = +60 mm. The text of the standard was not available. Radii and centres are those of the points in LMA.txt of the
/// Wheel-Rail-Interaction-Dataset (Legend19960404), from which the arcs deviate by up to 0.001 um. The points in
/// LMA.prw of JBG_SDITT (zzh158shallow-tech), given to 1 um, deviate by up to 3 um between y = -30 and +58 mm; their
/// flank lies 24 um closer to the field side.
Profile lmaWheel();

/// Conical wheel with the flange of EN 13715 (sections H, G, F and E of S1002, flange height 28 mm). It is not a
/// profile of a standard.
///
/// The tread is straight, with this slope, from the root of the flange to y = +60 mm. An arc R13 joins tread and flank
/// without a kink. The flange is therefore 32.30 mm thick, 10 mm below the running circle.
/// @param slope  decrease of the radius over the width, to the field side [-], from 0.01 to 0.1: 1/20 and 1/40 for the
/// named profiles cone_1_20 and cone_1_40
/// @throw std::invalid_argument if the slope is out of range.
Profile coneWheel(double slope);

/// Upright rail profile 54E1 (EN 13674-1:2017; earlier UIC 54): arcs R300, R80 and R13 and the sides 1:20, symmetric
/// about y = 0.
///
/// The R300 arc is 20.024 mm wide, and the outer ends of the R80 arcs are 49.727 mm apart (drawing of the standard, as
/// in package EN13674 by A. Rohrbeck). In all profiles of EN 13674-1 here, the centres of the arcs and the other
/// section boundaries follow from tangency, and the sides end where the lower corners of the head begin. The side
/// begins 70.000 mm wide, 14.100 mm below the crown. The points of rolland (mantelmax), from a drawing on GrabCAD,
/// deviate by up to 0.11 um.
Profile rail54E1();

/// Upright rail profile 54E3 (EN 13674-1:2017; earlier DIN S 54): as rail54E1(), but the R300 arc is 15.267 mm wide,
/// the outer ends of the R80 arcs are 46.835 mm apart, and the sides have the slope 1:17.2.
///
/// The side begins 67.000 mm wide, 14.000 mm below the crown. The points of rolland deviate by up to 9 um if their
/// height is fitted, and by 16 um if their crown is placed at the origin.
Profile rail54E3();

/// Upright rail profile 56E1 (EN 13674-1:2017; earlier BS 113 A): arcs R305, R80 and R12.7 and the sides 1:20.
///
/// The R305 arc is 11.787 mm wide, and the outer ends of the R80 arcs are 51.235 mm apart (source as in rail54E1()).
/// The side begins 69.850 mm wide, 14.530 mm below the crown. The stock rail of the UK crossing of the S&C benchmark
/// (Bezin and others, 2021), as it comes with CONTACT, deviates by up to 1.9 um down to 10 mm below the crown, once it
/// is placed by a fit. Further down its points smooth the corner, by up to 31 um.
Profile rail56E1();

/// Upright rail profile 60E1 (EN 13674-1; earlier UIC 60): arcs R300, R80 and R13 and the sides 1:20, symmetric about
/// y = 0.
///
/// The R300 arc is 20.456 mm wide, and the outer ends of the R80 arcs are 52.053 mm apart.
Profile rail60E1();

/// Upright rail profile 60E2 (EN 13674-1:2017): arcs R200, R70, R16 and R8 and the sides 1:20.
///
/// The arcs end where the head is 23.778, 48.913 and 70.774 mm wide (source as in rail54E1()). The side begins 72.000
/// mm wide, 14.300 mm below the crown, as that of rail60E1(). The points of rolland deviate by up to 27 um, or by 15 um
/// if their height is fitted. In that drawing the centres of the R200 arcs are 0.22 mm beside the axis of symmetry.
Profile rail60E2();

/// Upright rail profile UIC60 as sampled for the Manchester contact benchmark (Shackleton and Iwnicki, 2006).
///
/// The arcs have the same radii as in rail60E1(), but the R300 arc is 21 mm wide, and the R13 arcs end on the 1:20
/// sides, 72 mm apart. The gauge corner therefore deviates by up to 0.040 mm from rail60E1(). The sampled R13 arcs lie
/// 0.044 um inside the R80 arcs where they meet; this step is kept. The sides end 37.5 mm below the crown.
Profile railUic60Manchester();
}  // namespace wheel_rail_contact::core
