// SPDX-License-Identifier: BSD-3-Clause
#include "half_space/planar_gap.h"

#include <cmath>
#include <memory>

namespace wheel_rail_contact::core::half_space
{
namespace
{
constexpr double plane_half_width = 0.05;  ///< of the plane that replaces the rail, more than any contact [m]
constexpr int most_steps = 30;             ///< of Newton's method
constexpr double nearest = 1e-12;          ///< largest distance from the place along the plane [m]

/// The plane that touches the rail in a column, as a rail of its own.
PlacedRail planeAt(const SurfaceColumn& column)
{
  const ProfileSection line{LineSection{-plane_half_width, 0, 1, 0}, 2 * plane_half_width};
  return {std::make_shared<const Profile>("plane", std::vector<ProfileSection>{line}),
          RailFrame{column.y, column.z, column.cosine, column.sine}};
}

/// Height of the rail over the plane at a place along it [m]; not a number if there is no such point.
/// @param u  parameter of the rail profile, approximately [m]
double railHeight(const PlacedRail& rail, const SurfaceColumn& plane, double along, double u)
{
  for (int step = 0; step < most_steps; ++step)
  {
    const PlanePoint point = rail.at(u);
    const double y = point.y - plane.y, z = point.z - plane.z;
    const double missing = along - (plane.cosine * y + plane.sine * z);
    if (std::abs(missing) < nearest)
    {
      return plane.cosine * z - plane.sine * y;
    }
    u += missing / (plane.cosine * point.dy + plane.sine * point.dz);
  }
  return std::nan("");
}
}  // namespace

PatchGap planarGap(const PlacedWheel& wheel, const PlacedRail& rail, const std::vector<SurfaceColumn>& columns,
                   const Grid& grid, Eigen::Index touch)
{
  const SurfaceColumn& plane = columns[static_cast<std::size_t>(touch)];
  PatchGap patch;
  patch.grid = grid;
  patch.grid.y0 = -static_cast<double>(touch) * grid.dy;
  patch.weight = plane.cosine;
  std::vector<SurfaceColumn> on_plane;
  Eigen::ArrayXXd heights;
  if (!buildSurfaceGap(wheel, planeAt(plane), {0, plane_half_width, plane.wheel_u}, patch.grid, heights, on_plane))
  {
    return patch;
  }
  for (Eigen::Index j = 0; j < grid.ny; ++j)
  {
    heights.col(j) -=
        railHeight(rail, plane, patch.grid.y(static_cast<int>(j)), columns[static_cast<std::size_t>(j)].rail_u);
    if (!on_plane[static_cast<std::size_t>(j)].has_bodies || !heights.col(j).isFinite().all())
    {
      return patch;
    }
  }
  patch.gap = heights;
  return patch;
}
}  // namespace wheel_rail_contact::core::half_space
