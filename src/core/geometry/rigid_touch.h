// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/track/contact_search.h"
#include "core/track/placement.h"
#include "wheel_rail_contact/core/contact_geometry.h"

namespace wheel_rail_contact::core
{
/// Touch of one rigid wheel on its rail at rest.
class WheelTouch
{
 public:
  /// Keeps a reference to `config`, which must outlive the object.
  /// @param distance  place on the line, for rails with sections [m]
  /// @throw std::invalid_argument if the rail has several parts there, or its sections do not contain this place.
  WheelTouch(const ContactModelConfig& config, Side side, double distance);

  /// Finds the touch at y [m] and roll [rad] of the axle, track axes.
  GeometryStatus find(double y, double roll);
  /// Height of the axle centre in the touch that was found [m].
  double height() const { return -touch_.separation; }
  /// True if points of the wheel or the rail are missing at the touch that was found.
  bool isOnMissingPoints() const;
  /// Point of the touch that was found.
  TouchPoint point() const;

 private:
  bool isAtEnd() const;

  const Profile& wheel_;
  const WheelsetConfig& wheelset_;
  Side side_;
  PlacedRail rail_;
  ContactSearch search_;
  InitialContact touch_;
};

/// Touch of both rigid wheels.
class WheelsetTouch
{
 public:
  /// As WheelTouch.
  WheelsetTouch(const ContactModelConfig& config, double distance);

  /// Contact geometry at y [m].
  /// @param roll  as in ContactGeometryOptions
  GeometryPoint at(double y, bool roll);

 private:
  GeometryStatus find(double y, double roll);
  double heightDifference() const { return wheels_.left.height() - wheels_.right.height(); }
  GeometryStatus findRoll(double y, double& roll);

  struct Wheels
  {
    WheelTouch left, right;
  };
  Wheels wheels_;
  double base_;  ///< distance of the running circles [m]
};
}  // namespace wheel_rail_contact::core
