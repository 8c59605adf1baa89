// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/constants.h"
#include "core/option_check.h"
#include "core/profile/standard/sections.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
namespace
{
using standard::arc;
using standard::Half;
using standard::line;
using standard::polynomial;

constexpr double field_end = 60.0;  ///< y at which the profiles end; the chamfer of the rim begins near it [mm]

/// Point of a profile [mm].
struct Point
{
  double y, z;
};

/// Circle of an arc [mm].
struct Circle
{
  double yc, zc, radius;
};

/// Circle that touches `outer` from inside, with its centre above that of `outer`.
Circle inside(const Circle& outer, double radius, double yc)
{
  const double distance = outer.radius - radius;
  return {yc, outer.zc + std::sqrt(distance * distance - (yc - outer.yc) * (yc - outer.yc)), radius};
}

/// Point at which two circles touch, one inside the other: on the line through their centres.
Point contactOf(const Circle& inner, const Circle& outer)
{
  const double scale = outer.radius / (outer.radius - inner.radius);
  return {outer.yc + scale * (inner.yc - outer.yc), outer.zc + scale * (inner.zc - outer.zc)};
}

ProfileSection arcOf(Half half, const Circle& circle, double y_start, double y_end)
{
  return arc(half, circle.yc, circle.zc, circle.radius, y_start, y_end);
}

/// Circle that `inner` touches from inside and that touches a flank on the side of the flange.
/// @param point      a point of the flank
/// @param direction  unit vector along the flank, upwards
Circle besideFlank(const Circle& inner, double radius, const Point& point, const Point& direction)
{
  // The centre is at radius from the flank, and at radius - inner.radius from the centre of `inner`.
  const Point start{point.y - radius * direction.z, point.z + radius * direction.y};
  const double along = (start.y - inner.yc) * direction.y + (start.z - inner.zc) * direction.z;
  const double across = (start.y - inner.yc) * direction.z - (start.z - inner.zc) * direction.y;
  const double between = radius - inner.radius;
  const double step = -along + std::sqrt(between * between - across * across);
  return {start.y + step * direction.y, start.z + step * direction.z, radius};
}

/// Flank of a flange: z = height + slope y [mm], and the y at which it begins.
struct Flank
{
  double y_start, height, slope;
  double at(double y) const { return height + slope * y; }
};

/// Flank of 70 degrees in EN 13715, section E, for a flange height of 28 mm.
constexpr Flank en13715_flank{-39.764473993, 93.576667419, 2.747477419};

/// Sections H, G, F and E of EN 13715, from the flange back to the end of the flank, for a flange height of 28 mm.
std::vector<ProfileSection> en13715Flange(double flank_end)
{
  const Flank& flank = en13715_flank;
  return {arc(Half::lower, -49.5, -9.519259302, 20.5, -70.0, -62.764705882),
          arc(Half::lower, -55.0, -16.0, 12.0, -62.764705882, -49.662510381),
          arc(Half::lower, -58.558326413, -8.834924130, 20.0, -49.662510381, flank.y_start),
          line(flank.y_start, flank.at(flank.y_start), flank_end, flank.at(flank_end))};
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
  const auto tread = [](double y) { return -1.364323640 + 0.066666667 * y; };
  std::vector<ProfileSection> sections = en13715Flange(flank_end);
  sections.push_back(arc(Half::upper, -26.210665, -16.446, 13.0, flank_end, -35.0));
  sections.push_back(polynomial(c, -35.0, -26.0));
  sections.push_back(polynomial(b, -26.0, 32.15796));
  sections.push_back(line(32.15796, tread(32.15796), field_end, tread(field_end)));
  return {"S1002", sections};
}

Profile coneWheel(double slope)
{
  refuseIf(!(slope >= 0.01 && slope <= 0.1),
           "slope = " + std::to_string(slope) + " of a conical wheel must be from 0.01 to 0.1");
  constexpr double root_radius = 13.0;
  const Flank& flank = en13715_flank;
  const double to_flank = std::hypot(1.0, flank.slope);
  const double to_tread = std::hypot(1.0, slope);
  // The centre of the root is at its radius from the flank and from the tread, below both.
  const double yc = (root_radius * (to_flank - to_tread) - flank.height) / (flank.slope - slope);
  const Circle root{yc, slope * yc - root_radius * to_tread, root_radius};
  const double flank_end = root.yc - root_radius * flank.slope / to_flank;
  const double tread_start = root.yc - root_radius * slope / to_tread;
  std::vector<ProfileSection> sections = en13715Flange(flank_end);
  sections.push_back(arcOf(Half::upper, root, flank_end, tread_start));
  sections.push_back(line(tread_start, slope * tread_start, field_end, slope * field_end));
  return {"cone_1_" + std::to_string(std::lround(1.0 / slope)), sections};
}

Profile lmaWheel()
{
  const double sine = std::sin(70.0 * pi / 180.0);  // of the flank
  const double cosine = std::sqrt(1.0 - sine * sine);
  const Circle tread{15.5, -std::sqrt(450.0 * 450.0 - 15.5 * 15.5), 450.0};  // through the running circle
  const Circle transition = inside(tread, 90.0, -5.5);
  const Circle root = inside(transition, 14.0, -24.897648);
  const Circle tip{-54.0, -16.0, 12.0};
  const Circle back{-45.0, tip.zc + std::sqrt(13.0 * 13.0 - 9.0 * 9.0), 25.0};
  const Point flank_end{root.yc - root.radius * sine, root.zc + root.radius * cosine};
  const Circle front = besideFlank(tip, 15.0, flank_end, {cosine, sine});
  const Point flank_start{front.yc + front.radius * sine, front.zc - front.radius * cosine};
  constexpr double inner_slope = 1.0 / 40, outer_slope = 1.0 / 15, bend = 30.0;
  const Point cone_start{tread.yc - tread.radius * inner_slope / std::hypot(1.0, inner_slope),
                         tread.zc + tread.radius / std::hypot(1.0, inner_slope)};
  const double bend_z = cone_start.z + inner_slope * (bend - cone_start.y);
  const double back_end = contactOf(tip, back).y;
  const double tip_end = contactOf(tip, front).y;
  const double root_end = contactOf(root, transition).y;
  const double transition_end = contactOf(transition, tread).y;
  return {
      "LMA",
      {arcOf(Half::lower, back, -70.0, back_end), arcOf(Half::lower, tip, back_end, tip_end),
       arcOf(Half::lower, front, tip_end, flank_start.y), line(flank_start.y, flank_start.z, flank_end.y, flank_end.z),
       arcOf(Half::upper, root, flank_end.y, root_end), arcOf(Half::upper, transition, root_end, transition_end),
       arcOf(Half::upper, tread, transition_end, cone_start.y), line(cone_start.y, cone_start.z, bend, bend_z),
       line(bend, bend_z, field_end, bend_z + outer_slope * (field_end - bend))}};
}
}  // namespace wheel_rail_contact::core
