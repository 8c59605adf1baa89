// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "core/track/rail_along.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Rotation of the track frame per length of its centre line [rad/m], in track axes: x by the change of the cant (and
/// curvature on a gradient), y by that of the gradient, z by the curvature.
Eigen::Vector3d turnOf(const TrackLine& line, double x);

/// Adds to the course of each rail its direction and curvature in a track frame that turns, if the line has a design.
/// @param heads  reference points of the rails, side axes
void addTurn(const TrackLine& line, double x, const Sides<PlanePoint>& heads, Sides<RailCourse>& courses);

/// Track frames along the centre line of a line that does not repeat.
///
/// Fixed frame: that of the track at the first station, level and without cant; its x there is that of the line.
class TrackPath
{
 public:
  explicit TrackPath(std::shared_ptr<const TrackLine> line);

  /// Track frame at x [m], in the fixed frame.
  Eigen::Isometry3d frameAt(double x) const;
  /// The place x [m] in whose cross section a point of the fixed frame lies, the nearest one.
  double placeOf(const Eigen::Vector3d& point) const;

 private:
  struct Node
  {
    double x = 0;                                        ///< [m]
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
    double heading = 0;                                  ///< to the left [rad]
  };

  Node moved(const Node& from, double x) const;

  std::shared_ptr<const TrackLine> line_;
  std::vector<Node> nodes_;          ///< stations, and places between them
  std::vector<std::size_t> sparse_;  ///< numbers of nodes at larger distances
};
}  // namespace wheel_rail_contact::core
