// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/result_text.h"

#include "ros/evaluation/contact_statistics.h"
#include "ros/evaluation/text.h"

namespace wheel_rail_contact
{
namespace
{
std::string railLine(core::Side side, const core::RailDeflection& deflection)
{
  return formatted("%-5s rail %+.2f mm outward, %+.2f mm up, %+.1f mrad", nameOf(side), 1e3 * deflection.lateral,
                   1e3 * deflection.vertical, 1e3 * deflection.roll);
}

std::string patchLine(const core::PatchResult& patch)
{
  constexpr double degree = 3.14159265358979323846 / 180;
  return formatted("%-5s %5.0f MPa %4.0f mm² %6.1f kN %5.1f° ±%.1f %% %s", nameOf(patch.side), patch.max_pressure / 1e6,
                   patch.area * 1e6, patch.normal_force / 1e3, patch.contact_angle / degree, 100 * patch.error_estimate,
                   std::string(patch.method).c_str());
}
}  // namespace

std::vector<std::string> resultLines(const ContactOutput& output, const std::vector<core::Side>& sides)
{
  if (!output.result)
  {
    return {statusName(output.status), output.reason};
  }
  std::vector<std::string> lines;
  if (output.held)
  {
    lines.push_back(std::string(statusName(output.status)) + ", held");
  }
  lines.push_back(formatted("y %+.2f mm, yaw %+.2f mrad", 1e3 * output.pose().y, 1e3 * output.pose().yaw));
  for (const core::Side side : sides)
  {
    lines.push_back(railLine(side, output.result->rail.at(static_cast<std::size_t>(side)).deflection));
    for (const core::PatchResult& patch : output.result->patches)
    {
      if (patch.side == side)
      {
        lines.push_back(patchLine(patch));
      }
    }
  }
  return lines;
}
}  // namespace wheel_rail_contact
