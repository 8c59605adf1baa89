// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/rail_along.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
namespace
{
/// Half the length over which a rail or a rim is compared with its second order along the track: that of a contact and
/// the way by which a slope moves it [m].
constexpr double contact_reach = 5e-3;

constexpr double farthest = 0.03;       ///< of the places at which a rail may touch the wheel [m]
constexpr double scan_step = 2e-3;      ///< of these places [m]
constexpr double smooth_within = 3e-6;  ///< difference of the lift of the wheel from that by the second order [m]
constexpr double edge_accuracy = 1e-6;  ///< of the place at which an edge of a rail or a rim is touched [m]
constexpr double same_place = 3e-4;  ///< of a contact, by the slope of a rim over contact_reach and over half of it [m]
constexpr double least_round = 0.2;  ///< curvature of a rim over that of the circle; below, it ends as a flat does [-]

/// Highest place of a rail for a wheel above it, and whether the second order gives as high a one.
class Highest
{
 public:
  Highest(double radius, const AlongShape& second_order) : radius_(radius), second_order_(second_order) {}

  /// Adds the height at a place, over the rail beneath the axle [m].
  void add(double x, double height)
  {
    const double fall = 0.5 * x * x / radius_;
    smooth_lift_ = std::max(smooth_lift_, second_order_.at(x) - fall);
    if (const double lift = height - fall; lift > lift_)
    {
      x_ = x;
      lift_ = lift;
    }
  }
  /// Adds the heights height(x) beside the highest place, at halved distances.
  template <typename Height>
  void refine(const Height& height)
  {
    for (double step = scan_step; step > edge_accuracy; step *= 0.5)
    {
      const double middle = x_;
      add(middle - step, height(middle - step));
      add(middle + step, height(middle + step));
    }
  }
  double x() const { return x_; }
  double lift() const { return lift_; }
  bool isRough() const { return std::abs(smooth_lift_ - lift_) > smooth_within; }
  /// Replaces the second order by a line that lifts the wheel at this place.
  void place(RailCourse& course) const
  {
    course.smooth = false;
    course.motion.slope.vertical = x_ / radius_;
    course.motion.bend.vertical = 0;
    course.rise = lift_ - 0.5 * x_ * x_ / radius_;
  }

 private:
  double radius_;
  AlongShape second_order_;
  double x_ = 0, lift_ = 0;  ///< without others, the place beneath the axle
  double smooth_lift_ = 0;   ///< by the second order, at the same places [m]
};

/// Mean of two positions of a rail with the same angle; share 0: the first one.
RailFrame between(const RailFrame& one, const RailFrame& other, double share)
{
  RailFrame frame = one;
  frame.y += share * (other.y - one.y);
  frame.z += share * (other.z - one.z);
  return frame;
}
}  // namespace

RailAlong::RailAlong(std::shared_ptr<const Profile> profile, const TrackConfig& track, Side side)
    : rail_(std::move(profile), track, side)
{
}

RailAlong::RailAlong(const RailSections& sections, const TrackConfig& track, Side side)
    : rail_(sections.parts().front().front().profile, track, side)
{
  const RailSeries& running = sections.parts().front();
  frames_.push_back(rail_.frame());
  for (std::size_t i = 1; i < running.size() && sections.placement() == RailSections::Placement::gauge; ++i)
  {
    frames_.push_back(running[i].profile == running[i - 1].profile
                          ? frames_.back()
                          : PlacedRail(running[i].profile, track, side).frame());
  }
  changing_.emplace(sections);
  changing_->reserve();
  changing_->moveTo(running.front().x);
  rail_ = PlacedRail(changing_->profile(), frame());
}

bool RailAlong::moveTo(double x)
{
  if (!changing_ || !changing_->moveTo(x))
  {
    return false;
  }
  rail_ = PlacedRail(changing_->profile(), frame());
  return true;
}

RailFrame RailAlong::frame() const
{
  const std::size_t index = changing_->section();
  return frames_.size() == 1
             ? frames_.front()
             : between(frames_[index], frames_[std::min(index + 1, frames_.size() - 1)], changing_->share());
}

PlacedRail railAt(const RailSections& sections, const TrackConfig& track, Side side, double x)
{
  const RailSeries& running = sections.parts().front();
  ChangingProfile changing(sections);
  changing.moveTo(running.size() == 1 ? x : std::clamp(x, running.front().x, running.back().x));
  const bool by_gauge = sections.placement() == RailSections::Placement::gauge;
  const auto frame = [&](std::size_t i) { return PlacedRail(running[i].profile, track, side).frame(); };
  const std::size_t index = by_gauge ? changing.section() : 0, next = std::min(index + 1, running.size() - 1);
  return {changing.profile(), between(frame(index), frame(by_gauge ? next : 0), changing.share())};
}

Sides<RailDeflection> displacementsAt(const LineStation& station, const Sides<PlanePoint>& at_rest)
{
  const double sine = std::clamp(station.cross_level / (at_rest.left.y + at_rest.right.y), -1.0, 1.0);
  Sides<RailDeflection> displaced;
  for (const Side side : sides)
  {
    const RailDeflection& in_plane = station.rail[side];
    const PlanePoint& rest = at_rest[side];
    const double tilt = sideSign(side) * std::asin(sine);  // raises the rail
    const double y = rest.y + in_plane.lateral, z = rest.z + in_plane.vertical;
    displaced[side] = {std::cos(tilt) * y - std::sin(tilt) * z - rest.y,
                       std::sin(tilt) * y + std::cos(tilt) * z - rest.z, in_plane.roll - tilt};
  }
  return displaced;
}

Sides<RailCourse> coursesAt(const TrackLine& line, double distance, const Sides<PlanePoint>& at_rest,
                            const Sides<double>& radius)
{
  const double half = std::min(contact_reach, 0.5 * (line.end() - line.begin()));
  const double middle = std::clamp(distance, line.begin() + half, line.end() - half), beyond = distance - middle;
  const auto displaced = [&](double x)
  { return displacementsAt(line.at(std::clamp(x, line.begin(), line.end())), at_rest); };
  const Sides<RailDeflection> before = displaced(middle - half), here = displaced(middle),
                              after = displaced(middle + half), at_place = displaced(distance);
  const auto course = [&](Side side)
  {
    const RailDeflection &a = before[side], &b = here[side], &c = after[side];
    const auto bend = [half](double one, double mid, double other) { return (one - 2 * mid + other) / (half * half); };
    const RailRates bends{bend(a.lateral, b.lateral, c.lateral), bend(a.vertical, b.vertical, c.vertical),
                          bend(a.roll, b.roll, c.roll)};
    const auto slope = [&](double one, double other, double turn)
    { return (other - one) / (2 * half) + turn * beyond; };
    const RailRates slopes{slope(a.lateral, c.lateral, bends.lateral), slope(a.vertical, c.vertical, bends.vertical),
                           slope(a.roll, c.roll, bends.roll)};
    return RailCourse{slopes, {slopes, bends}};
  };
  Sides<RailCourse> courses(course);
  const auto highest_of = [&](Side side) {
    return Highest(radius[side], {courses[side].slope.vertical, courses[side].motion.bend.vertical});
  };
  Sides<Highest> highest(highest_of);
  for (double way = -farthest; way < farthest + 0.5 * scan_step; way += scan_step)
  {
    if (distance + way < line.begin() || distance + way > line.end())
    {
      continue;
    }
    const Sides<RailDeflection> there = displaced(distance + way);
    for (const Side side : sides)
    {
      highest[side].add(way, there[side].vertical - at_place[side].vertical);
    }
  }
  for (const Side side : sides)
  {
    if (highest[side].isRough())
    {
      highest[side].refine([&](double way)
                           { return displaced(distance + way)[side].vertical - at_place[side].vertical; });
      highest[side].place(courses[side]);
    }
  }
  return courses;
}

WheelRim rimAt(const OutOfRound& shape, double radius, double pitch)
{
  const auto deviation = [&](double x) { return shape.at(pitch + x / radius, radius); };
  const auto slope = [&](double reach) { return (deviation(reach) - deviation(-reach)) / (2 * reach); };
  const double here = deviation(0), beside = 0.5 * (deviation(-contact_reach) + deviation(contact_reach));
  const double bend = 2 * (beside - here) / (contact_reach * contact_reach);
  WheelRim rim{here, {slope(contact_reach), bend}, true};
  Highest highest(radius, rim.along);
  const auto over_here = [&](double x) { return deviation(x) - here; };
  for (double x = -farthest; x < farthest + 0.5 * scan_step; x += scan_step)
  {
    highest.add(x, over_here(x));
  }
  if (highest.isRough() || 1 - radius * bend < least_round ||
      radius * std::abs(rim.along.slope - slope(0.5 * contact_reach)) > same_place)
  {
    highest.refine(over_here);
    const double height = here + highest.lift(), x = highest.x(), circle = radius + height - 0.5 * x * x / radius;
    rim = {height - 0.5 * x * x / circle, {x / circle, 0}, false};
  }
  return rim;
}

double middleOf(const Sides<RailDeflection>& displaced)
{
  return 0.5 * (displaced.left.lateral - displaced.right.lateral);
}

double tiltOf(const Sides<RailDeflection>& displaced, double half_base)
{
  return std::atan(0.5 * (displaced.left.vertical - displaced.right.vertical) / half_base);
}
}  // namespace wheel_rail_contact::core
