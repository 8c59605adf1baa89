// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace wheel_rail_contact::core
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

/// Points of a line, one after the other.
struct OutlinePoints
{
  std::vector<double> y;  ///< outward, side axes [m]; NaN: the line is broken here
  std::vector<double> z;  ///< up [m]
  std::vector<double> u;  ///< parameter of the body's profile [m]
};

/// Outline of a body seen along the track: its lower or upper envelope as heights over stations. Where parts of its
/// line lie over one another the outer one stays.
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

  /// Forgets all lines. Allocates only for more stations than before.
  void start(const Stations& stations);
  /// Writes the straight segments between points `first_point` to `behind` (not included). Allocates only for more
  /// points than before.
  void add(const OutlinePoints& points, std::size_t first_point, std::size_t behind);

  /// Height at a station [m]; infinite (up for a lower envelope, down for an upper one) where there is no body.
  double z(std::size_t k) const { return sign_ * height_[k]; }
  /// Height over another outline at every station [m], into as many places; infinite where either has no body.
  void above(const Outline& other, std::vector<double>& distance) const;
  /// Profile parameter there [m]; any number where there is no body.
  double u(std::size_t k) const { return u_[k]; }

 private:
  void measureSegments(const OutlinePoints& points, std::size_t first_point, std::size_t behind);

  double sign_;
  Stations stations_;
  std::vector<double> height_;  ///< sign * z
  std::vector<double> u_;
  std::vector<double> place_;         ///< of the points, in stations
  std::vector<double> rise_, shift_;  ///< of the segments: change of sign * z and of u with y [-]
};
}  // namespace wheel_rail_contact::core
