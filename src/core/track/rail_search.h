// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/track/contact_search.h"

namespace wheel_rail_contact::core
{
/// Search for contact between a placed wheel and a placed rail of one or several parts. Results are in side axes.
///
/// The flange back touches the face of a check rail almost along y, where outlines as heights over y are too steep. If
/// the rail has several parts, a second search compares the flange back with all but the first part, in axes turned by
/// 45°: heights along (y + z) / sqrt(2). Its contacts replace those of the first search on surfaces that face the field
/// side and are steeper than 60°.
class RailSearch
{
 public:
  /// @param longest_rail   length of the longest rail profile that setRail() will get [m]
  /// @param several_parts  true: a profile of the rail may have several parts
  RailSearch(const Profile& wheel, const Profile& rail, double longest_rail, bool several_parts);

  /// True for a contact on a surface that faces the field side and is steeper than 60°.
  static bool isSteep(const InitialContact& contact);

  /// As ContactSearch.
  void setRail(const PlacedRail& rail, bool reshaped = false);
  void setWheel(const PlacedWheel& wheel);

  /// Finds the position of the smallest separation.
  bool nearest(InitialContact& contact);
  /// As ContactSearch. The intervals of the second search are those at the height of the wheel, whatever the
  /// separation: the flange back moves along the face of the check rail.
  void overlapIntervals(double separation, std::vector<OverlapInterval>& intervals);
  void stationsOf(const OverlapInterval& interval, const std::vector<std::pair<double, double>>& known,
                  std::vector<OverlapStation>& stations) const;
  void moveEnds(double separation, OverlapInterval& interval) const;

 private:
  InitialContact inSideAxes(const InitialContact& seen) const;

  ContactSearch from_above_;
  std::optional<ContactSearch> turned_;  ///< the second search
  bool uses_turned_ = false;
  std::optional<PlacedRail> rail_;
  std::vector<OverlapInterval> steep_;
};
}  // namespace wheel_rail_contact::core
