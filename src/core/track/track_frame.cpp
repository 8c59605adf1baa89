// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/track_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheel_rail_contact::core
{
using Eigen::Vector3d;

namespace
{
constexpr double longest_piece = 5;      ///< of the line between two nodes [m]
constexpr double place_accuracy = 1e-9;  ///< of placeOf() [m]
constexpr int most_place_steps = 50;     ///< to this accuracy
}  // namespace

Vector3d turnOf(const TrackLine& line, double x)
{
  TrackDesign change;
  const TrackDesign design = line.designAt(x, &change);
  const double in_plan = 1 / std::hypot(1, design.gradient), across = design.curvature * in_plan;  // of a length
  const Vector3d level(change.cant + across * design.gradient, -change.gradient * in_plan * in_plan, across);
  return Eigen::AngleAxisd(-design.cant, Vector3d::UnitX()) * (in_plan * level);
}

void addTurn(const TrackLine& line, double x, const Sides<PlanePoint>& heads, Sides<RailCourse>& courses)
{
  const Vector3d turn = turnOf(line, x);
  for (const Side side : sides)
  {
    const PlanePoint& head = heads[side];
    RailMotion& motion = courses[side].motion;
    const double sign = sideSign(side), per_x = 1 / (1 - turn.z() * sign * head.y), tilt = sign * turn.x() * per_x;
    for (RailRates* slope : {&courses[side].slope, &motion.slope})
    {
      slope->lateral -= tilt * head.z;
      slope->vertical += tilt * head.y;
      slope->roll -= tilt;
    }
    motion.bend.lateral += sign * turn.z() * per_x;
    motion.bend.vertical -= turn.y() * per_x;
  }
}

TrackPath::TrackPath(std::shared_ptr<const TrackLine> line) : line_(std::move(line))
{
  const double begin = line_->begin();
  nodes_.push_back({begin, {begin, 0, 0}, 0});
  sparse_.push_back(0);
  for (const double end : line_->places())
  {
    for (double x = nodes_.back().x; x < end; x = nodes_.back().x)
    {
      nodes_.push_back(moved(nodes_.back(), std::min(x + longest_piece, end)));
      if (nodes_.back().x >= nodes_[sparse_.back()].x + longest_piece)
      {
        sparse_.push_back(nodes_.size() - 1);
      }
    }
  }
}

/// Moves along a piece on which curvature and gradient are linear. Simpson's rule for the direction.
TrackPath::Node TrackPath::moved(const Node& from, double x) const
{
  TrackDesign change;
  const TrackDesign design = line_->designAt(from.x, &change);
  const double way = x - from.x;
  const auto heading = [&](double t) { return from.heading + t * (design.curvature + 0.5 * t * change.curvature); };
  const auto direction = [&](double t)
  { return Vector3d(std::cos(heading(t)), std::sin(heading(t)), design.gradient + t * change.gradient); };
  const Vector3d path = way / 6 * (direction(0) + 4 * direction(0.5 * way) + direction(way));
  return {x, from.position + path, heading(way)};
}

Eigen::Isometry3d TrackPath::frameAt(double x) const
{
  const auto after = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, x,
                                      [](double place, const Node& node) { return place < node.x; });
  const Node node = moved(*std::prev(after), x);
  const TrackDesign design = line_->designAt(x);
  return Eigen::Translation3d(node.position) * Eigen::AngleAxisd(node.heading, Vector3d::UnitZ()) *
         Eigen::AngleAxisd(-std::atan(design.gradient), Vector3d::UnitY()) *
         Eigen::AngleAxisd(design.cant, Vector3d::UnitX());
}

double TrackPath::placeOf(const Vector3d& point) const
{
  const auto nearer = [&](std::size_t one, std::size_t other)
  { return (nodes_[one].position - point).squaredNorm() < (nodes_[other].position - point).squaredNorm(); };
  double x = nodes_[*std::min_element(sparse_.begin(), sparse_.end(), nearer)].x, step = 1;
  for (int i = 0; i < most_place_steps && std::abs(step) > place_accuracy; ++i)
  {
    const Vector3d local = frameAt(x).inverse() * point;
    step = local.x() / std::max(1 - line_->designAt(x).curvature * local.y(), 0.1);
    x += step;
  }
  return x;
}
}  // namespace wheel_rail_contact::core
