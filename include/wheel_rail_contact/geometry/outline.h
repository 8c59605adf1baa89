// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace wheel_rail_contact
{
/// Equidistant places across the track, side axes: y = first + k spacing [m].
struct Stations
{
  double first = 0;       ///< y of the first [m]
  double spacing = 0;     ///< [m], > 0
  std::size_t count = 0;  ///< number of places

  /// Place k, side axes [m].
  double y(std::size_t k) const { return first + static_cast<double>(k) * spacing; }
};

/// Point of an outline.
struct OutlinePoint
{
  double y, z;  ///< side axes [m]
  double u;     ///< parameter of the body's profile [m]
};

/// Outline of a body seen along the track: its lower or upper envelope as heights over stations. It is written segment
/// by segment, in any order; where segments lie over one another the outer one stays.
class Outline
{
 public:
  /// Which of several heights over a station stays.
  enum class Envelope
  {
    lower,  ///< the lowest: a wheel
    upper   ///< the highest: a rail
  };

  /// An outline without segments.
  explicit Outline(Envelope envelope) : sign_(envelope == Envelope::lower ? 1 : -1) {}

  /// Forgets all segments. Allocates only for more stations than before.
  void start(const Stations& stations);
  /// Writes the straight segment between two points.
  void add(const OutlinePoint& a, const OutlinePoint& b);

  /// Height at a station [m]; infinite (up for a lower envelope, down for an upper one) where there is no body.
  double z(std::size_t k) const { return sign_ * height_[k]; }
  /// Profile parameter there [m].
  double u(std::size_t k) const { return u_[k]; }

 private:
  double sign_;
  Stations stations_;
  std::vector<double> height_;  ///< sign * z
  std::vector<double> u_;
};
}  // namespace wheel_rail_contact
