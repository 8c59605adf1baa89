// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "wheel_rail_contact/core/rail_compliance.h"

namespace wheel_rail_contact::core
{
/// Place of both rails at one place of a line, relative to the ideal track: straight, level and of nominal gauge.
struct LineStation
{
  double x = 0;  ///< along the line [m]
  /// Height of the left rail above the right one [m]; positive: the left rail is higher. It tilts the track about its
  /// centre line in the plane of the rail tops, with both rails.
  double cross_level = 0;
  /// Displacement of the rail of each Side in the tilted track.
  std::array<RailDeflection, 2> rail{};
};

/// Track irregularities along a line: gauge, alignment, longitudinal level and cross level, or the displacement of each
/// rail.
///
/// Between its stations, each quantity is a cubic polynomial. Its slopes at the stations are those of Fritsch and
/// Butland (1984): the curve is smooth, passes through all values, and does not overshoot. The rails are taken as
/// straight along x at each place: the slopes of alignment and level are not applied to wheel and rail.
class TrackLine
{
 public:
  /// @param name      name of the line for messages
  /// @param stations  at least two, x strictly increasing, all values finite
  /// @throw std::invalid_argument if they are not, or a cross level or displacement is above 0.2 m or 0.2 rad.
  TrackLine(std::string name, const std::vector<LineStation>& stations);

  /// Name of the line or of its file.
  const std::string& name() const { return name_; }
  double begin() const { return x_.front(); }  ///< x of the first station [m]
  double end() const { return x_.back(); }     ///< x of the last station [m]
  /// True if x [m] is between the first and the last station, or one of them.
  bool contains(double x) const { return x >= begin() && x <= end(); }
  /// Place of the rails at x [m], which must be on the line.
  LineStation at(double x) const;

 private:
  static constexpr std::size_t quantities = 7;  ///< cross level, and three displacements of each rail
  using Quantities = std::array<double, quantities>;

  static Quantities quantitiesOf(const LineStation& station);

  std::string name_;
  std::vector<double> x_;                    ///< [m]
  std::vector<Quantities> values_, slopes_;  ///< at each station, and their slopes along x
};

/// Axes of the values in a file.
enum class LineAxes
{
  rep103,  ///< y left, z up
  railway  ///< y right, z down, as in EN 13848-1
};

/// Reads a line from a table (CSV with comma, semicolon or tab). Lines that begin with # are comments. The first line
/// contains names and units of the columns, for example `x [m], gauge [mm], cross_level [mm]`. Units: m, mm, um, rad,
/// mrad, deg.
///
/// * `x`: along the line; required, increasing.
/// * After EN 13848-1:2019: `gauge` (whole distance of the gauge faces, at TrackConfig::gauge_depth); `alignment_left`,
///   `alignment_right` (lateral position of each gauge face), or `alignment` of the track centre; `level_left`,
///   `level_right` (height of each rail top), or `level` of the track centre; `cross_level` (left rail higher:
///   positive, in both kinds of axes). A quantity that is not given is that of the ideal track, or follows from the
///   others. Where gauge and both alignments are given, the alignment of the track centre is their mean, and the gauge
///   is that of the column; the same for cross level and both levels.
/// * Or the displacement of each rail at the reference point of its head, as in RailDeflection: `rail_lateral_left`
///   (outward), `rail_vertical_left`, `rail_roll_left`, and the same with `right`. They must not be mixed with the
///   columns of EN 13848-1.
///
/// @param gauge  nominal gauge, TrackConfig::gauge [m]
/// @throw std::invalid_argument with the file, the line and the reason.
TrackLine readTrackLine(const std::string& path, double gauge, LineAxes axes = LineAxes::rep103);
}  // namespace wheel_rail_contact::core
