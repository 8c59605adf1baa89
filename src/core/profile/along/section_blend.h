// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact::core
{
/// Places of two sections of a rail that correspond: their parameters u [m].
struct CorrespondingPlaces
{
  double a, b;
};

/// Corresponding places of two sections, in increasing order; none if no heads correspond.
///
/// A section is divided into heads: hills between valleys at least 3 mm deep. Heads of the two sections that overlap
/// laterally correspond, and so do the places on their sides at the same depth below the top: 14 mm, or as deep as both
/// reach, or less by tenths until both sides are steeper than 45 degrees there. Above them, the ends of the corners
/// correspond, where the sides become flatter than 14 degrees, if both corners are equally long within 10 %. The rule
/// is our own.
std::vector<CorrespondingPlaces> correspondingPlaces(const Profile& a, const Profile& b);

/// Curves between two sections of a rail: the weighted mean of points that correspond.
///
/// Between two corresponding places, the points are at the same share of the arc length; before the first place and
/// after the last one, at the same arc length from it, as far as both sections reach. The map of the parameters is
/// smooth (monotone cubic). The curve consists of cubic sections of about 0.5 mm that share points and tangents with
/// the mean.
class SectionBlend
{
 public:
  /// @param places  at least one, both parameters strictly increasing
  /// @throw std::invalid_argument if there are none, they do not increase, or the sections share less than 10 mm.
  SectionBlend(const Profile& a, const Profile& b, const std::vector<CorrespondingPlaces>& places);

  /// Number of cubic sections.
  std::size_t size() const { return of_a_.size(); }
  /// Length of each section in u [m].
  double length() const { return length_; }
  /// What is not known of a section: the larger values of both rail sections.
  const ShapeError& errorOf(std::size_t section) const { return error_[section]; }
  /// Curve of a section; share 0: first rail section, 1: second one.
  CubicSection at(std::size_t section, double share) const;

 private:
  double length_ = 0;                      ///< of each section [m]
  std::vector<CubicSection> of_a_, of_b_;  ///< the same curves on both sections
  std::vector<ShapeError> error_;          ///< of each section
};
}  // namespace wheel_rail_contact::core
