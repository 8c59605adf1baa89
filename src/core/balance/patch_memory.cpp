// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/patch_memory.h"

#include <algorithm>
#include <cmath>

#include "core/normal/operator/cell_aspect.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double box_margin = 1.1;  ///< size of the grid over the size of the pressure, along and across the track [-]
constexpr double box_growth = 0.3;  ///< growth of a box at a side that cuts the pressure off, relative to its size [-]
constexpr double first_reach = 0.85;  ///< expected extent of the pressure over that of the overlap, initial guess [-]

constexpr double steepest_plane = 1.4;  ///< largest angle of a contact plane; flange faces have up to 1.2 [rad]

/// Grid with a cell aspect ratio of the prepared series, over `length` along the track and [begin, end] across it, with
/// a margin [m].
Grid coveringGrid(double length, double begin, double end, const GridSize& size)
{
  const cell_aspect::Cell cell =
      cell_aspect::coveringCell(box_margin * length, box_margin * (end - begin), size.along, size.across);
  return {size.along, size.across, cell.dx, cell.dy, 0.5 * (begin + end) - 0.5 * (size.across - 1) * cell.dy, false};
}

/// Turn that makes the plane normal to the pressure-weighted mean normal [rad]. If the turns alternate (two lobes of
/// one interval that exchange the load), at most half of the last turn.
double nextTurn(const WheelPatch& patch)
{
  const double turn = std::atan(patch.slope);
  return turn * patch.turned < 0 ? std::copysign(std::min(std::abs(turn), 0.5 * std::abs(patch.turned)), turn) : turn;
}

/// Plane through the rail point `rail_u`, parallel to the chord of the interval, at the contact locus of the wheel. It
/// moves continuously with the bodies, wherever in the interval they touch first.
ContactPlane planeAt(const PlacedWheel& wheel, const PlacedRail& rail, const OverlapInterval& interval, double rail_u)
{
  InitialContact contact = interval.contact;
  contact.wheel_u += rail_u - contact.rail_u;
  contact.rail_u = rail_u;
  const PlanePoint begin = rail.at(interval.u_begin);
  const PlanePoint end = rail.at(interval.u_end);
  contact.slope = (end.z - begin.z) / (end.y - begin.y);
  return tangentPlane(wheel, rail, contact);
}

double middleOf(const OverlapInterval& interval)
{
  return 0.5 * (interval.u_begin + interval.u_end);
}

double halfWidth(const OverlapInterval& interval)
{
  return 0.5 * (interval.u_end - interval.u_begin);
}

/// The interval, enlarged by a factor about its middle.
OverlapInterval widened(OverlapInterval interval, double factor)
{
  const double middle = middleOf(interval);
  const double half = factor * halfWidth(interval);
  interval.u_begin = middle - half;
  interval.u_end = middle + half;
  return interval;
}

/// Widens the stored extent at the sides at which the grid cut the pressure off.
void growCut(const PressureExtent& extent, const Grid& grid, PatchMemory& memory)
{
  const double width = memory.end - memory.begin;
  memory.begin -= extent.cutBegin(grid) ? box_growth * width : 0;
  memory.end += extent.cutEnd(grid) ? box_growth * width : 0;
  memory.half_length *= extent.cutLength(grid) ? 1 + box_growth : 1;
}
}  // namespace

PatchMemory firstGuess(const OverlapInterval& interval)
{
  PatchMemory memory;
  memory.rail_u = interval.contact.rail_u;
  memory.begin = -first_reach;
  memory.end = first_reach;
  memory.half_length = first_reach;
  return memory;
}

PatchMemory remember(const PlacedWheel& wheel, const PlacedRail& rail, const WheelPatch& patch, const Grid& grid,
                     double grown)
{
  const PressureExtent& extent = patch.extent;
  const OverlapInterval interval = widened(patch.interval, grown);
  const double middle = middleOf(interval);
  const double half = halfWidth(interval);
  const auto fraction = [&](double t) { return (railParameter(grid, patch.columns, t) - middle) / half; };
  PatchMemory memory;
  memory.interval = interval;
  memory.rail_u = railParameter(grid, patch.columns, patch.center_y);
  memory.center = (memory.rail_u - middle) / half;
  memory.begin = fraction(extent.y_begin);
  memory.end = fraction(extent.y_end);
  memory.half_length = extent.half_length / (patch.half_overlap * grown);
  const ContactPlane base = planeAt(wheel, rail, interval, memory.rail_u);
  memory.turned = nextTurn(patch);
  memory.turn = patch.plane.angle + memory.turned - base.angle;
  memory.shift_x = patch.plane.x + patch.center_x - base.x;
  growCut(extent, grid, memory);
  return memory;
}

void layPatch(const PlacedWheel& wheel, const PlacedRail& rail, const GridSize& size, bool held, PatchMemory& memory,
              WheelPatch& patch, Grid& grid)
{
  const OverlapInterval& interval = held && memory.interval ? *memory.interval : patch.interval;
  const double middle = middleOf(interval);
  const double half = halfWidth(interval);
  ContactPlane& plane = patch.plane;
  plane = planeAt(wheel, rail, interval, middle + memory.center * half);
  const bool symmetric = wheel.pose().yaw == 0;  // without yaw both bodies are symmetric about x = 0
  plane.x += symmetric ? 0 : memory.shift_x;     // the memory may come from a yawed state
  plane.angle = std::clamp(plane.angle + memory.turn, -steepest_plane, steepest_plane);
  patch.turned = memory.turned;

  if (memory.grid.nx == size.along && memory.grid.ny == size.across && memory.grid.symmetric == symmetric)
  {
    grid = memory.grid;
    patch.expected_width = memory.width;
    patch.expected_length = memory.length;
    return;
  }
  const PlaneAxes axes(plane);
  const double begin = axes.t(rail.at(middle + memory.begin * half));
  const double end = axes.t(rail.at(middle + memory.end * half));
  patch.expected_width = memory.width = end - begin;
  patch.expected_length = memory.length = 2 * memory.half_length * patch.half_overlap;
  grid = coveringGrid(memory.length, begin, end, size);
  grid.symmetric = symmetric;
  memory.grid = grid;
}
}  // namespace wheel_rail_contact::core
