// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/track/outline.h"
#include "core/track/placement.h"

namespace wheel_rail_contact::core
{
/// A place where the wheel comes nearest to the rail: the outlines are parallel there.
struct InitialContact
{
  double y = 0;           ///< side axes [m]
  double separation = 0;  ///< vertical distance of wheel above rail [m], negative: overlap
  double slope = 0;       ///< common slope dz/dy of the outlines [-]
  double curvature = 0;   ///< d²(separation)/dy² [1/m], positive at a minimum
  double wheel_u = 0;     ///< parameter of the wheel's profile [m]
  double rail_u = 0;      ///< parameter of the rail's profile [m]
};

/// A stretch across the track in which the separation is below a given value.
struct OverlapInterval
{
  double u_begin = 0;                                         ///< parameter of the rail's profile [m]
  double u_end = 0;                                           ///< [m]
  InitialContact contact;                                     ///< its deepest place
  bool at_profile_end = false;                                ///< the stretch is cut off by the end of a profile
  double u_least = -std::numeric_limits<double>::infinity();  ///< beyond these is the neighbouring stretch's side [m]
  double u_most = std::numeric_limits<double>::infinity();    ///< likewise [m]
};

/// A place across the track where the separation is below a given value.
struct Station
{
  double wheel_u;  ///< parameter of the wheel's profile [m]
  double rail_u;   ///< parameter of the rail's profile [m]
  double y, z;     ///< of the rail's outline, side axes [m]
  double slope;    ///< dz/dy of the rail's outline there [-]
  double depth;    ///< that value less the vertical distance of the outlines [m], > 0
};

/// Search for contact between a placed wheel and a placed rail. Own algorithm:
///
/// Both outlines (the wheel's contact locus projected along x, and the rail's profile) are written as heights over the
/// same equidistant stations: the lower envelope of the wheel, the upper envelope of the rail. Writing them segment by
/// segment needs no ordering of the curves, so folds of the locus at large yaw do no harm, and every place of contact
/// is seen at once. Their difference is the separation; its minima are then made exact on the profiles themselves, at
/// the change of sign of the difference of slopes.
class ContactSearch
{
 public:
  /// Samples the profiles; keeps no reference to them.
  ContactSearch(const Profile& wheel, const Profile& rail);

  /// Takes over a new place of the rail.
  void setRail(const PlacedRail& rail);
  /// Takes over a new place of the wheel, and finds the separation at all stations. Call setRail() first.
  void setWheel(const PlacedWheel& wheel);

  /// The nearest place of all. @return false if wheel and rail share no station: the wheel is beside the rail.
  bool nearest(InitialContact& contact);

  /// The stretch around a contact (as nearest() gave it) in which the separation is below `separation` [m].
  OverlapInterval intervalAround(const InitialContact& contact, double separation) const;

  /// All stretches in which the separation is below `separation` [m], from the gauge side on. Neighbours whose distance
  /// is less than the wider one's width and whose planes differ by less than `merge_angle` count as one.
  void overlapIntervals(double separation, std::vector<OverlapInterval>& intervals) const;

  /// Largest angle between the planes of two stretches that count as one [rad].
  static constexpr double merge_angle = 0.1;
  /// Angle between two minima from which on a stretch that holds both is divided where the separation between them is
  /// greatest [rad].
  static constexpr double split_angle = 1.0;

  /// Adds the stations between two parameters of the rail's profile (neither of them included) at which the separation
  /// is below `separation` [m], from the gauge side on.
  void addStationsBetween(double u_begin, double u_end, double separation, std::vector<Station>& stations) const;

 private:
  static constexpr double spacing = 2.5e-4;  ///< of stations, and of samples on the profiles [m]
  /// Greatest error of the separation at stations from straight segments on radii of 10 mm: 2 * spacing² / (8 * 10 mm).
  static constexpr double station_error = 2 * spacing * spacing / (8 * 0.010);

  static constexpr std::size_t no_station = std::numeric_limits<std::size_t>::max();

  void findMinima();
  double depthBelowStation(std::size_t k) const;
  double railAngle(std::size_t k) const;
  double railSlope(std::size_t k) const;
  void addIntervals(std::size_t first, std::size_t last, double separation,
                    std::vector<OverlapInterval>& intervals) const;
  std::size_t lowestStation(std::size_t first, std::size_t behind) const;
  std::pair<std::size_t, std::size_t> belowAround(std::size_t k, double separation) const;
  std::pair<std::size_t, std::size_t> pointsOverRail(const PlacedWheel& wheel) const;
  std::pair<std::size_t, std::size_t> stationsOfRail(double u_begin, double u_end) const;
  InitialContact refined(std::size_t k) const;
  bool settles(std::size_t k, InitialContact& contact) const;
  bool isNear(const InitialContact& contact, std::size_t k) const;
  bool exact(double rail_u, InitialContact& contact, double& slope_difference) const;
  bool wheelAt(double y, double& u, CurvePoint& point, SpacePoint& locus) const;
  OverlapInterval intervalBetween(std::size_t first, std::size_t last, double separation) const;
  static bool narrow(double separation, OverlapInterval& interval);
  void mergeNeighbours(std::vector<OverlapInterval>& intervals) const;
  static void keepApart(std::vector<OverlapInterval>& intervals);

  static std::vector<double> sample(const Profile& profile);

  WheelPoints wheel_points_;
  std::vector<double> group_begin_, group_end_;  ///< least and largest y of WheelPoints::together points and the next
  std::vector<CurvePoint> rail_points_;
  OutlinePoints wheel_line_, rail_line_;  ///< those points where they have been placed
  Stations stations_;
  Outline wheel_outline_{Outline::Envelope::lower};
  Outline rail_outline_{Outline::Envelope::upper};
  std::vector<double> separation_;
  std::vector<std::size_t> minima_;           ///< stations where the separation is lowest, in their order
  std::size_t nearest_station_ = no_station;  ///< whose contact is known
  InitialContact nearest_;                    ///< its contact
  std::optional<PlacedRail> rail_;
  std::optional<PlacedWheel> wheel_;
};
}  // namespace wheel_rail_contact::core
