// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/rail_support.h"

namespace wheel_rail_contact::core
{
Eigen::Vector3d toCoordinates(const RailDeflection& deflection)
{
  return {deflection.lateral, deflection.vertical, deflection.roll};
}

RailDeflection toDeflection(const Eigen::Vector3d& coordinates)
{
  return {coordinates[0], coordinates[1], coordinates[2]};
}

Eigen::Matrix3d supportCompliance(const ComplianceTable& table, double inclination)
{
  Eigen::Matrix3d compliance;
  compliance.col(0) = toCoordinates(deflectionInTrack(table, {1, 0, 0}, inclination));
  compliance.col(1) = toCoordinates(deflectionInTrack(table, {0, -1, 0}, inclination));
  compliance.col(2) = toCoordinates(deflectionInTrack(table, {0, 0, 1}, inclination));
  return compliance;
}

Eigen::Vector2d displacementOf(const PlacedRail& rail, double y, double z, const Eigen::Vector3d& move)
{
  const PlanePoint reference = rail.referencePoint();
  return {move[0] + move[2] * (z - reference.z), move[1] - move[2] * (y - reference.y)};
}

void fillOpening(const PlacedRail& rail, const ContactPlane& plane, const Grid& grid,
                 const std::vector<GapColumn>& columns, Eigen::ArrayX3d& opening)
{
  const PlaneAxes axes(plane);
  const PlanePoint reference = rail.referencePoint();
  opening.resize(grid.ny, 3);
  for (int j = 0; j < grid.ny; ++j)
  {
    const GapColumn& column = columns[static_cast<std::size_t>(j)];
    const double t = grid.y(j), n = column.rail_height;
    const double outward = axes.sine() + column.railSlope() * axes.cosine();
    opening(j, 0) = outward;
    opening(j, 1) = -axes.cosine();
    opening(j, 2) = outward * (axes.z(t, n) - reference.z) + axes.cosine() * (axes.y(t, n) - reference.y);
  }
}
}  // namespace wheel_rail_contact::core
