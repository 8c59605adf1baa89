// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/profile/standard/sections.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
namespace
{
using standard::arc;
using standard::Half;
using standard::line;

/// Arc of a rail head on the field side [mm]; y outward, z up from the crown.
struct HeadArc
{
  double yc, zc;  ///< centre
  double radius;
  double y_start, y_end;
};

/// Straight side of a rail head, tangent to its last arc.
struct StraightSide
{
  double slope;  ///< height over width [-]: 20 for a side 1:20
  double depth;  ///< depth of its lower end below the crown [mm]
};

/// Sine of the angle of a tangent of this slope from the horizontal, and of a normal from the vertical [-].
double sineOf(double slope)
{
  return slope / std::hypot(1.0, slope);
}

/// Sections of a rail head: the field half, and its mirror image. The arcs run from the crown outward.
std::vector<ProfileSection> headSections(const std::vector<HeadArc>& arcs, const StraightSide& side)
{
  const HeadArc& crown = arcs.front();
  const HeadArc& corner = arcs.back();
  const double side_z = corner.zc + (corner.y_end - corner.yc) / side.slope;
  const double end_y = corner.y_end + (side_z + side.depth) / side.slope;
  std::vector<ProfileSection> sections{line(-end_y, -side.depth, -corner.y_end, side_z)};
  for (std::size_t k = arcs.size() - 1; k > 0; --k)
  {
    sections.push_back(arc(Half::upper, -arcs[k].yc, arcs[k].zc, arcs[k].radius, -arcs[k].y_end, -arcs[k].y_start));
  }
  sections.push_back(arc(Half::upper, crown.yc, crown.zc, crown.radius, -crown.y_end, crown.y_end));
  for (std::size_t k = 1; k < arcs.size(); ++k)
  {
    sections.push_back(arc(Half::upper, arcs[k].yc, arcs[k].zc, arcs[k].radius, arcs[k].y_start, arcs[k].y_end));
  }
  sections.push_back(line(corner.y_end, side_z, end_y, -side.depth));
  return sections;
}

/// Arc of a rail head, as the drawing of a standard states it.
struct DrawnArc
{
  double radius;  ///< [mm]
  double width;   ///< distance of its outer end from that of its mirror image [mm]
};

/// Rail head of arcs that meet without a kink: the centres of two neighbours and the point at which they meet are on
/// one line. The last arc ends where it has the slope of the side.
/// @param arcs    from the crown outward; the first one is on the axis of symmetry
/// @param radius  radius of the last arc [mm]
Profile railHead(std::string name, const std::vector<DrawnArc>& arcs, double radius, const StraightSide& side)
{
  std::vector<HeadArc> placed;
  HeadArc next{0.0, -arcs.front().radius, arcs.front().radius, 0.0, 0.0};
  for (std::size_t k = 0; k < arcs.size(); ++k)
  {
    next.y_end = 0.5 * arcs[k].width;
    placed.push_back(next);
    const double sine = (next.y_end - next.yc) / next.radius;
    const double inner = k + 1 < arcs.size() ? arcs[k + 1].radius : radius;
    next = {next.yc + (next.radius - inner) * sine, next.zc + (next.radius - inner) * std::sqrt(1.0 - sine * sine),
            inner, next.y_end, 0.0};
  }
  next.y_end = next.yc + radius * sineOf(side.slope);
  placed.push_back(next);
  return {std::move(name), headSections(placed, side)};
}
}  // namespace

Profile rail54E1()
{
  return railHead("54E1", {{300.0, 20.024}, {80.0, 49.727}}, 13.0, {20.0, 34.057});
}

Profile rail54E3()
{
  return railHead("54E3", {{300.0, 15.267}, {80.0, 46.835}}, 13.0, {17.2, 39.443});
}

Profile rail56E1()
{
  return railHead("56E1", {{305.0, 11.787}, {80.0, 51.235}}, 12.7, {20.0, 33.905});
}

Profile rail60E1()
{
  return railHead("60E1", {{300.0, 20.456}, {80.0, 52.053}}, 13.0, {20.0, 35.275});
}

Profile rail60E2()
{
  return railHead("60E2", {{200.0, 23.778}, {70.0, 48.913}, {16.0, 70.774}}, 8.0, {20.0, 35.275});
}

Profile railUic60Manchester()
{
  constexpr double crown_half_width = 10.5;
  constexpr double side_half_width = 36.0;
  constexpr StraightSide side{20.0, 37.5};
  constexpr HeadArc crown{0.0, -300.0, 300.0, 0.0, crown_half_width};
  const double to_shoulder = (crown.radius - 80.0) / crown.radius;
  HeadArc shoulder{
      to_shoulder * crown_half_width,
      crown.zc + to_shoulder * std::sqrt(crown.radius * crown.radius - crown_half_width * crown_half_width), 80.0,
      crown_half_width, 0.0};
  // Fitted to the points of the benchmark, to 1e-6 mm. Tangency with R80 would give -14.908927.
  constexpr double corner_zc = -14.908972;
  HeadArc corner{side_half_width - 13.0 * sineOf(side.slope), corner_zc, 13.0, 0.0, side_half_width};
  const double sine = (corner.yc - shoulder.yc) / std::hypot(corner.yc - shoulder.yc, corner.zc - shoulder.zc);
  shoulder.y_end = shoulder.yc + shoulder.radius * sine;
  corner.y_start = corner.yc + corner.radius * sine;
  return {"UIC60_manchester", headSections({crown, shoulder, corner}, side)};
}
}  // namespace wheel_rail_contact::core
