// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace wheel_rail_contact::core
{
/// Point of a profile curve, with its derivatives with respect to the parameter u of the curve [m].
///
/// Profile frame, the same for wheels and rails and on both sides of the track: y to the field side, z up.
struct CurvePoint
{
  double y;    ///< [m], positive to the field side
  double z;    ///< [m], positive up
  double dy;   ///< dy/du [-]
  double dz;   ///< dz/du [-]
  double ddy;  ///< d²y/du² [1/m]
  double ddz;  ///< d²z/du² [1/m]

  /// Slope dz/dy [-]; infinite where the tangent is vertical.
  double slope() const { return dz / dy; }
  /// Signed curvature [1/m], positive where the curve bends up (towards +z) for growing y.
  double curvature() const;
};

/// Point of a profile curve with all derivatives up to the third: a Taylor expansion of the curve about the point.
struct CurveExpansion
{
  CurvePoint point;  ///< point with its first and second derivatives
  double dddy;       ///< d³y/du³ [1/m²]
  double dddz;       ///< d³z/du³ [1/m²]
};

/// Straight section. The local parameter t is the length along it.
struct LineSection
{
  double y0, z0;  ///< start [m]
  double dy, dz;  ///< direction, a unit vector [-]
};

/// Circular arc. The local parameter t is the arc length.
struct ArcSection
{
  double yc, zc;  ///< centre [m]
  double radius;  ///< [m], > 0
  double angle;   ///< polar angle of the start, seen from the centre, from +y towards +z [rad]
  double turn;    ///< +1: from +y towards +z (counter-clockwise with y to the right and z up); -1: clockwise
};

/// Section with z as a polynomial of y. The local parameter is t = y - y0.
struct PolynomialSection
{
  static constexpr std::size_t max_coefficients = 9;  ///< largest number of coefficients
  double y0;                                          ///< y at the start of the section [m]
  double coefficient[max_coefficients];               ///< z = sum coefficient[k] (y0 + t)^k, [m^(1-k)]
  std::size_t count;                                  ///< number of coefficients used
};

/// Section with both coordinates as cubic polynomials of the local parameter t (part of a spline).
struct CubicSection
{
  double y[4];  ///< y = sum y[k] t^k [m^(1-k)]
  double z[4];  ///< z = sum z[k] t^k [m^(1-k)]
};

/// Curve of a section as a function of its local parameter t [m].
using SectionLaw = std::variant<LineSection, ArcSection, PolynomialSection, CubicSection>;

/// What the points of a file leave open about the shape of a profile. All zero for an exact shape.
struct ShapeError
{
  double position = 0;   ///< standard deviation across the curve [m]
  double curvature = 0;  ///< standard deviation of the curvature [1/m]
  bool missing = false;  ///< true: points are missing here, and the shape is not known
};

/// Section of a profile.
struct ProfileSection
{
  SectionLaw law;      ///< curve
  double length;       ///< range of the local parameter: t in [0, length] [m], > 0
  ShapeError error{};  ///< what is not known of the curve
};

/// Range of the parameter u of a part of a profile [m].
struct ParameterRange
{
  double begin;       ///< first parameter [m]
  double end;         ///< last parameter [m]
  double origin = 0;  ///< parameter of the point that is nearest to the origin of the profile [m]
};

/// Wheel or rail profile: a plane curve of consecutive sections, from the gauge (flange) side to the field side. A rail
/// may have several separate parts, such as a running rail and a check rail; each is such a curve.
///
/// The origin is the running circle of a wheel or the crown (top of the upright rail) of a rail. The parameter u of the
/// curve is the sum of the lengths of all preceding sections plus the local parameter of the section. Each section is
/// evaluated exactly, without resampling. At the boundary of two sections, the second one is used.
///
/// Standard profiles, and profiles from files: profile_reader.h.
class Profile
{
 public:
  /// @param name      name of the profile, see name()
  /// @param sections  in order from the gauge side to the field side
  /// @throw std::invalid_argument if there is no section, a length is not positive and finite, a radius is not
  /// positive, or a polynomial has too many coefficients.
  Profile(std::string name, const std::vector<ProfileSection>& sections);

  /// Distance of the parameter u from the end of a part to the beginning of the next one [m]. No contact is as wide.
  static constexpr double part_distance = 0.1;

  /// Name of the standard profile or of the file.
  const std::string& name() const { return name_; }
  /// Largest value of the parameter u [m]; the smallest is 0.
  double length() const { return start_.back(); }
  /// Point and derivatives at the parameter u [m]. Outside [0, length()] the first or last section is continued.
  CurvePoint at(double u) const;
  /// Length of the tangent at the parameter u: arc length per u [-].
  double speedAt(double u) const;
  /// Ranges of u of the separate parts, in increasing order.
  const std::vector<ParameterRange>& parts() const { return parts_; }
  /// Range of u of the part that is nearest to u [m].
  ParameterRange partAt(double u) const;
  /// What is not known of the shape at the parameter u [m].
  const ShapeError& errorAt(double u) const { return error_[sectionAt(u)]; }
  /// What is not known of the shape in a range of u: the largest values in it [m].
  ShapeError errorWithin(double u_first, double u_last) const;
  /// Parameters u of all section boundaries, including both ends of the profile [m]. Curvature, and with rounded
  /// standards also position, may be discontinuous there.
  const std::vector<double>& discontinuities() const { return start_; }
  /// Section between discontinuities() `index` and `index` + 1.
  ProfileSection section(std::size_t index) const;

 protected:
  /// Profile without sections. A derived class adds them, part by part, and calls makeBuckets() and then findOrigins().
  explicit Profile(std::string name) : name_(std::move(name)) { clear(); }
  /// Removes all sections, but keeps their memory.
  void clear();
  /// Begins the next part. A section of length part_distance between it and the part before is a straight continuation.
  void beginPart();
  /// Adds a section to the part.
  void add(const ProfileSection& section);
  /// Replaces the curve of a section. Call findOrigins() after the last one.
  void setLaw(std::size_t section, const SectionLaw& law) { law_[section] = law; }
  /// Makes a section the straight continuation of the one before.
  void setContinuation(std::size_t section);
  /// Prepares the look-up of sections by their parameter.
  void makeBuckets();
  /// Finds ParameterRange::origin of each part.
  void findOrigins();

 private:
  friend class ProfileCursor;

  std::size_t sectionAt(double u) const;

  std::string name_;
  std::vector<SectionLaw> law_;
  std::vector<ShapeError> error_;  ///< of each section
  std::vector<double> start_;      ///< section boundaries: law_.size() + 1 values of u [m]
  std::vector<ParameterRange> parts_;
  std::vector<std::size_t> bucket_;  ///< section at each boundary of equal buckets over the length, for fast look-up
  double buckets_per_metre_;         ///< [1/m]
};

/// Evaluates a profile at a series of neighbouring positions. It is fast because it first tries the section of the
/// previous position.
class ProfileCursor
{
 public:
  /// Keeps a reference to `profile`, which must outlive the cursor.
  explicit ProfileCursor(const Profile& profile) : profile_(&profile) {}

  /// Point at the parameter u [m], identical to Profile::at().
  CurvePoint at(double u);
  /// The same point with third derivatives.
  CurveExpansion expansionAt(double u);
  /// Distance in u of the last evaluated position from the nearest boundary of two sections [m]. The ends of the
  /// profile do not count; infinite if there is only one section.
  double reach() const { return reach_; }

 private:
  double offsetOf(double u);
  void moveTo(double u);

  const Profile* profile_;
  std::size_t section_ = 0;
  double begin_ = 0, end_ = 0;  ///< range [begin_, end_) of u on section_ [m]; empty before the first evaluation
  double reach_ = 0;
};

class SectionBlend;

/// Section of a rail at a place of the line.
struct RailSection
{
  double x = 0;                            ///< along the line, see WheelsetState::distance [m]
  std::shared_ptr<const Profile> profile;  ///< of one part, upright; must not be null
  /// Places that correspond to those of the same index in the other sections of the series: parameters u of the
  /// profile [m], increasing; NaN where the section has no such place. Empty: they are found from the shape of the
  /// heads (doc/line.md).
  std::vector<double> places;
};

/// Sections of one part of a rail, x strictly increasing. A part with one section is the same everywhere.
using RailSeries = std::vector<RailSection>;

/// Rail whose profile changes along the line: a switch, a crossing, a worn rail; or a rail of several separate parts,
/// such as stock rail and blade, wing rail and nose, running rail and check rail.
///
/// Between two sections, the profile is the mean, weighted by distance, of points that correspond: points at the same
/// share of the arc length between two corresponding places (doc/line.md). At each place the rail is taken as a prism
/// along x: the slope of its surface along x is not part of the contact search.
class RailSections
{
 public:
  /// Where the sections lie across the track.
  enum class Placement
  {
    gauge,       ///< each section of the first part has its top at z = 0 and its gauge face at half the gauge
    coordinates  ///< only the first section of the first part; the others keep their coordinates relative to it
  };

  /// @param parts  series of the running rail, then those of further parts. All parts share the coordinates of the
  ///               files; a further part exists only from its first to its last section.
  /// @throw std::invalid_argument if there is no part or section, a profile is null or has several parts, x does not
  ///        increase, or two sections have no corresponding places.
  RailSections(std::vector<RailSeries> parts, Placement placement);

  /// Where the sections lie across the track.
  Placement placement() const { return placement_; }
  /// Series of the running rail, then those of further parts.
  const std::vector<RailSeries>& parts() const { return parts_; }
  /// True if the running rail has a section at x [m], or sections before and after it.
  bool contains(double x) const;
  /// Curves between the sections `index` and `index` + 1 of a part; null if both are the same profile.
  const SectionBlend* between(std::size_t part, std::size_t index) const { return blends_[part][index].get(); }

 private:
  void checkPlacement() const;

  std::vector<RailSeries> parts_;
  Placement placement_;
  std::vector<std::vector<std::shared_ptr<const SectionBlend>>> blends_;
};
}  // namespace wheel_rail_contact::core
