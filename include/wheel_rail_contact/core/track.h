// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wheel_rail_contact/core/rail_compliance.h"
#include "wheel_rail_contact/core/sides.h"

/// Normal contact of the wheels of a railway wheelset with two rails.
///
/// SI units, angles in radians. Track frame: x forward along the track, y left, z up; the origin is on the centre line,
/// and z = 0 is the plane on the tops of both undeflected rails. "Outward" is the direction from the track centre to
/// the field side of a rail. doc/glossary.md explains all terms.
namespace wheel_rail_contact::core
{
/// Design of a track at one place of a line, or its change per metre. The track frame follows it: x along the tangent
/// of the centre line, turned by gradient and cant.
struct TrackDesign
{
  double curvature = 0;  ///< of the centre line in plan [1/m]; positive: a curve to the left
  double cant = 0;       ///< angle of the cant [rad]; positive: the left rail is higher, as in a curve to the right
  double gradient = 0;   ///< rise per length in plan [-]; positive: uphill
};

/// Place of both rails at one place of a line, relative to the ideal track: that of the design, with nominal gauge.
struct LineStation
{
  double x = 0;  ///< along the line [m]
  /// Height of the left rail above the right one [m]; positive: the left rail is higher. It tilts the track about its
  /// centre line in the plane of the rail tops, with both rails.
  double cross_level = 0;
  /// Displacement of the rail of each Side in the tilted track.
  Sides<RailDeflection> rail{};
  TrackDesign design{};  ///< linear between the stations: a clothoid is given by its ends
};

/// Track irregularities along a line: gauge, alignment, longitudinal level and cross level, or the displacement of each
/// rail; and the design of the track.
///
/// Between its stations, each irregularity is a cubic polynomial. Its slopes at the stations are those of Fritsch and
/// Butland (1984): the curve is smooth, passes through all values, and does not overshoot. The contact sees
/// its slope and curvature along x.
class TrackLine
{
 public:
  /// @param name      name of the line for messages
  /// @param stations  at least two, x strictly increasing, all values finite
  /// @param longest_gap  longest distance of two stations across which the line is known [m]
  /// @param repeats   true: the line repeats without end; the last station is the first one of the next repetition
  /// @throw std::invalid_argument if they are not, a value is above 0.2 (SI units), or the last station of a line that
  /// repeats is not its first one.
  TrackLine(std::string name, const std::vector<LineStation>& stations,
            double longest_gap = std::numeric_limits<double>::infinity(), bool repeats = false);

  /// Name of the line or of its file.
  const std::string& name() const { return name_; }
  double begin() const { return repeats_ ? -endless : x_.front(); }  ///< x of the first station; lowest if it repeats
  double end() const { return repeats_ ? endless : x_.back(); }      ///< x of the last station; largest if it repeats
  /// True if x [m] is a station, or between two that are not farther apart than the longest gap.
  bool contains(double x) const { return x >= begin() && x <= end() && !gapAt(x); }
  double longestGap() const { return longest_gap_; }  ///< [m]
  /// Places between which the line is not known, around x [m], which is from begin() to end(); nothing if it is known.
  std::optional<std::array<double, 2>> gapAt(double x) const;
  /// Place of the rails at x [m], which must be on the line.
  LineStation at(double x) const;
  /// Design at x [m] and its change per metre; beyond the ends as there.
  TrackDesign designAt(double x, TrackDesign* change = nullptr) const;
  const std::vector<double>& places() const { return x_; }  ///< of the stations [m]
  bool hasDesign() const;                                   ///< curvature, cant or gradient at any station

 private:
  /// Cross level, and three displacements of each rail; then the design. In the order of the columns of a file.
  static constexpr std::size_t irregularities = 7, quantities = 10;
  using Quantities = std::array<double, quantities>;

  static constexpr double endless = std::numeric_limits<double>::max();

  static Quantities quantitiesOf(const LineStation& station);
  double withinStations(double x) const;
  std::size_t stationAfter(double x) const;
  TrackDesign designIn(std::size_t i, double place, TrackDesign* change = nullptr) const;
  bool isGap(std::size_t after) const { return x_[after] - x_[after - 1] > longest_gap_; }

  std::string name_;
  double longest_gap_;  ///< [m]
  bool repeats_;
  std::vector<double> x_;                                   ///< [m]
  std::vector<Quantities> values_;                          ///< at each station
  std::vector<std::array<double, irregularities>> slopes_;  ///< along x, there
};

/// Axes of the values in a file.
enum class LineAxes
{
  rep103,  ///< y left, z up
  railway  ///< y right, z down, as in EN 13848-1
};

/// How the table of a line is read.
struct LineReading
{
  LineAxes axes = LineAxes::rep103;  ///< of its values
  /// See TrackLine [m]; 0: three times the median distance of the stations.
  double longest_gap = 0;
  bool repeat = false;  ///< see TrackLine
};

/// What was understood of the table of a line.
struct LineReport
{
  std::string text;                 ///< in one line
  std::vector<std::string> doubts;  ///< questions: contradicting columns, constant stretches, unlikely units
};

/// Reads a line from a table, by the rules for cells, titles and missing values of the command contact_states.
/// doc/line.md describes its columns, their units and signs, and what follows from them.
///
/// @param gauge  nominal gauge, TrackConfig::gauge [m]
/// @param report  receives what was understood
/// @throw std::invalid_argument with the file, the line and the reason; also for steps that no track has.
TrackLine readTrackLine(const std::string& path, double gauge, const LineReading& reading = {},
                        LineReport* report = nullptr);

/// Position and inclination of the undeflected rails.
struct TrackConfig
{
  double gauge = 1.435;        ///< distance between the gauge faces of both rails [m], 0.2 to 3
  double gauge_depth = 0.014;  ///< depth below the tops of the rails at which the gauge is measured [m], 1e-5 to 0.1
  /// Inclination of each rail, top towards the track centre [rad]; at most 0.2. 1:40 is atan(1/40). This is not the
  /// cant (superelevation) of the track.
  Sides<double> rail_inclination = 0.025;
  /// Irregularities along the track, see WheelsetState::distance; null: the ideal track.
  std::shared_ptr<const TrackLine> line{};
};

/// Deviation of the radius of a wheel from its rolling radius, the same in all sections; positive: a larger one. The
/// sum of all parts.
///
/// Its angle is one of the wheel's material about the axle [rad]; it grows forward from the lowest line. The place at
/// an angle is lowest when WheelsetState::pitch is that angle.
struct OutOfRound
{
  /// Place of a table.
  struct Point
  {
    double angle, deviation;  ///< [rad], [m]
  };
  /// amplitude * sin(order * angle + phase)
  struct Harmonic
  {
    int order = 1;                    ///< waves in the circumference, 1 to 100
    double amplitude = 0, phase = 0;  ///< [m], [rad]
  };
  /// Chord of the circle, with sharp edges.
  struct Flat
  {
    double angle = 0, depth = 0;  ///< of its middle [rad], [m]
  };

  std::vector<Point> table;  ///< none, or at least 8; angles increase within one turn. Monotone cubics between them
  std::vector<Harmonic> harmonics;  ///< polygon
  std::vector<Flat> flats;          ///< in any order

  /// Deviation at an angle [rad] on this rolling radius [m].
  double at(double angle, double radius) const;
};

/// Reads OutOfRound::table by the rules of profile files: columns `angle` (rad, mrad, deg) and `deviation` (m, cm, mm,
/// um, in), each with its unit; one turn, of which the last row may repeat the first.
/// @throw FileError with the file, the line and the reason.
std::vector<OutOfRound::Point> readOutOfRound(const std::string& path);

/// Dimensions of the wheelset, and the part of its pose that is solved.
struct WheelsetConfig
{
  Sides<double> rolling_radius = 0.460;  ///< radius of each wheel at its running circle [m], 0.05 to 2
  Sides<std::shared_ptr<const OutOfRound>> out_of_round{};  ///< null: round. Below 1.1 % of the radius
  double flange_back_distance = 1.360;  ///< back-to-back distance: between the backs of both flanges [m], 0.2 to 3
  double tape_circle = 0.070;           ///< distance from the flange back to the running circle [m], 0.005 to 0.5
  /// True: height and roll of the axle are solved from the load. False: they are given in each WheelsetState, and the
  /// forces follow from them.
  bool solve_height_and_roll = true;

  /// Equilibrium that determines height and roll, if they are solved.
  enum class Balance
  {
    wheel_loads,  ///< the wheel loads follow from force_z and torque_x alone, as vertical forces at the running circles
    moments       ///< forces and moments about the axle centre, with the moment of the lateral forces of the contacts
  };
  Balance balance = Balance::wheel_loads;  ///< see WheelsetState::torque_x

  /// Mean radius of both wheels at their running circles [m].
  double meanRadius() const { return 0.5 * (rolling_radius.left + rolling_radius.right); }
  /// Half the distance between the running circles of both wheels [m].
  double halfBase() const { return 0.5 * flange_back_distance + tape_circle; }
};

/// Scale of a model of a vehicle on its track [-]: the larger of rolling radius / 0.46 m and gauge / 1.435 m. 1 if this
/// is above 0.4, because trams and vehicles of narrow gauges have profiles of full size. Limits of lengths scale with
/// it, those of forces with its square.
double modelScale(const TrackConfig& track, const WheelsetConfig& wheelset);

/// Checks that every parameter is within its range.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const TrackConfig& track);
/// Checks that every parameter is within its range.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const WheelsetConfig& wheelset);
/// The same. @param option  name before those of the parameters
void validate(const OutOfRound& wheel, double radius, const std::string& option);
}  // namespace wheel_rail_contact::core
