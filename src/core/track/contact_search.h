// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/constants.h"
#include "core/track/outline.h"
#include "core/track/placement.h"

namespace wheel_rail_contact::core
{
/// Position at which the separation of wheel and rail has a local minimum; their outlines are parallel there.
struct InitialContact
{
  double y = 0;           ///< lateral position, side axes [m]
  double separation = 0;  ///< vertical distance of the wheel above the rail [m]; negative: overlap
  double slope = 0;       ///< common slope dz/dy of the outlines [-]
  double curvature = 0;   ///< d²(separation)/dy² [1/m], positive at a minimum
  double wheel_u = 0;     ///< parameter of the wheel profile [m]
  double rail_u = 0;      ///< parameter of the rail profile [m]
};

/// Axes in which outlines are heights: side axes, turned about x.
struct SearchAxes
{
  double cosine = 1, sine = 0;  ///< of the angle by which the axes are turned, from y towards z

  bool areTurned() const { return sine != 0; }
  /// Converts the coordinates of a vector or point from side axes.
  void turn(double& y, double& z) const
  {
    const double before = y;
    y = cosine * before + sine * z;
    z = cosine * z - sine * before;
  }
};

/// What a search compares, and along which axes.
struct SearchScope
{
  SearchAxes axes;              ///< of all results, stations and separations
  double wheel_end = infinity;  ///< end of the wheel profile that is compared [m]
  std::size_t first_part = 0;   ///< first part of the rail that is compared
};

/// Interval across the track in which the separation is below a given value.
struct OverlapInterval
{
  double u_begin = 0;                  ///< parameter of the rail profile at the end on the gauge side [m]
  double u_end = 0;                    ///< parameter of the rail profile at the end on the field side [m]
  InitialContact contact;              ///< position of the smallest separation in it
  bool has_one_minimum = true;         ///< the separation has one minimum in it
  std::optional<InitialContact> seen;  ///< of the second search in RailSearch: the contact in its axes
};

/// Place in an overlap at which the outlines are compared. Side axes.
struct OverlapStation
{
  double rail_u = 0;    ///< parameter of the rail profile [m]
  double y = 0, z = 0;  ///< point of the rail [m]
  double depth = 0;     ///< overlap along the normal of the rail [m]
};

/// Search for contact between a placed wheel and a placed rail. The algorithm is our own:
///
/// * Both outlines are sampled as heights at the same equidistant stations: the contact locus of the wheel, projected
///   along x, as its lower envelope; the rail profile as its upper envelope.
/// * The outlines are evaluated segment by segment, in any order. Folds of the locus at large yaw therefore need no
///   special case, and all contact positions are found at the same time.
/// * The difference of the heights is the separation. Its minima are refined on the exact profiles: there the
///   difference of the slopes changes its sign.
class ContactSearch
{
 public:
  static constexpr double spacing = 2.5e-4;  ///< distance of the stations, and of the samples on the profiles [m]
  /// Largest error of the separation at stations, by straight segments on radii of 10 mm on both bodies [m].
  static constexpr double station_error = 2 * spacing * spacing / (8 * 0.010);

  /// Samples the profiles. Keeps no reference to them.
  /// @param longest_rail  length of the longest rail profile that setRail() will get [m]
  ContactSearch(const Profile& wheel, const Profile& rail, double longest_rail = 0, const SearchScope& scope = {});

  /// Sets the position of the rail. setWheel() must follow.
  /// @param reshaped  samples its profile, which is another one than before or has another shape
  void setRail(const PlacedRail& rail, bool reshaped = false);
  /// Sets the position of the wheel and computes the separation at all stations. setRail() must have been called.
  void setWheel(const PlacedWheel& wheel);

  /// Finds the position of the smallest separation.
  /// @return false if wheel and rail have no common station: the wheel is beside the rail.
  bool nearest(InitialContact& contact);

  /// Finds all intervals in which the separation is below `separation` [m], from the gauge side to the field side, part
  /// by part.
  void overlapIntervals(double separation, std::vector<OverlapInterval>& intervals) const;
  /// Stations in an interval below the separation 0. Of a series of them in a range of the parameter of the rail
  /// profile that is `known` [m], the first one stands for all.
  void stationsOf(const OverlapInterval& interval, const std::vector<std::pair<double, double>>& known,
                  std::vector<OverlapStation>& stations) const;
  /// Moves the ends of an interval with one minimum to a separation [m] above this minimum.
  void moveEnds(double separation, OverlapInterval& interval) const;

 private:
  static constexpr std::size_t no_station = std::numeric_limits<std::size_t>::max();

  void findMinima();
  void findMinima(std::size_t first, std::size_t last);
  std::size_t nearestStation(double y) const;
  double depthBelowStation(std::size_t k) const;
  bool areOnePart(std::size_t k, std::size_t other) const;
  std::pair<std::size_t, std::size_t> neighbours(std::size_t k) const;
  std::pair<std::size_t, std::size_t> belowAround(std::size_t k, double separation) const;
  std::pair<std::size_t, std::size_t> pointsOverRail(const PlacedWheel& wheel) const;
  InitialContact refined(std::size_t k) const;
  bool findByNewton(std::size_t k, InitialContact& contact) const;
  bool isNear(const InitialContact& contact, std::size_t k) const;
  PlanePoint turned(const PlanePoint& point) const;
  bool exact(double rail_u, InitialContact& contact, double& slope_difference) const;
  AlongShape alongAt(double rail_u) const;
  double liftPerY(const InitialContact& contact, const CurvePoint& wheel, double x0, const AlongTouch& touch) const;
  AlongTouch touchOf(const AlongShape& shape, const CurvePoint& wheel, double x0) const;
  void lowerWheel(std::size_t first, std::size_t end);
  bool wheelAt(double y, double& u, CurvePoint& point, SpacePoint& locus) const;
  void setEnds(std::size_t first, std::size_t last, double separation, OverlapInterval& interval) const;
  static bool widenByCurvature(double separation, OverlapInterval& interval);

  void sampleRail(const Profile& rail);
  static void sample(const ParameterRange& part, std::vector<double>& u);

  WheelPoints wheel_points_;
  /// Smallest and largest y of each group of WheelPoints::together points and the point after it [m].
  std::vector<double> group_begin_, group_end_;
  std::vector<CurvePoint> rail_points_;
  OutlinePoints wheel_line_, rail_line_;  ///< the sampled points in side axes
  std::vector<std::size_t> part_ends_;    ///< end of each part of the rail in its points (exclusive)
  Stations stations_;
  Outline wheel_outline_{Outline::Envelope::lower};
  Outline rail_outline_{Outline::Envelope::upper};
  std::vector<double> separation_;
  std::vector<AlongShape> along_;             ///< of the rail at some stations, as heights; empty for a prism
  std::vector<std::size_t> minima_;           ///< stations of the local minima of the separation, in increasing order
  std::size_t nearest_station_ = no_station;  ///< station of the last result of nearest()
  InitialContact nearest_;                    ///< last result of nearest()
  SearchScope scope_;
  std::optional<PlacedRail> rail_;
  std::optional<PlacedWheel> wheel_;
};
}  // namespace wheel_rail_contact::core
