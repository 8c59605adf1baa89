// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact::core
{
/// Kind of a profile. It determines the origin.
enum class ProfileKind
{
  wheel,        ///< origin on the running circle
  rail,         ///< origin on the crown
  rail_section  ///< section of a switch or crossing, or of a check rail: origin and shape are free
};

/// File that cannot be used. what() is "file:line: reason", or "file: reason" if the file as a whole is wrong.
class FileError : public std::runtime_error
{
 public:
  /// @param line   number of the line, from 1; 0 for the file as a whole
  /// @param reason the broken rule
  FileError(const std::string& file, std::size_t line, const std::string& reason);

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
using ProfileError [[deprecated("use FileError")]] = FileError;  ///< earlier name, for one version

/// How the points of a file are read. Each option states what the content of a file may leave open. The options are
/// applied in this order: unit, y and z, origin, shift, rotate, mirror.
struct ProfileReading
{
  /// Direction of the first coordinate.
  enum class Y
  {
    outward,  ///< to the field side
    inward    ///< to the gauge (flange) side
  };
  /// Direction of the second coordinate.
  enum class Z
  {
    up,
    down
  };
  /// Point of the profile at which the coordinates of the file are zero.
  enum class Origin
  {
    running_circle,  ///< of a wheel
    flange_back,     ///< of a wheel: y = 0 is the flange back, `tape_circle` from the running circle; z = 0 is anywhere
    crown,           ///< of a rail
    gauge_corner,    ///< of a rail: y = 0 is the gauge face; z = 0 is anywhere
    foot             ///< of a rail: y = 0 is the axis of the rail; z = 0 is anywhere, such as foot or centroid
  };

  /// Expected standard deviation of the points across the curve [m], 0 to 1e-4; 0: none. Default: as stated in a
  /// Simpack file (approx.smooth), else estimated from the points.
  std::optional<double> smoothing = std::nullopt;
  /// Length unit of the file [m]. It must not contradict a unit that the file states.
  std::optional<double> unit = std::nullopt;
  std::optional<Y> y = std::nullopt;  ///< default: that of the format
  std::optional<Z> z = std::nullopt;  ///< default: that of the format
  /// Default: the running circle of a wheel, or as the format states. That of a rail is found from its shape.
  std::optional<Origin> origin = std::nullopt;
  double shift_y = 0;  ///< added to y after the origin is placed [m], positive to the field side
  double shift_z = 0;  ///< added to z after the origin is placed [m], positive up
  double rotate = 0;   ///< rotation about the origin, from y (field side) towards z (up) [rad]
  /// True: y changes its sign at the end. For a file of the other side, or of a rail of the right side as it lies in
  /// the track with y to the left.
  bool mirror = false;

  // Dimensions of the vehicle. They are no options of a file.
  /// Distance of the running circle from the flange back, WheelsetConfig::tape_circle [m]. A file that states another
  /// one is refused. Default: that of the file, or 70 mm.
  std::optional<double> tape_circle = std::nullopt;
  double scale = 1;  ///< of a model, modelScale() [-]: its points are read as those of its original
};

/// True if all options of the files are equal.
bool operator==(const ProfileReading& a, const ProfileReading& b);

/// What was understood of a profile file.
struct ProfileReport
{
  std::string format;      ///< "Simpack", "MiniProf" or "table"; empty for a standard profile
  std::size_t points = 0;  ///< number of points used
  /// Number of points omitted: coincident, running back, outside of the head of a rail, or off the curve.
  std::size_t omitted = 0;
  double unit = 0;                                   ///< length unit of the file [m]
  ProfileReading::Y y = ProfileReading::Y::outward;  ///< direction of the first coordinate
  ProfileReading::Z z = ProfileReading::Z::up;       ///< direction of the second coordinate
  double moved_y = 0;                                ///< distance by which the points were moved outward [m]
  double moved_z = 0;                                ///< distance by which the points were moved up [m]
  /// Standard deviation of the points across the curve [m]: estimated from them, or of the rounding of their digits,
  /// the larger of the two; nothing if there are too few points to know it.
  std::optional<double> noise = std::nullopt;
  /// Inclination of the head of a rail, positive if its top leans towards the track centre [rad]; nothing if its sides
  /// do not show it.
  std::optional<double> inclination = std::nullopt;
  double smoothing = 0;  ///< noise for which the profile was smoothed [m]; 0: not smoothed
  std::string remark;    ///< what was ignored; empty if nothing
  std::string text;      ///< all of this in one line
};

/// Point of a file, as it was used for a profile.
struct FittedPoint
{
  double y;  ///< in the profile frame, positive to the field side [m]
  double z;  ///< in the profile frame, positive up [m]
};

/// Profile with what was understood of its file.
struct DescribedProfile
{
  Profile profile;                    ///< curve of the file, or the standard profile
  ProfileReport report;               ///< what was understood
  std::vector<FittedPoint> points{};  ///< used points of the file, in order; none for a standard profile
};

/// Returns a standard profile by its name, or a profile from a file by its path.
///
/// Names: standardProfileNames(). Any other text is the path of a file for readProfile(); `reading` applies to files.
/// @throw std::invalid_argument if the named standard profile is of the other kind, or if `reading` has an option.
/// @throw FileError in the cases of readProfile().
DescribedProfile describedProfile(const std::string& name_or_path, ProfileKind kind,
                                  const ProfileReading& reading = {});
/// The profile of describedProfile().
Profile loadProfile(const std::string& name_or_path, ProfileKind kind, const ProfileReading& reading = {});

/// Reads a profile from a text file. Its content determines the format:
///
/// * **Simpack**, with the lines `header.begin` and `spline.begin`. After the edits that are stated in the file, z
///   points down and y to the field side. The edits are applied in Simpack's own order: 1 point.dist.min; 2 shift; 3
///   rotate (about x, from y towards z); 4 bound (points outside are omitted; min > max switches it off); 5 mirror; 6
///   inversion; 7 units. A third column is the weight of the point; points of weight 0 are omitted. The meaning of
///   approx.smooth is not public; it is used as the smoothing, in the length unit of the file; 0 states none.
/// * **MiniProf**, in mm, as written by MiniProf for Windows: lines key=value, then the columns listed in ColumnDef.
///   Old files begin with `MINIPROF` or `#MINI` and free text. A file without any header is of this format if its name
///   ends with `.whl` or `.ban`. Wheel: X from the flange back to the field side, Y towards the flange tip. The running
///   circle, at X = WheelDiameterTaperline (wheelset/tape_circle if not stated), becomes the origin. Rail: X to the
///   gauge side, Y up. Xoffset and Yoffset are added; a Tilt other than 0 is rejected. The directions of the axes are
///   inferred from the measured profiles of worn rails and wheels that come with CONTACT and from the conversion
///   programs of GENSYS, not from a description by the manufacturer.
/// * **Table**: any other file, with a column y and one of z. Without titles, `reading` must state unit, y and z; the
///   error message lists the values by which the points are a profile.
///
/// doc/profiles.md describes the cells and titles of tables, and what the origin of a wheel and of a rail must be or
/// becomes. Neither is moved for ProfileKind::rail_section. Exponents may begin with D.
///
/// More than 20000 points may be in any order: they are averaged over 0.1 mm along the curve. Others must be in order,
/// in either direction. Points at which a measurement runs back by up to 1 mm (two strokes) are omitted. A point less
/// than 0.05 mm from the preceding one is omitted: over this distance the digits of a file do not determine a
/// curvature. Up to 2 % of the points are omitted if they lie off the curve of their neighbours, alone or in groups of
/// two or three. With smoothing, a smoothing spline is fitted to the points; without, an interpolating spline passes
/// through all of them. Profile::errorAt() gives what the noise leaves open, and where points are missing.
///
/// @param path     path of the file
/// @param kind     expected kind of the profile
/// @param reading  options
/// @throw FileError if the file cannot be read, is truncated, malformed or of the wrong kind, is larger than 4 MiB
/// or has more than 200000 points. Also if it does not contain a plausible profile: fewer than 10 points, points not in
/// order along the curve, a gap of more than 25 mm, a width outside 20 mm to 300 mm, a height above 120 mm, or a shape
/// that is not that of a wheel or rail.
/// @throw std::invalid_argument if an option is out of range.
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
/// Slices are files of readProfile(). In a table without titles, y points to the field side and z down, and the unit is
/// the metre if the curve is less than 1 wide, else the millimetre.
/// @throw FileError with file, line and reason.
RailSeries readRailSlices(const std::string& path, const ProfileReading& reading = {});
/// The same. Adds a line for each file to `notes`: its name and ProfileReport::text.
RailSeries readRailSlices(const std::string& path, const ProfileReading& reading, std::vector<std::string>& notes);

/// Names of the standard profiles of a kind, as loadProfile() takes them. rail_section gives the names of rails.
std::vector<std::string> standardProfileNames(ProfileKind kind);

// Standard profiles. doc/standard_profiles.md gives their dimensions, their sources, and how far these agree.

/// Wheel profile S1002 (EN 13715, UIC 510-2).
///
/// It consists of the eight sections H G F E D C B A of the standard, with the numbers of the standard, from the flange
/// back (y = -70 mm) to y = +60 mm. These numbers are rounded, and the sections therefore meet with steps: 0.118 um at
/// y = -35 mm (between arc D and polynomial C), 0.037 um at -26 mm (between C and B), below 0.1 nm elsewhere. The steps
/// are kept.
Profile s1002Wheel();
/// Wheel profile LMA of Chinese high-speed trains (named in TB/T 449-2016), from the flange back (y = -70 mm) to
/// y = +60 mm. Its arcs meet without a kink; the two cones of the tread meet with one.
Profile lmaWheel();
/// Conical wheel with the flange of EN 13715 (sections H, G, F and E of S1002). It is not a profile of a standard.
///
/// The tread is straight, with this slope, from the root of the flange to y = +60 mm. An arc R13 joins tread and flank
/// without a kink.
/// @param slope  decrease of the radius over the width, to the field side [-], from 0.01 to 0.1: 1/20 and 1/40 for the
/// named profiles cone_1_20 and cone_1_40
/// @throw std::invalid_argument if the slope is out of range.
Profile coneWheel(double slope);

// Upright rail profiles, symmetric about y = 0. In those of EN 13674-1, the centres of the arcs and the other section
// boundaries follow from tangency, and the sides end where the lower corners of the head begin.

/// Rail profile 54E1 (EN 13674-1:2017; earlier UIC 54).
Profile rail54E1();
/// Rail profile 54E3 (EN 13674-1:2017; earlier DIN S 54).
Profile rail54E3();
/// Rail profile 56E1 (EN 13674-1:2017; earlier BS 113 A).
Profile rail56E1();
/// Rail profile 60E1 (EN 13674-1; earlier UIC 60).
Profile rail60E1();
/// Rail profile 60E2 (EN 13674-1:2017).
Profile rail60E2();
/// Rail profile UIC60 as sampled for the Manchester contact benchmark (Shackleton and Iwnicki, 2006).
///
/// Its gauge corner deviates by up to 0.040 mm from rail60E1(). The sampled R13 arcs lie 0.044 um inside the R80 arcs
/// where they meet; this step is kept. The sides end 37.5 mm below the crown.
Profile railUic60Manchester();
}  // namespace wheel_rail_contact::core
