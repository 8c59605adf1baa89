// SPDX-License-Identifier: BSD-3-Clause
#include "half_space/loaded_wheel.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "core/balance/rail_support.h"

namespace wheel_rail_contact::core::half_space
{
namespace
{
constexpr GridSize fine_grid{80, 96};        ///< errors of pressure and area below 0.1 %
constexpr int most_passes = 20;              ///< solutions at heights that approach the final one
constexpr double remaining_approach = 1e-4;  ///< difference from the final height, over the overlap [-]
constexpr double clear_height = 0.1;         ///< above the rolling radius: the wheel is above the rail there [m]
}  // namespace

LoadedWheel::LoadedWheel(const ContactModelConfig& config)
    : config_(config),
      rail_(restingRail(config_, Side::left)),
      solver_(fine_solution),
      contact_(config_, Side::left, rail_, solver_)
{
  contact_.setGrid(0, fine_grid);
  contact_.setRail(rail_);
}

void LoadedWheel::solve(double y, double load)
{
  contact_.forget();
  pose_ = {y, config_.wheelset.rolling_radius.left + clear_height, 0, 0};
  for (int pass = 0; pass < most_passes; ++pass)
  {
    if (contact_.solveLoad(pose_, load) != WheelStatus::solved)
    {
      break;
    }
    pose_.z = contact_.height();
    if (std::abs(contact_.remaining()) < remaining_approach * contact_.overlap())
    {
      findParts();
      return;
    }
  }
  std::ostringstream message;
  message << "no contact was found for y = " << y << " m and a load of " << load << " N";
  throw std::runtime_error(message.str());
}

void LoadedWheel::findParts()
{
  Islands islands;
  islands.find(contact_.problem(), contact_.solution());
  parts_.clear();
  for (const Island& island : islands.islands())
  {
    const PatchPressure& patch = contact_.solution().patches[island.patch];
    const std::vector<SurfaceColumn>& columns = contact_.grids().columns()[island.patch];
    const SurfaceColumn& first = columns[static_cast<std::size_t>(island.first)];
    PressedPart part{first.rail_u,
                     columns[static_cast<std::size_t>(island.last)].rail_u,
                     first.wheel_u,
                     0,
                     contact_.halfSpaceRatio(island.patch, island.first, island.last),
                     contact_.problem().normals[island.patch].areTurned()};
    for (int row = 0; row < patch.grid.rows(); ++row)
    {
      if ((patch.pressure.row(row).segment(island.first, island.last - island.first + 1) > 0).any())
      {
        part.x_most = patch.grid.x(row) + 0.5 * patch.grid.dx;
      }
    }
    parts_.push_back(part);
  }
}
}  // namespace wheel_rail_contact::core::half_space
