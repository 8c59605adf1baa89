// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/profile/along/changing_profile.h"
#include "core/track/placement.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// A rail in the ideal track, along the line: the same everywhere, or with sections that change. Side axes.
class RailAlong
{
 public:
  /// Rail with one profile.
  RailAlong(std::shared_ptr<const Profile> profile, const TrackConfig& track, Side side);
  /// Rail with sections. Keeps a reference to them.
  /// @throw std::invalid_argument if a section to be placed by its gauge face does not reach the gauge depth.
  RailAlong(const RailSections& sections, const TrackConfig& track, Side side);

  /// Moves to x [m], which RailSections::contains(). @return true if the profile or its place is another one than
  /// before
  bool moveTo(double x);
  /// Rail at the place of the last moveTo(); at first, at the first section.
  const PlacedRail& rail() const { return rail_; }
  /// Length of the longest profile, over all places [m].
  double longest() const { return changing_ ? changing_->longest() : rail_.profile().length(); }

 private:
  RailFrame frame() const;

  std::optional<ChangingProfile> changing_;
  std::vector<RailFrame> frames_;  ///< of the sections of the running rail; one for all with Placement::coordinates
  PlacedRail rail_;
};

/// Rail with sections at a place of the line [m], or at the nearest one that it contains. For pictures: its profile is
/// made for each call.
PlacedRail railAt(const RailSections& sections, const TrackConfig& track, Side side, double x);

/// Displacement of the rail of each Side at a place of a line, from its place in the ideal track. Side axes.
/// @param at_rest  reference points of the rails in the ideal track, side axes
Sides<RailDeflection> displacementsAt(const LineStation& station, const Sides<PlanePoint>& at_rest);

/// Course of a rail along the track, as a contact sees it. Side axes.
struct RailCourse
{
  RailRates slope;     ///< of the rail at the place
  RailMotion motion;   ///< its displacement about the place, to second order
  double rise = 0;     ///< of this shape over the rail at the place [m]
  bool smooth = true;  ///< false: the second order fails, and the shape is a line at the highest place for the wheel
};

/// Course of the rail of each Side at a place of a line.
/// @param radius  of the wheels [m]
Sides<RailCourse> coursesAt(const TrackLine& line, double distance, const Sides<PlanePoint>& at_rest,
                            const Sides<double>& radius);

/// Rim of a wheel with this rolling radius [m] at a rotation about its axle [rad], WheelsetState::pitch.
WheelRim rimAt(const OutOfRound& shape, double radius, double pitch);

/// Lateral position of the centre between displaced rails, left positive [m].
double middleOf(const Sides<RailDeflection>& displaced);

/// Angle by which displaced rails turn the track, left up positive [rad].
/// @param half_base  half the distance of the running circles [m]
double tiltOf(const Sides<RailDeflection>& displaced, double half_base);
}  // namespace wheel_rail_contact::core
