// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/profile_report.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/profile/profile_order.h"
#include "core/text/table_title.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double micrometre = 1e-6;      ///< [m]
constexpr double least_movement = 1e-9;  ///< shorter ones are rounding [m]
/// Ratio of length and width of a missing range from which it is the side of a head or a wheel, which carries nothing.
constexpr double steep = 3;

std::string micrometres(double length)
{
  std::ostringstream text;
  text << std::setprecision(2) << length / micrometre << " um";
  return text.str();
}
}  // namespace

std::vector<MissingRange> missingRanges(const Profile& profile)
{
  std::vector<MissingRange> ranges;
  const std::vector<double>& places = profile.discontinuities();
  bool missing_before = false;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    const bool missing = profile.errorAt(0.5 * (places[i] + places[i + 1])).missing;
    if (missing && !missing_before)
    {
      ranges.push_back({profile.at(places[i]).y, 0, 0});
    }
    if (missing)
    {
      ranges.back().y_last = profile.at(places[i + 1]).y;
      ranges.back().length += places[i + 1] - places[i];
    }
    missing_before = missing;
  }
  return ranges;
}

std::string reportText(const Profile& profile, const ProfileReport& report)
{
  std::ostringstream text;
  text << report.format << ", " << report.points << " points";
  if (report.omitted > 0)
  {
    text << " (" << report.omitted << " omitted: closer than 0.05 mm, running back, or beside the head)";
  }
  text << ", unit " << nameOfLength(report.unit) << ", y "
       << (report.y == ProfileReading::Y::outward ? "outward" : "inward") << ", z "
       << (report.z == ProfileReading::Z::up ? "up" : "down");
  if (std::hypot(report.moved_y, report.moved_z) > least_movement)
  {
    text << ", moved by " << millimetres(report.moved_y) << " outward and " << millimetres(report.moved_z) << " up";
  }
  text << ", noise " << (report.noise ? micrometres(*report.noise) : "not known (too few points)");
  text << (report.smoothing > 0 ? ", smoothed for " + micrometres(report.smoothing) : ", not smoothed");
  for (const MissingRange& range : missingRanges(profile))
  {
    if (range.length > steep * std::abs(range.y_last - range.y_first))
    {
      continue;
    }
    text << ", points missing over " << millimetres(range.length) << " from y = " << millimetres(range.y_first)
         << " to " << millimetres(range.y_last);
  }
  if (!report.remark.empty())
  {
    text << ", " << report.remark;
  }
  return text.str();
}
}  // namespace wheel_rail_contact::core
