// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace wheel_rail_contact::core
{
/// A point of a profile curve and its derivatives with respect to the curve's parameter u [m].
/// Profile frame, the same for wheel and rail and for both sides of the track: y to the field side, z up, [m].
struct CurvePoint
{
  double y;    ///< [m], positive to the field side
  double z;    ///< [m], positive up
  double dy;   ///< dy/du [-]
  double dz;   ///< dz/du [-]
  double ddy;  ///< d²y/du² [1/m]
  double ddz;  ///< d²z/du² [1/m]

  /// dz/dy [-]; infinite where the tangent is vertical.
  double slope() const { return dz / dy; }
  /// Signed curvature of the curve [1/m], positive where it bends up (towards +z) for growing y.
  double curvature() const;
};

/// A point and the third derivatives: enough to tell the curve close to the point.
struct CurveExpansion
{
  CurvePoint point;  ///< with its first and second derivatives
  double dddy;       ///< d³y/du³ [1/m²]
  double dddz;       ///< d³z/du³ [1/m²]
};

/// Straight piece; the parameter is its length.
struct LineSection
{
  double y0, z0;  ///< start [m]
  double dy, dz;  ///< unit direction [-]
};

/// Circular arc; the parameter is its arc length.
struct ArcSection
{
  double yc, zc;  ///< centre [m]
  double radius;  ///< [m], > 0
  double angle;   ///< polar angle of the start seen from the centre [rad]
  double turn;    ///< +1 counter-clockwise, -1 clockwise (in the y-z plane, z up)
};

/// z as a polynomial of y; the parameter is y - y0.
struct PolynomialSection
{
  static constexpr std::size_t max_coefficients = 9;  ///< largest number of coefficients
  double y0;                                          ///< y at the section's start [m]
  double coefficient[max_coefficients];               ///< z = sum coefficient[k] (y0 + t)^k, [m^(1-k)]
  std::size_t count;                                  ///< used coefficients
};

/// Both coordinates as cubics of the local parameter (a piece of a spline through measured points).
struct CubicSection
{
  double y[4];  ///< y = sum y[k] t^k [m^(1-k)]
  double z[4];  ///< z = sum z[k] t^k [m^(1-k)]
};

/// Point of a section by its local parameter.
using SectionLaw = std::variant<LineSection, ArcSection, PolynomialSection, CubicSection>;

/// One section with the length of its parameter.
struct ProfileSection
{
  SectionLaw law;  ///< the curve
  double length;   ///< range of the local parameter, t in [0, length] [m]
};

/// Wheel or rail profile: a plane curve made of sections, running from the gauge (flange) side to the field side.
///
/// Origin: a wheel's on the running (tape) circle, a rail's on the crown (top of the upright rail). The curve is
/// evaluated exactly on every section (no resampling); at a joint the section after it is taken.
class Profile
{
 public:
  /// @throw std::invalid_argument if there is no section, a section has no (or no finite) length, an arc no radius or
  /// a polynomial too many coefficients.
  Profile(std::string name, const std::vector<ProfileSection>& sections);

  /// Name of a standard profile, or of the file.
  const std::string& name() const { return name_; }
  /// Largest value of the parameter [m]; the smallest is 0.
  double length() const { return start_.back(); }
  /// Point and derivatives at u [m]; outside [0, length()] the end section is continued by its own law.
  CurvePoint at(double u) const;
  /// Values of the parameter at which sections meet, with both ends [m].
  const std::vector<double>& discontinuities() const { return start_; }

 private:
  friend class ProfileCursor;

  std::size_t sectionAt(double u) const;

  std::string name_;
  std::vector<SectionLaw> law_;
  std::vector<double> start_;        ///< law_.size() + 1 joints [m]
  std::vector<std::size_t> bucket_;  ///< section at each border of the equal buckets over the length
  double buckets_per_metre_;         ///< [1/m]
};

/// Reads a profile at places near one another: the section of the last place is tried first.
class ProfileCursor
{
 public:
  /// Refers to `profile`, which must outlive it.
  explicit ProfileCursor(const Profile& profile) : profile_(&profile) {}

  /// The same point as Profile::at().
  CurvePoint at(double u);
  /// The same point, expanded.
  CurveExpansion expansionAt(double u);
  /// How far the place last read lies from the nearest joint [m]; an end of the profile is none.
  double reach() const { return reach_; }

 private:
  double offsetOf(double u);
  void moveTo(double u);

  const Profile* profile_;
  std::size_t section_ = 0;
  double begin_ = 0, end_ = 0;  ///< places on section_, [begin_, end_) [m]; none before the first place is read
  double reach_ = 0;
};
}  // namespace wheel_rail_contact::core
