// SPDX-License-Identifier: BSD-3-Clause
#include "profile_check/clean_table.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "core/profile/curve_points.h"
#include "tables/csv.h"

namespace wheel_rail_contact::core::profile_check
{
namespace
{
constexpr double mm = 1e-3;        ///< [m]
constexpr double um = 1e-6;        ///< [m]
constexpr double accuracy = 1e-7;  ///< of a curve that is read again [m]

/// Distances of points along a smoothed curve, of which the first one is used that reproduces it [m].
constexpr double spacings[] = {0.2e-3, 0.1e-3, 0.06e-3};

void write(const std::string& source, const CheckedProfile& checked, const std::vector<ProfilePlace>& points,
           const std::filesystem::path& file)
{
  Csv csv(file);
  csv.line("# " + std::string(checked.kind == ProfileKind::wheel ? "wheel" : "rail") +
           " profile: y to the field side, z up");
  csv.line("# written by check_profile from '" + source + "'");
  csv.line("# which was read as: " + checked.described.report.text);
  if (checked.described.report.smoothing > 0)
  {
    csv.line("# the points are on the smoothed curve: they no longer show the noise of the file");
  }
  csv.line("# with the option smoothing: 0, it is read as exactly this curve");
  csv.line("y_mm,z_mm");
  for (const ProfilePlace& p : points)
  {
    csv.row(p.y / mm, p.z / mm);
  }
}

/// Deviation of the curve that is read from a table [m].
struct Deviation
{
  double as_default;         ///< without options
  double without_smoothing;  ///< with smoothing: 0
};

/// Largest distance of the curve that is read from a table [m].
double deviation(const CheckedProfile& checked, const std::filesystem::path& file, const ProfileReading& reading)
{
  const Profile& first = checked.described.profile;
  const Profile again = readProfile(file.string(), checked.kind, reading);
  return std::max(largestDistance(again, first), largestDistance(first, again));
}

/// Writes the table, and reads it again. @return the deviation of the curve
Deviation written(const std::string& source, const CheckedProfile& checked, const std::vector<ProfilePlace>& points,
                  const std::filesystem::path& file)
{
  write(source, checked, points, file);
  ProfileReading exact;
  exact.smoothing = 0;
  return {deviation(checked, file, {}), deviation(checked, file, exact)};
}

/// The used points of a curve that passes through all of them.
std::vector<ProfilePlace> usedPoints(const DescribedProfile& described)
{
  std::vector<ProfilePlace> points;
  for (const FittedPoint& p : described.points)
  {
    points.push_back({p.y, p.z});
  }
  return points;
}
}  // namespace

std::string writeCleanTable(const std::string& source, const CheckedProfile& checked, const std::filesystem::path& file)
{
  const bool is_exact = checked.described.report.smoothing == 0 && !checked.described.points.empty();
  Deviation least{INFINITY, INFINITY};
  for (const double spacing : spacings)
  {
    const Profile& profile = checked.described.profile;
    least = written(source, checked, is_exact ? usedPoints(checked.described) : pointsAlong(profile, spacing), file);
    if (least.as_default <= accuracy)
    {
      return "";
    }
    if (is_exact)
    {
      break;  // the points of the file do not depend on the spacing
    }
  }
  if (least.without_smoothing <= accuracy)
  {
    return "the curve is rough: read the table with smoothing: 0, otherwise it is smoothed again";
  }
  std::ostringstream reason;
  reason << "no table is written: read again, its curve deviates by " << least.without_smoothing / um
         << " um. Either the rail was shifted so far that its origin is found from its shape, or the curve is rough: a "
            "larger --smoothing makes it smoother";
  throw std::runtime_error(reason.str());
}
}  // namespace wheel_rail_contact::core::profile_check
