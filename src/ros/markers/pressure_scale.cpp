// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/pressure_scale.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
constexpr double unit = 1e9;         ///< upper end of the scale, times a power of two [Pa]
constexpr double least_upper = 1e6;  ///< smaller pressures do not make the scale smaller [Pa]
const ros::Duration fall_delay(2);   ///< a lower end must be sufficient for this time

double smallestUpper(double highest)
{
  return unit * std::exp2(std::ceil(std::log2(std::max(highest, least_upper) / unit)));
}
}  // namespace

double PressureScale::update(const ros::Time& stamp, double highest)
{
  if (fixed_ > 0)
  {
    return fixed_;
  }
  if (stamp < last_)
  {
    upper_ = 0;
  }
  last_ = stamp;
  if (highest > 0)
  {
    const double wanted = smallestUpper(highest);
    if (wanted >= upper_ || stamp - needed_ > fall_delay)
    {
      upper_ = wanted;
      needed_ = stamp;
    }
  }
  return upper_ > 0 ? upper_ : unit;
}

double highestPressure(const ContactOutput& output, const std::vector<core::Side>& sides)
{
  double highest = 0;
  if (output.result)
  {
    for (const core::PatchResult& patch : output.result->patches)
    {
      if (std::find(sides.begin(), sides.end(), patch.side) != sides.end())
      {
        const double cells = patch.pressure.size() > 0 ? patch.pressure.maxCoeff() : 0.0;
        highest = std::max({highest, patch.max_pressure, cells});
      }
    }
  }
  return highest;
}
}  // namespace wheel_rail_contact
