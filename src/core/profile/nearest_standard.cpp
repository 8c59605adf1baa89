// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/nearest_standard.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/profile/curve_search.h"
#include "core/profile/profile_measures.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double spacing = 0.25e-3;  ///< of the compared points [m]
constexpr double least_share = 0.5;  ///< of the running surface
constexpr int most_steps = 100;
constexpr double accuracy = 1e-10;   ///< of the motion, at which the search ends [m]
constexpr double least_part = 1e-3;  ///< of a step that is tried
constexpr double lever = 0.035;      ///< half the width of a profile: a rotation moves its ends by this much [m/rad]

/// Points of the running surface at which a profile is known.
std::vector<ProfilePlace> comparedPoints(const Profile& profile, ProfileKind kind)
{
  const ParameterRange surface = runningSurface(profile, kind);
  const int count = std::max(1, static_cast<int>((surface.end - surface.begin) / spacing));
  std::vector<ProfilePlace> points;
  for (int i = 0; i <= count; ++i)
  {
    const double u = surface.begin + (surface.end - surface.begin) * i / count;
    if (!profile.errorAt(u).missing)
    {
      const CurvePoint p = profile.at(u);
      points.push_back({p.y, p.z});
    }
  }
  return points;
}

/// Point in the frame of a moved standard profile.
ProfilePlace inFrameOf(const ProfileMotion& motion, const ProfilePlace& p)
{
  const double c = std::cos(motion.rotation), s = std::sin(motion.rotation);
  const double y = p.y - motion.y, z = p.z - motion.z;
  return {c * y + s * z, c * z - s * y};
}

/// Distances of points from a moved standard profile, and their derivatives.
struct Distances
{
  std::vector<double> value;           ///< [m]
  std::vector<Eigen::Vector3d> slope;  ///< by rotation times lever, y and z [-]
  std::vector<double> y;               ///< place of each point [m]
};

Distances distancesOf(const std::vector<ProfilePlace>& points, const Profile& standard, const CurveFeet& feet,
                      const ProfileMotion& motion)
{
  const double c = std::cos(motion.rotation), s = std::sin(motion.rotation);
  Distances distances;
  for (const ProfilePlace& point : points)
  {
    const ProfilePlace p = inFrameOf(motion, point);
    const double u = feet.nearest(p.y, p.z);
    if (feet.isEnd(u))
    {
      continue;
    }
    const CurvePoint foot = standard.at(u);
    const double speed = std::hypot(foot.dy, foot.dz);
    const double ny = -foot.dz / speed, nz = foot.dy / speed;
    distances.value.push_back(distanceAcross(foot, p.y, p.z));
    distances.slope.emplace_back((ny * p.z - nz * p.y) / lever, -ny * c + nz * s, -ny * s - nz * c);
    distances.y.push_back(point.y);
  }
  return distances;
}

/// Step of the motion (rotation times lever, y, z) that makes the linearised distances smallest. Where they do not
/// determine a component, as for a circular arc, the shortest step.
Eigen::Vector3d leastSquaresStep(const Distances& distances, bool rotated)
{
  const auto rows = static_cast<Eigen::Index>(distances.value.size());
  const Eigen::Index first = rotated ? 0 : 1;
  Eigen::MatrixXd slopes(rows, 3 - first);
  Eigen::VectorXd values(rows);
  for (Eigen::Index i = 0; i < rows; ++i)
  {
    slopes.row(i) = distances.slope[static_cast<std::size_t>(i)].tail(3 - first).transpose();
    values(i) = -distances.value[static_cast<std::size_t>(i)];
  }
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  step.tail(3 - first) = slopes.completeOrthogonalDecomposition().solve(values);
  return step;
}

/// Start of the search: the same height at the top of rails and at the running circle of wheels, and the same gauge
/// face.
ProfileMotion startOf(const Profile& profile, ProfileKind kind, const Profile& standard)
{
  if (kind == ProfileKind::wheel)
  {
    return {0, 0, wheelMeasures(profile).running_circle.z - wheelMeasures(standard).running_circle.z};
  }
  const RailMeasures a = railMeasures(profile), b = railMeasures(standard);
  const bool has_gauge = a.gauge_point && b.gauge_point;
  return {0, has_gauge ? a.gauge_point->y - b.gauge_point->y : 0, a.top.z - b.top.z};
}

/// Search of the motion with the smallest distances.
class Fit
{
 public:
  Fit(const std::vector<ProfilePlace>& points, const Profile& standard, const CurveFeet& feet,
      const ProfileMotion& start)
      : points_(points), standard_(standard), feet_(feet), motion_(start), distances_(distancesAt(start))
  {
  }

  /// Steps until the motion stays or no step makes the distances smaller.
  void improve(bool rotated)
  {
    for (int i = 0; i < most_steps && isUsable(distances_); ++i)
    {
      const Eigen::Vector3d step = leastSquaresStep(distances_, rotated);
      if (step.norm() < accuracy || !take(step))
      {
        return;
      }
    }
  }

  StandardFit result() const
  {
    StandardFit fit;
    fit.name = standard_.name();
    fit.motion = motion_;
    fit.rms = std::sqrt(meanSquare(distances_));
    if (!isUsable(distances_))
    {
      return fit;
    }
    fit.share = static_cast<double>(distances_.value.size()) / static_cast<double>(points_.size());
    for (std::size_t i = 0; i < distances_.value.size(); ++i)
    {
      if (std::abs(distances_.value[i]) > std::abs(fit.largest))
      {
        fit.largest = distances_.value[i];
        fit.y = distances_.y[i];
      }
    }
    return fit;
  }

 private:
  Distances distancesAt(const ProfileMotion& motion) const { return distancesOf(points_, standard_, feet_, motion); }

  bool isUsable(const Distances& distances) const
  {
    const auto compared = static_cast<double>(distances.value.size());
    return compared > 0 && compared >= least_share * static_cast<double>(points_.size());
  }

  /// Infinite if too few points could be compared.
  double meanSquare(const Distances& distances) const
  {
    double sum = 0;
    for (const double distance : distances.value)
    {
      sum += distance * distance;
    }
    return isUsable(distances) ? sum / static_cast<double>(distances.value.size())
                               : std::numeric_limits<double>::infinity();
  }

  /// Takes the largest part of a step that makes the distances smaller. The whole step can be too long where they are
  /// large. @return false if there is none
  bool take(const Eigen::Vector3d& step)
  {
    for (double part = 1; part > least_part; part *= 0.5)
    {
      const ProfileMotion motion{motion_.rotation + part * step(0) / lever, motion_.y + part * step(1),
                                 motion_.z + part * step(2)};
      Distances distances = distancesAt(motion);
      if (meanSquare(distances) < meanSquare(distances_))
      {
        motion_ = motion;
        distances_ = std::move(distances);
        return true;
      }
    }
    return false;
  }

  const std::vector<ProfilePlace>& points_;
  const Profile& standard_;
  const CurveFeet& feet_;
  ProfileMotion motion_;
  Distances distances_;
};
}  // namespace

StandardFit standardFit(const Profile& profile, ProfileKind kind, const Profile& standard, bool rotated)
{
  const std::vector<ProfilePlace> points = comparedPoints(profile, kind);
  const CurveFeet feet(standard);
  Fit fit(points, standard, feet, startOf(profile, kind, standard));
  fit.improve(false);
  if (rotated)
  {
    fit.improve(true);
  }
  return fit.result();
}

StandardFit nearestStandard(const Profile& profile, ProfileKind kind)
{
  StandardFit nearest;
  nearest.rms = std::numeric_limits<double>::infinity();
  for (const std::string& name : standardProfileNames(kind))
  {
    const StandardFit fit = standardFit(profile, kind, loadProfile(name, kind), kind != ProfileKind::wheel);
    nearest = fit.rms < nearest.rms ? fit : nearest;
  }
  return nearest;
}
}  // namespace wheel_rail_contact::core
