// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include "wheel_rail_contact/core/profile.h"
#include "wheel_rail_contact/core/rail_sections.h"

namespace wheel_rail_contact::core
{
/// Kind of a profile. It determines the origin.
enum class ProfileKind
{
  wheel,        ///< origin on the running circle
  rail,         ///< origin on the crown
  rail_section  ///< section of a switch or crossing, or of a check rail: origin and shape are free
};

/// Profile file that cannot be used. what() is "file:line: reason", or "file: reason" if the file as a whole is wrong.
class ProfileError : public std::runtime_error
{
 public:
  /// @param line   number of the line, from 1; 0 for the file as a whole
  /// @param reason the broken rule
  ProfileError(const std::string& file, std::size_t line, const std::string& reason);

  /// Path of the file.
  const std::string& file() const { return file_; }
  /// Number of the line, from 1; 0 for the file as a whole.
  std::size_t line() const { return line_; }
  /// The broken rule.
  const std::string& reason() const { return reason_; }

 private:
  std::string file_;
  std::size_t line_;
  std::string reason_;
};

/// Standard deviation of MiniProf measurements across the curve that is assumed unless another one is given [m].
constexpr double miniprof_noise = 5e-6;

/// How the points of a file are read.
struct ProfileReading
{
  /// Expected standard deviation of the points across the curve [m], 0 to 1e-4. Default: approx.smooth for Simpack,
  /// miniprof_noise for MiniProf, 0 for CSV.
  std::optional<double> noise = std::nullopt;
  /// True: y of the points, as described for the format in readProfile(), changes its sign. For a file of the other
  /// side, or of a rail of the right side as it lies in the track with y to the left.
  bool mirror = false;
};

/// Returns a standard profile by its name, or a profile from a file by its path.
///
/// Names: standardProfileNames(), in standard_profiles.h. Any other text is the path of a file for readProfile();
/// `reading` applies to files.
/// @throw std::invalid_argument if the named standard profile is of the other kind, or is to be mirrored.
/// @throw ProfileError in the cases of readProfile().
Profile loadProfile(const std::string& name_or_path, ProfileKind kind, const ProfileReading& reading = {});

/// Reads a profile from a file. The extension of its name (upper or lower case) determines the format:
///
/// * **Simpack** `.prw` (wheel), `.prr` (rail). After the edits that are stated in the file, z points down and y to the
///   field side. The edits are applied in Simpack's own order: 1 point.dist.min; 2 shift; 3 rotate (about x, from y
///   towards z); 4 bound (points outside are omitted; min > max switches it off); 5 mirror; 6 inversion; 7 units. A
///   third column is the weight of the point; points of weight 0 are omitted. The meaning of approx.smooth is not
///   public; it is used as the noise, in the length unit of the file.
/// * **MiniProf** `.whl` (wheel), `.ban` (rail), in mm, as written by MiniProf for Windows: lines key=value, then the
///   columns listed in ColumnDef. Wheel: X from the flange back to the field side, Y towards the flange tip. The
///   running circle, at X = WheelDiameterTaperline (70 mm if not stated), becomes the origin. Rail: X to the gauge
///   side, Y up. Xoffset and Yoffset are added; a Tilt other than 0 is rejected. Points at which the measurement runs
///   back by up to 1 mm are omitted. The directions of the axes are inferred from the measured profiles of worn rails
///   and wheels that come with CONTACT and from the conversion programs of GENSYS, not from a description by the
///   manufacturer.
/// * **CSV** `.csv`: y to the field side, z up. The first line states columns and unit: `y_mm,z_mm` or `y_m,z_m`, with
///   or without a leading #. Other lines that start with # are comments.
///
/// The origin must be the running circle of a wheel or the crown of a rail, within 5 mm in height. A rail may be stored
/// inclined, as it lies in the track; TrackConfig::rail_inclination must then be 0.
///
/// The points may run in either direction. A point less than 0.05 mm from the preceding one is omitted: over this
/// distance the digits of a file do not determine a curvature. With noise, a smoothing spline is fitted to the points;
/// without noise, an interpolating spline passes through all of them.
///
/// @param path     path of the file
/// @param kind     expected kind of the profile
/// @param reading  options
/// @throw ProfileError if the file cannot be read, is truncated, malformed or of the wrong kind, is larger than 4 MiB
/// or has more than 20000 points. Also if it does not contain a plausible profile: fewer than 10 points, points not in
/// order along the curve, a gap of more than 25 mm, a width outside 20 mm to 300 mm, a height above 120 mm, or a shape
/// that is not that of a wheel or rail.
/// @throw std::invalid_argument if the noise is out of range.
Profile readProfile(const std::string& path, ProfileKind kind, const ProfileReading& reading = {});

/// Reads the slices of a rail: a `.slcs` file as used by the reference code CONTACT (Vollebregt), with a list of
/// places and files. % begins a comment. The values are
///
/// * U_OFFSET, which must be 0, and the scale of the places [mm per unit];
/// * the number of slices; the numbers of features, kinks and accelerations; the method of interpolation, which is not
///   used;
/// * a place and the name of a file, in quotes, relative to the slices file, for each slice;
/// * with kinks or accelerations: their part numbers, which are not used;
/// * with features: for each slice its place, and the positions of the features along its curve [mm], negative where it
///   has none. They become RailSection::places.
///
/// A file with an extension of readProfile() is read as described there. Any other file has two columns, y to the field
/// side and z down; they are in metres if the curve is less than 1 wide, else in millimetres.
/// @throw ProfileError with file, line and reason.
RailSeries readRailSlices(const std::string& path, const ProfileReading& reading = {});
}  // namespace wheel_rail_contact::core
