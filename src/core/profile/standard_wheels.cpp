// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <vector>

#include "core/profile/standard_sections.h"
#include "wheel_rail_contact/core/standard_profiles.h"

namespace wheel_rail_contact::core
{
namespace
{
using standard::arc;
using standard::Half;
using standard::line;
using standard::polynomial;

constexpr double field_end = 60.0;  ///< y at which the profiles end; the chamfer of the rim begins near it [mm]

/// Flank of a flange: z = height + slope y [mm], and the y at which it begins.
struct Flank
{
  double y_start, height, slope;
  double at(double y) const { return height + slope * y; }
};

/// Flank of 70 degrees in EN 13715, section E, for a flange height of 28 mm.
constexpr Flank en13715_flank{-39.764473993, 93.576667419, 2.747477419};

/// Sections H, G and F of EN 13715, from the flange back to the flank, for a flange height of 28 mm.
std::vector<ProfileSection> en13715Flange()
{
  return {arc(Half::lower, -49.5, -9.519259302, 20.5, -70.0, -62.764705882),
          arc(Half::lower, -55.0, -16.0, 12.0, -62.764705882, -49.662510381),
          arc(Half::lower, -58.558326413, -8.834924130, 20.0, -49.662510381, en13715_flank.y_start)};
}
}  // namespace

Profile s1002Wheel()
{
  constexpr std::array<double, 9> b = {0.0,
                                       -3.358537058e-2,
                                       1.565681624e-3,
                                       -2.810427944e-5,
                                       5.844240864e-8,
                                       -1.562379023e-8,
                                       5.309217349e-15,
                                       -5.957839843e-12,
                                       2.646656573e-13};
  constexpr std::array<double, 8> c = {-4.320221063e3,  -1.038384026e3,  -1.065501873e2,  -6.051367875,
                                       -2.054332446e-1, -4.169739389e-3, -4.687195829e-5, -2.252755540e-7};
  constexpr double flank_end = -38.426669071;
  const Flank& flank = en13715_flank;
  const auto tread = [](double y) { return -1.364323640 + 0.066666667 * y; };
  std::vector<ProfileSection> sections = en13715Flange();
  sections.push_back(line(flank.y_start, flank.at(flank.y_start), flank_end, flank.at(flank_end)));
  sections.push_back(arc(Half::upper, -26.210665, -16.446, 13.0, flank_end, -35.0));
  sections.push_back(polynomial(c, -35.0, -26.0));
  sections.push_back(polynomial(b, -26.0, 32.15796));
  sections.push_back(line(32.15796, tread(32.15796), field_end, tread(field_end)));
  return {"S1002", sections};
}
}  // namespace wheel_rail_contact::core
