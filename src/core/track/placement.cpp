// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/placement.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "core/constants.h"
#include "core/option_check.h"
#include "core/simd/wide.h"
#include "core/track/root_bracket.h"

namespace wheel_rail_contact::core
{
double sideSign(Side side)
{
  return side == Side::left ? 1.0 : -1.0;
}

WheelsetPose toSide(Side side, const WheelsetPose& pose)
{
  const double sign = sideSign(side);
  return {sign * pose.y, pose.z, sign * pose.yaw, sign * pose.roll};
}

namespace
{
/// Spacing of the points at which a rail profile is searched for its highest point and its gauge point [m].
constexpr double scan_spacing = 1e-4;
constexpr int most_steps = 20;              ///< to the opposite point of a wheel
constexpr double longest_step = 5e-3;       ///< a longer one leads to another place of the profile [m]
constexpr double opposite_accuracy = 1e-9;  ///< [m]
constexpr double root_tolerance = 1e-12;    ///< [m]
}  // namespace

PlacedRail::PlacedRail(std::shared_ptr<const Profile> profile, const TrackConfig& track, Side side)
    : profile_(std::move(profile))
{
  turn(track.rail_inclination[side]);
  const int count = std::max(2, static_cast<int>(profile_->length() / scan_spacing));
  const double step = profile_->length() / count;
  const auto height = [this](double u) { return at(u).z; };
  const auto dz_du = [this](double u) { return at(u).dz; };

  int top = 0;
  for (int i = 1; i <= count; ++i)
  {
    if (height(i * step) > height(top * step))
    {
      top = i;
    }
  }
  double u_top = top * step;
  if (top > 0 && top < count && dz_du(u_top - step) > 0 && dz_du(u_top + step) < 0)
  {
    u_top = bracketedRoot(dz_du, u_top - step, dz_du(u_top - step), u_top + step, dz_du(u_top + step), root_tolerance);
  }
  frame_.z = -height(u_top);

  int below = top;
  double y_gauge = infinity;
  for (; below >= 0 && height(below * step) > -track.gauge_depth; --below)
  {
    y_gauge = std::min(y_gauge, at(below * step).y);
  }
  refuseIf(below < 0, "track/gauge_depth = " + std::to_string(track.gauge_depth) +
                          " m: on the gauge side, the rail profile " + profile_->name() +
                          " does not reach that far below its highest point");
  const auto above = [&](double u) { return height(u) + track.gauge_depth; };
  const double low = below * step;
  const double u_gauge = bracketedRoot(above, low, above(low), low + step, above(low + step), root_tolerance);
  y_gauge = std::min(y_gauge, at(u_gauge).y);
  frame_.y = 0.5 * track.gauge - y_gauge;
}

PlacedRail PlacedRail::deflected(const RailDeflection& deflection) const
{
  PlacedRail moved(*this);
  const PlanePoint before = referencePoint();
  moved.turn(angle() - deflection.roll);
  const PlanePoint turned = moved.referencePoint();
  moved.frame_.y += before.y + deflection.lateral - turned.y;
  moved.frame_.z += before.z + deflection.vertical - turned.z;
  return moved;
}

/// A section that moves by m along its tangent shows its own curvature, and one that also turns by w, 2 m w.
AlongShape PlacedRail::along(const CurvePoint& point, const AlongShape& rim) const
{
  const PlanePoint place = this->place(point), head = referencePoint();
  const double per_length = 1 / std::sqrt(place.dy * place.dy + place.dz * place.dz), cosine = place.dy * per_length,
               sine = place.dz * per_length;
  const double y = place.y - head.y, z = place.z - head.z;
  const auto lateral = [&](const RailRates& rates) { return rates.lateral + rates.roll * z; };
  const auto vertical = [&](const RailRates& rates) { return rates.vertical - rates.roll * y; };
  const auto normal = [&](const RailRates& rates) { return cosine * vertical(rates) - sine * lateral(rates); };
  const double tangential = cosine * lateral(motion_.slope) + sine * vertical(motion_.slope);
  return {normal(motion_.slope) + cosine * rim.slope,
          normal(motion_.bend) + cosine * rim.curvature +
              tangential * (2 * motion_.slope.roll + tangential * point.curvature())};
}

void PlacedRail::turn(double angle)
{
  frame_.cosine = std::cos(angle);
  frame_.sine = std::sin(angle);
}

PlacedWheel::PlacedWheel(const Profile& profile, const WheelsetConfig& wheelset, Side side, const WheelsetPose& pose,
                         double rise)
    : profile_(&profile), pose_(pose)
{
  // Roll, then yaw, about fixed axes: axle direction = Rz(yaw) Rx(roll) (0, 1, 0).
  const double ax = -std::sin(pose.yaw) * std::cos(pose.roll);
  const double ay = std::cos(pose.yaw) * std::cos(pose.roll);
  const double az = std::sin(pose.roll);
  forward_x_ = std::hypot(ay, az);
  const WheelCoordinate y{pose.y, ay, az / forward_x_, -ax * ay / forward_x_};
  const WheelCoordinate z{pose.z, az, -ay / forward_x_, -ax * az / forward_x_};
  sections_ = {wheelset.rolling_radius[side] + rise, wheelset.halfBase(), ax, 1 / forward_x_, y, z};
}

namespace
{
/// Point of the contact locus on the wheel circle through a profile point. It is at the angle t from the lowest point
/// of the circle, with the radial direction e = cos(t) down + sin(t) forward. The surface normal is e - r' a. Its x
/// component, sin(t) forward_x - r' a_x, vanishes. There is no such point unless |sin(t)| < 1.
struct LocusOnCircle
{
  LocusOnCircle(const WheelSections& s, double y, double z, double slope)
      : along(s.half_base + y),
        radius(s.radius - z),
        sine(slope * (-s.axle_x * s.per_forward_x)),
        cosine(std::sqrt(1 - sine * sine))
  {
  }

  /// y or z of the point [m].
  double at(const WheelCoordinate& c) const
  {
    return c.origin + c.along * along + radius * (cosine * c.down + sine * c.forward);
  }

  double along, radius;  ///< position on the axle and radius of the circle [m]
  double sine, cosine;   ///< of t
};
}  // namespace

bool PlacedWheel::locus(const CurvePoint& p, SpacePoint& out) const
{
  const LocusOnCircle locus(sections_, p.y, p.z, p.slope());
  out = {sections_.axle_x * locus.along + locus.radius * locus.sine * forward_x_, locus.at(sections_.y),
         locus.at(sections_.z)};
  return std::abs(locus.sine) < 1;
}

double PlacedWheel::locusX(const CurvePoint& p) const
{
  const LocusOnCircle locus(sections_, p.y, p.z, p.slope());
  return sections_.axle_x * locus.along + locus.radius * locus.sine * forward_x_;
}

WHEEL_RAIL_CONTACT_WIDE void PlacedWheel::loci(const WheelPoints& points, std::size_t first, std::size_t end, double* y,
                                               double* z) const
{
  // Copies: the compiler would otherwise assume that writing to y and z changes them, and load them again.
  const WheelSections sections = sections_;
  const double *along = points.y.data(), *up = points.z.data(), *slope = points.slope.data();
  for (std::size_t i = first; i < end; ++i)
  {
    const LocusOnCircle locus(sections, along[i], up[i], slope[i]);
    y[i] = std::abs(locus.sine) < 1 ? locus.at(sections.y) : std::numeric_limits<double>::quiet_NaN();
    z[i] = locus.at(sections.z);
  }
}

double PlacedWheel::lateralBound() const
{
  constexpr double highest_flange = 2;  // no wheel circle has more than twice the rolling radius
  return highest_flange * sections_.radius * (std::abs(sections_.y.down) + std::abs(sections_.y.forward));
}

double PlacedWheel::opposite(const PlanePoint& origin, double x, double u) const
{
  PlanePoint point{};
  for (int i = 0; i < most_steps && section(profile().at(u), x, point); ++i)
  {
    const double step = ((origin.y - point.y) * origin.dy + (origin.z - point.z) * origin.dz) /
                        (point.dy * origin.dy + point.dz * origin.dz);
    if (!(std::abs(step) < longest_step))
    {
      break;
    }
    u += step;
    if (std::abs(step) < opposite_accuracy)
    {
      break;
    }
  }
  return u;
}

double overlapAlongNormal(const PlacedWheel& wheel, const PlacedRail& rail, double wheel_u, double rail_u, double reach)
{
  double low = rail_u - reach, high = rail_u + reach, depth = 0, step = reach;
  SpacePoint locus{};
  PlanePoint on_wheel{};
  for (int i = 0; i < most_steps && std::abs(step) > 0.01 * reach && wheel.locus(wheel.profile().at(wheel_u), locus);
       ++i)
  {
    const PlanePoint on_rail = rail.at(rail_u);
    const AlongShape along = rail.along(rail_u);
    const double x = rail.changes() ? wheel.touchAlong(along, wheel.profile().at(wheel_u), locus.x).x : locus.x;
    wheel_u = wheel.opposite(on_rail, x, wheel_u);
    const CurvePoint profile = wheel.profile().at(wheel_u);
    if (!wheel.section(profile, x, on_wheel))
    {
      break;
    }
    const Eigen::Vector2d tangent = Eigen::Vector2d(on_rail.dy, on_rail.dz).normalized();
    const Eigen::Vector2d normal(-tangent.y(), tangent.x()), direction(on_wheel.dy, on_wheel.dz);
    depth = std::max(depth, along.at(x) - normal.dot(Eigen::Vector2d(on_wheel.y - on_rail.y, on_wheel.z - on_rail.z)));
    const double slope = normal.dot(direction) / tangent.dot(direction);
    (slope > 0 ? high : low) = rail_u;
    step = -slope / (profile.curvature() - rail.profile().at(rail_u).curvature());
    step = rail_u + step > low && rail_u + step < high ? step : 0.5 * (low + high) - rail_u;
    rail_u += step;
  }
  return depth;
}
}  // namespace wheel_rail_contact::core
