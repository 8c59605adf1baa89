// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace wheel_rail_contact::core
{
/// Equidistant positions across the track, in side axes: y = first + k spacing [m].
struct Stations
{
  double first = 0;       ///< y of the first station [m]
  double spacing = 0;     ///< [m], > 0
  std::size_t count = 0;  ///< number of stations

  /// y of station k, in side axes [m].
  double y(std::size_t k) const { return first + static_cast<double>(k) * spacing; }
};

/// Consecutive points of a curve in the y-z plane.
struct OutlinePoints
{
  std::vector<double> y;  ///< outward, side axes [m]; NaN: the curve is interrupted here
  std::vector<double> z;  ///< up [m]
  std::vector<double> u;  ///< parameter of the profile [m]
};

/// Outline of a body seen along the track, as heights at stations. Where parts of its curve are above one another, the
/// outline is their lower or upper envelope.
class Outline
{
 public:
  /// Envelope that the outline keeps.
  enum class Envelope
  {
    lower,  ///< lowest height: for a wheel
    upper   ///< highest height: for a rail
  };

  /// Outline without segments.
  explicit Outline(Envelope envelope) : sign_(envelope == Envelope::lower ? 1 : -1) {}

  /// Takes memory for so many points.
  void reserve(std::size_t points);
  /// Removes all segments. Allocates memory only for more stations than before.
  void start(const Stations& stations);
  /// Adds the straight segments between the points `first_point` to `end_point` (exclusive). Allocates memory only for
  /// more points than before.
  void add(const OutlinePoints& points, std::size_t first_point, std::size_t end_point);

  /// Height at a station [m]. Where there is no body: +infinity for a lower envelope, -infinity for an upper one.
  double z(std::size_t k) const { return sign_ * height_[k]; }
  /// Height above another outline at every station [m]; infinite where one of the bodies is missing. `distance` must
  /// have one element for each station.
  void above(const Outline& other, std::vector<double>& distance) const;
  /// Parameter of the profile at a station [m]; NaN where there is no body.
  double u(std::size_t k) const { return u_[k]; }

 private:
  void measureSegments(const OutlinePoints& points, std::size_t first_point, std::size_t end_point);

  double sign_;
  Stations stations_;
  std::vector<double> height_;  ///< sign * z at each station [m]
  std::vector<double> u_;
  std::vector<double> place_;          ///< position of each point, in units of stations
  std::vector<double> dz_dy_, du_dy_;  ///< derivatives of sign * z and of u with respect to y on each segment [-]
};
}  // namespace wheel_rail_contact::core
