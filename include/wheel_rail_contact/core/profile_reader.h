// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact::core
{
/// Whose profile a file holds.
enum class ProfileKind
{
  wheel,  ///< origin on the running circle
  rail    ///< origin on the crown
};

/// A profile file that cannot be used; what() reads "file:line: reason", or "file: reason" for the file as a whole.
class ProfileError : public std::runtime_error
{
 public:
  /// @param line counted from 1; 0 for the file as a whole.
  ProfileError(const std::string& file, std::size_t line, const std::string& reason);

  /// The file's path.
  const std::string& file() const { return file_; }
  /// Counted from 1; 0 for the file as a whole.
  std::size_t line() const { return line_; }
  /// The rule that is broken.
  const std::string& reason() const { return reason_; }

 private:
  std::string file_;
  std::size_t line_;
  std::string reason_;
};

/// Standard deviation across the curve assumed for MiniProf measurements unless another is given [m].
constexpr double miniprof_noise = 5e-6;

/// A standard profile by name, or a profile from a file by path.
///
/// Names: `S1002` (wheel), `60E1`, `UIC60_manchester` (rails). Anything else is the path of a file for readProfile().
/// @throw std::invalid_argument if the name is that of a profile of the other kind.
/// @throw ProfileError as readProfile() does.
Profile loadProfile(const std::string& name_or_path, ProfileKind kind);

/// Profile from a file; the format follows from the extension (upper or lower case):
///
/// * Simpack `.prw` (wheel), `.prr` (rail): z down, y to the field side after the file's own edits. Their order is the
///   one Simpack numbers: 1 point.dist.min, 2 shift, 3 rotate (about x, from y towards z), 4 bound (points outside are
///   left out; min > max switches it off), 5 mirror, 6 inversion, 7 units. A third column is the point's weight; points
///   of weight 0 are left out. approx.smooth, whose meaning is not public, is taken as the noise in the file's length
///   unit.
/// * MiniProf `.whl`, `.ban` (rail), in mm, as MiniProf for Windows writes them: key=value lines, then columns as
///   ColumnDef says. Wheel: X from the flange back to the field side, Y towards the flange tip; it is moved so that the
///   running circle, at X = WheelDiameterTaperline (70 mm if not stated), becomes the origin. Rail: Y up, X to the
///   gauge side. (These axes are inferred from the measured profiles of worn rails and wheels that come with CONTACT
///   and from the conversion programs of GENSYS, not from a description by the maker.) Xoffset and Yoffset are added; a
///   Tilt other than 0 is refused. Points where the measurement runs back by less than 1 mm are left out.
/// * `.csv`: y to the field side, z up. The first line states columns and unit, `y_mm,z_mm` or `y_m,z_m`, with or
///   without a leading #; further lines that start with # are comments.
///
/// The origin must be the running circle of a wheel, the crown of a rail, within 5 mm in height. A rail may be stored
/// inclined, as it lies in the track; the track's inclination must then be set to zero.
///
/// Points less than 0.05 mm from the one before are left out, since the digits of files do not give a curvature on that
/// length. With noise the points are smoothed (smoothingSpline()), otherwise the profile passes through every one
/// (interpolatingSpline()).
///
/// @param noise expected standard deviation across the curve [m], 0 to max_spline_noise; without it that of the file:
/// approx.smooth for Simpack, miniprof_noise for MiniProf, 0 for CSV.
/// @throw ProfileError if the file cannot be read, is cut off or malformed, of the wrong kind, larger than 4 MiB or
/// 20000 points, or holds no plausible profile: fewer than 10 points, points not in order along the curve, gaps of more
/// than 25 mm, a width outside 20 ... 300 mm, a height above 120 mm, a shape that is no wheel's or rail's.
/// @throw std::invalid_argument if the noise is out of range.
Profile readProfile(const std::string& path, ProfileKind kind, std::optional<double> noise = std::nullopt);
}  // namespace wheel_rail_contact::core
