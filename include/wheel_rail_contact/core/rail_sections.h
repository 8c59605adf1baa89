// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact::core
{
class SectionBlend;

/// Section of a rail at a place of the line.
struct RailSection
{
  double x = 0;                            ///< along the line, see WheelsetState::distance [m]
  std::shared_ptr<const Profile> profile;  ///< of one part, upright; must not be null
  /// Places that correspond to those of the same index in the other sections of the series: parameters u of the
  /// profile [m], increasing; NaN where the section has no such place. Empty: they are found from the shape of the
  /// heads (doc/line.md).
  std::vector<double> places;
};

/// Sections of one part of a rail, x strictly increasing. A part with one section is the same everywhere.
using RailSeries = std::vector<RailSection>;

/// Rail whose profile changes along the line: a switch, a crossing, a worn rail; or a rail of several separate parts,
/// such as stock rail and blade, wing rail and nose, running rail and check rail.
///
/// Between two sections, the profile is the mean, weighted by distance, of points that correspond: points at the same
/// share of the arc length between two corresponding places (doc/line.md). At each place the rail is taken as a prism
/// along x: the slope of its surface along x is not part of the contact search.
class RailSections
{
 public:
  /// Where the sections lie across the track.
  enum class Placement
  {
    gauge,       ///< each section of the first part has its top at z = 0 and its gauge face at half the gauge
    coordinates  ///< only the first section of the first part; the others keep their coordinates relative to it
  };

  /// @param parts  series of the running rail, then those of further parts. All parts share the coordinates of the
  ///               files; a further part exists only from its first to its last section.
  /// @throw std::invalid_argument if there is no part or section, a profile is null or has several parts, x does not
  ///        increase, or two sections have no corresponding places.
  RailSections(std::vector<RailSeries> parts, Placement placement);

  /// Where the sections lie across the track.
  Placement placement() const { return placement_; }
  /// Series of the running rail, then those of further parts.
  const std::vector<RailSeries>& parts() const { return parts_; }
  /// True if the running rail has a section at x [m], or sections before and after it.
  bool contains(double x) const;
  /// Curves between the sections `index` and `index` + 1 of a part; null if both are the same profile.
  const SectionBlend* between(std::size_t part, std::size_t index) const { return blends_[part][index].get(); }

 private:
  void checkPlacement() const;

  std::vector<RailSeries> parts_;
  Placement placement_;
  std::vector<std::vector<std::shared_ptr<const SectionBlend>>> blends_;
};
}  // namespace wheel_rail_contact::core
