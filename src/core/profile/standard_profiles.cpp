// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/standard_profiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double mm = 1e-3;  ///< [m]; the standards give their values in millimetres

/// Half of the circle that contains an arc. Arcs run in the direction of growing y: clockwise on the upper half.
enum class Half
{
  upper,
  lower
};

/// Arc from y = y_start to y = y_end (all values in mm).
ProfileSection arc(Half half, double yc, double zc, double radius, double y_start, double y_end)
{
  const double turn = half == Half::upper ? -1.0 : 1.0;
  const auto angle_at = [&](double y) { return -turn * std::acos(std::clamp((y - yc) / radius, -1.0, 1.0)); };
  const double start = angle_at(y_start);
  const double sweep = turn * (angle_at(y_end) - start);
  return {ArcSection{yc * mm, zc * mm, radius * mm, start, turn}, radius * mm * sweep};
}

/// Straight section between two points [mm].
ProfileSection line(double y0, double z0, double y1, double z1)
{
  const double length = std::hypot(y1 - y0, z1 - z0);
  return {LineSection{y0 * mm, z0 * mm, (y1 - y0) / length, (z1 - z0) / length}, length * mm};
}

/// Section z = -sum down[k] y^k, with the coefficients of the standard [mm^(1-k)], in which z points down.
template <std::size_t Count>
ProfileSection polynomial(const std::array<double, Count>& down, double y_start, double y_end)
{
  static_assert(Count <= PolynomialSection::max_coefficients, "too many coefficients");
  PolynomialSection law{y_start * mm, {}, Count};
  double scale = -mm;
  for (std::size_t k = 0; k < Count; ++k)
  {
    law.coefficient[k] = down[k] * scale;
    scale /= mm;
  }
  return {law, (y_end - y_start) * mm};
}

/// Dimensions in which rail heads of arcs R300, R80 and R13 and 1:20 sides differ [mm]; y outward, z up from the crown.
struct RailHead
{
  double crown_half_width;      ///< y where R300 meets R80
  double corner_yc, corner_zc;  ///< centre of the R13 arc
  double side_depth;            ///< depth of the lower end of the side
};

constexpr double crown_radius = 300.0;
constexpr double shoulder_radius = 80.0;
constexpr double corner_radius = 13.0;
constexpr double side_slope = 20.0;  ///< slope of the sides of the head (1:20)

/// Centre of the R80 arc. It is on a straight line with the centre of R300 and the point at which both arcs meet.
struct ShoulderCentre
{
  explicit ShoulderCentre(double crown_half_width)
      : yc((1.0 - shoulder_radius / crown_radius) * crown_half_width),
        zc(-crown_radius + (1.0 - shoulder_radius / crown_radius) *
                               std::sqrt(crown_radius * crown_radius - crown_half_width * crown_half_width))
  {
  }
  double yc, zc;  ///< [mm]
};

/// y distance from the centre of the R13 arc to the point at which it meets the side [mm].
double cornerReach()
{
  return corner_radius * side_slope / std::hypot(1.0, side_slope);
}

/// Sections of a rail head: the field half and its mirror image. R80 and R13 meet on the line through their centres.
/// R13 and the side meet where R13 has the slope of the side. No section boundary therefore has a kink.
std::vector<ProfileSection> railSections(const RailHead& head)
{
  const double crown_y = head.crown_half_width;
  const ShoulderCentre shoulder(crown_y);
  const double sine =
      (head.corner_yc - shoulder.yc) / std::hypot(head.corner_yc - shoulder.yc, head.corner_zc - shoulder.zc);
  const double shoulder_y = shoulder.yc + shoulder_radius * sine;
  const double corner_y = head.corner_yc + corner_radius * sine;
  const double side_y = head.corner_yc + cornerReach();
  const double side_z = head.corner_zc + cornerReach() / side_slope;
  const double end_y = side_y + (side_z + head.side_depth) / side_slope;
  return {line(-end_y, -head.side_depth, -side_y, side_z),
          arc(Half::upper, -head.corner_yc, head.corner_zc, corner_radius, -side_y, -corner_y),
          arc(Half::upper, -shoulder.yc, shoulder.zc, shoulder_radius, -shoulder_y, -crown_y),
          arc(Half::upper, 0.0, -crown_radius, crown_radius, -crown_y, crown_y),
          arc(Half::upper, shoulder.yc, shoulder.zc, shoulder_radius, crown_y, shoulder_y),
          arc(Half::upper, head.corner_yc, head.corner_zc, corner_radius, corner_y, side_y),
          line(side_y, side_z, end_y, -head.side_depth)};
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
  const auto flank = [](double y) { return 93.576667419 + 2.747477419 * y; };
  const auto tread = [](double y) { return -1.364323640 + 0.066666667 * y; };
  return {"S1002",
          {arc(Half::lower, -49.5, -9.519259302, 20.5, -70.0, -62.764705882),
           arc(Half::lower, -55.0, -16.0, 12.0, -62.764705882, -49.662510381),
           arc(Half::lower, -58.558326413, -8.834924130, 20.0, -49.662510381, -39.764473993),
           line(-39.764473993, flank(-39.764473993), -38.426669071, flank(-38.426669071)),
           arc(Half::upper, -26.210665, -16.446, 13.0, -38.426669071, -35.0), polynomial(c, -35.0, -26.0),
           polynomial(b, -26.0, 32.15796), line(32.15796, tread(32.15796), 60.0, tread(60.0))}};
}

Profile rail60E1()
{
  constexpr double crown_half_width = 20.456 / 2;
  constexpr double shoulder_half_width = 52.053 / 2;
  constexpr double side_depth = 35.275;
  const ShoulderCentre shoulder(crown_half_width);
  const double sine = (shoulder_half_width - shoulder.yc) / shoulder_radius;
  const double centres = shoulder_radius - corner_radius;
  const double corner_yc = shoulder.yc + centres * sine;
  const double corner_zc = shoulder.zc + centres * std::sqrt(1.0 - sine * sine);
  return {"60E1", railSections({crown_half_width, corner_yc, corner_zc, side_depth})};
}

Profile railUic60Manchester()
{
  constexpr double crown_half_width = 10.5;
  constexpr double side_half_width = 36.0;
  // Fitted to the points of the benchmark, to 1e-6 mm. Tangency with R80 would give -14.908927.
  constexpr double corner_zc = -14.908972;
  constexpr double side_depth = 37.5;
  return {"UIC60_manchester", railSections({crown_half_width, side_half_width - cornerReach(), corner_zc, side_depth})};
}
}  // namespace wheel_rail_contact::core
