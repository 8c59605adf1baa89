// SPDX-License-Identifier: BSD-3-Clause
#include "half_space/cell_grids.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace wheel_rail_contact::core::half_space
{
namespace
{
/// Length and width of the cells over those of the pressed part: the real bodies may touch on a larger area [-].
constexpr double margin = 1.25;

/// The parts of all loads, joined where they overlap, from the gauge side to the field side.
std::vector<PressedPart> joined(const std::vector<std::vector<PressedPart>>& parts)
{
  std::vector<PressedPart> all;
  for (const std::vector<PressedPart>& of_load : parts)
  {
    all.insert(all.end(), of_load.begin(), of_load.end());
  }
  std::sort(all.begin(), all.end(),
            [](const PressedPart& one, const PressedPart& other) { return one.u_first < other.u_first; });
  std::vector<PressedPart> result;
  for (const PressedPart& part : all)
  {
    if (result.empty() || part.u_first > result.back().u_last)
    {
      result.push_back(part);
      continue;
    }
    result.back().u_last = std::max(result.back().u_last, part.u_last);
    result.back().x_most = std::max(result.back().x_most, part.x_most);
  }
  return result;
}
}  // namespace

std::vector<CellGrid> cellGrids(const PlacedRail& rail, const std::vector<std::vector<PressedPart>>& parts,
                                const CellCount& count)
{
  for (const int cells : {count.rows, count.columns})
  {
    if (cells < 2)
    {
      throw std::invalid_argument("number of cells is " + std::to_string(cells) + ": must be at least 2");
    }
  }
  const std::vector<PressedPart> contacts = joined(parts);
  double length = 0;  // all grids have the same rows
  for (const PressedPart& part : contacts)
  {
    length = std::max(length, margin * part.x_most);
  }
  std::vector<CellGrid> grids;
  for (const PressedPart& part : contacts)
  {
    CellGrid laid;
    const double middle = 0.5 * (part.u_first + part.u_last);
    laid.origin = {0, middle, part.wheel_u + arcLength(rail.profile(), part.u_first, middle)};
    laid.grid.symmetric = true;
    laid.grid.nx = 2 * count.rows;
    laid.grid.ny = count.columns;
    laid.grid.dx = length / count.rows;
    laid.grid.dy = margin * arcLength(rail.profile(), part.u_first, part.u_last) / count.columns;
    laid.grid.y0 = -0.5 * (count.columns - 1) * laid.grid.dy;
    grids.push_back(laid);
  }
  return grids;
}
}  // namespace wheel_rail_contact::core::half_space
