// SPDX-License-Identifier: BSD-3-Clause
#include "profile_check/text.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/profile/profile_dimensions.h"
#include "core/profile/profile_measures.h"

namespace wheel_rail_contact::core::profile_check
{
namespace
{
constexpr double mm = 1e-3;                 ///< [m]
constexpr double mrad = 1e-3;               ///< [rad]
constexpr double least_inclination = 5e-5;  ///< smaller ones are rounded to 0 [rad]
constexpr double least_slope = 2e-3;        ///< from which an inclination is also written as a slope [rad]

std::string fixed(double value, int decimals)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  const std::string written = text.str();
  // A rounded zero has no sign.
  return written.find_first_not_of("-0.") == std::string::npos && written[0] == '-' ? written.substr(1) : written;
}

/// Length with a fixed number of decimals, as in a table of measures.
std::string fixedMillimetres(double length, int decimals = 2)
{
  return fixed(length / mm, decimals) + " mm";
}

/// Small length with two significant digits; shorter than a nanometre is rounding.
std::string small(double length)
{
  if (length < 1e-9)
  {
    return "0 mm";
  }
  std::ostringstream text;
  text << std::setprecision(2) << length / mm << " mm";
  return text.str();
}

std::string place(const ProfilePlace& p)
{
  return "y = " + fixedMillimetres(p.y) + ", z = " + fixedMillimetres(p.z);
}

std::string measure(const std::string& name, const std::optional<double>& length)
{
  return name + ' ' + (length ? fixedMillimetres(*length) : "not known");
}

/// Angle of a rail, with its slope 1:N and the side to which the top leans.
std::string inclination(double angle)
{
  const double size = std::abs(angle);
  if (size < least_inclination)
  {
    return "0 mrad";
  }
  const std::string slope = size < least_slope ? "" : " (1:" + fixed(1 / std::tan(size), 1) + ')';
  return fixed(size / mrad, 1) + " mrad" + slope + (angle < 0 ? " to the field side" : " towards the track centre");
}

/// Lean of the sides as slopes 1:N, positive if the head widens downwards.
std::string sideLean(double lean)
{
  return (lean < 0 ? "-1:" : "1:") + fixed(1 / std::max(std::tan(std::abs(lean)), 1e-9), 1);
}

std::string widthText(const Profile& profile)
{
  double left = profile.at(0).y, right = left;
  for (const double u : profile.discontinuities())
  {
    left = std::min(left, profile.at(u).y);
    right = std::max(right, profile.at(u).y);
  }
  return "width " + fixedMillimetres(right - left) + ", from y = " + fixedMillimetres(left) + " to " +
         fixedMillimetres(right);
}

std::string wheelText(const Profile& profile)
{
  const WheelMeasures wheel = wheelMeasures(profile);
  return "  flange height Sh " + fixedMillimetres(wheel.flange_height) + ", " +
         measure("flange thickness Sd", wheel.flange_thickness) + ", " + measure("qR", wheel.flange_gradient) +
         " (EN 15313)\n  " + widthText(profile) + '\n';
}

std::string railText(const Profile& profile)
{
  const RailMeasures rail = railMeasures(profile);
  std::string text = "  top at " + place(rail.top) + ", gauge point at " +
                     (rail.gauge_point ? place(*rail.gauge_point) : "a depth that the profile does not reach") + '\n';
  text += "  " + widthText(profile) + ", " +
          measure(fixedMillimetres(gauge_depth, 0) + " below the top", rail.head_width) + '\n';
  if (rail.inclination())
  {
    text += "  sides " + sideLean(*rail.gauge_side_lean) + " (gauge side) and " + sideLean(-*rail.field_side_lean) +
            " (field side): if they are not worn, the head is inclined by " + inclination(*rail.inclination()) + '\n';
  }
  return text;
}

/// What a reversed y of a rail may show. A fit to the mirrored profile would not: all standard rails are symmetric.
std::string directionText(const CheckedProfile& checked)
{
  const bool is_rotated = std::isfinite(checked.nearest.rms) && checked.nearest.motion.rotation < -least_slope;
  return checked.kind != ProfileKind::wheel && is_rotated
             ? "  the head is inclined to the field side, or worn there: if that is its gauge side, y points the other "
               "way (--y, --mirror)\n"
             : "";
}

std::string knowledgeText(const CheckedProfile& checked)
{
  const Profile& profile = checked.described.profile;
  const SurfaceKnowledge known = surfaceKnowledge(profile, runningSurface(profile, checked.kind));
  std::ostringstream text;
  text << std::setprecision(2) << "  running surface: curvature known within " << known.usual_error << " 1/m";
  if (known.curvature_error > known.usual_error)
  {
    text << " over half of it, and " << known.curvature_error << " 1/m at worst (y = " << fixedMillimetres(known.y, 1)
         << ')';
  }
  text << ", points missing over " << fixed(100 * known.missing, 1) << " % of it\n";
  return text.str();
}
}  // namespace

std::string textOf(const StandardFit& nearest)
{
  if (!std::isfinite(nearest.rms))
  {
    return "no standard profile could be compared";
  }
  std::string text = "nearest standard profile: " + nearest.name + ", rms " + small(nearest.rms) + ", largest " +
                     small(std::abs(nearest.largest)) + (nearest.largest < 0 ? " below" : " above") +
                     " it at y = " + fixedMillimetres(nearest.y, 1) + "; moved by " +
                     fixedMillimetres(nearest.motion.y) + " outward and " + fixedMillimetres(nearest.motion.z) + " up";
  if (std::abs(nearest.motion.rotation) > least_inclination)
  {
    text += ", rotated by " + inclination(nearest.motion.rotation);
  }
  return text;
}

std::string textOf(const std::string& file, const CheckedProfile& checked)
{
  const bool is_wheel = checked.kind == ProfileKind::wheel;
  return file + ": " + (is_wheel ? "wheel, " : "rail, ") + checked.known_by + "\n  " + checked.described.report.text +
         '\n' + (is_wheel ? wheelText(checked.described.profile) : railText(checked.described.profile)) +
         knowledgeText(checked) + "  " + textOf(checked.nearest) + '\n' + directionText(checked);
}
}  // namespace wheel_rail_contact::core::profile_check
