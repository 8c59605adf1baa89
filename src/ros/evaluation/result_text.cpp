// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/result_text.h"

#include <sstream>

#include "config/text.h"
#include "core/constants.h"
#include "ros/evaluation/contact_statistics.h"

namespace wheel_rail_contact
{
namespace
{
constexpr std::size_t panel_width = 72;  ///< of wrapped lines [characters]

Tone toneOf(const ContactOutput& output)
{
  if (!output.result || output.held)
  {
    return Tone::error;
  }
  return output.status == WheelsetContact::OK && output.reason.empty() ? Tone::normal : Tone::warning;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width)
{
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    if (lines.empty() || lines.back().size() + 1 + word.size() > width)
    {
      lines.push_back(word);
    }
    else
    {
      lines.back() += ' ' + word;
    }
  }
  return lines;
}

std::string poseLine(const core::WheelsetPose& pose)
{
  return formatted("y %+.2f mm, yaw %+.2f mrad, roll %+.2f mrad", 1e3 * pose.y, 1e3 * pose.yaw, 1e3 * pose.roll);
}

/// Pressure with its own estimated error, which belongs to no other number of the line.
std::string pressureText(const core::PatchResult& patch)
{
  const double percent = 100 * patch.error_estimate;
  return formatted(percent < 0.1 ? "%5.0f MPa ± %.2g %%" : "%5.0f MPa ± %.1f %%", patch.max_pressure / 1e6, percent);
}

std::string railLine(const core::RailDeflection& deflection)
{
  return formatted("  rail moved %+.2f mm outward, %+.2f mm up, %+.1f mrad", 1e3 * deflection.lateral,
                   1e3 * deflection.vertical, 1e3 * deflection.roll);
}

std::string patchLine(const core::PatchResult& patch)
{
  return formatted("  patch %s, %4.0f mm², %6.1f kN at %+.1f°, %s", pressureText(patch).c_str(), patch.area * 1e6,
                   patch.normal_force / 1e3, patch.contact_angle / core::degree, std::string(patch.method).c_str());
}

std::string frictionLine(const core::WheelForces& wheel)
{
  return formatted("  of these by friction: Q %+.1f kN, Y %+.1f kN", wheel.friction_vertical / 1e3,
                   wheel.friction_lateral / 1e3);
}

std::string creepLine(const core::PatchCreep& creep)
{
  return formatted("    %.0f %% of adhesion, creepage %+.2f, %+.2f mm/m, spin %+.2f 1/m, %+.1f, %+.1f kN on the wheel",
                   100 * creep.adhesion_share, 1e3 * creep.creepage.x, 1e3 * creep.creepage.y, creep.creepage.spin,
                   creep.force.x / 1e3, creep.force.y / 1e3);
}

std::string peakText(const core::StressPeak& peak)
{
  return formatted("%.0f MPa %.1f mm deep", peak.value / 1e6, 1e3 * peak.depth);
}

std::string stressLine(const core::PatchResult& patch)
{
  return "    von Mises stress: wheel " + peakText(patch.wheel_stress.von_mises) + ", rail " +
         peakText(patch.rail_stress.von_mises);
}

bool hasStress(const core::PatchResult& patch)
{
  return patch.wheel_stress.von_mises.value > 0 || patch.rail_stress.von_mises.value > 0;
}

bool isDisplaced(const core::RailDeflection& rail)
{
  return rail.lateral != 0 || rail.vertical != 0 || rail.roll != 0;
}

std::vector<const core::PatchResult*> patchesOf(const core::WheelsetResult& result, core::Side side)
{
  std::vector<const core::PatchResult*> patches;
  for (const core::PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      patches.push_back(&patch);
    }
  }
  return patches;
}

void addWheelLines(const core::WheelsetResult& result, core::Side side, std::vector<TextLine>& lines)
{
  const std::vector<const core::PatchResult*> patches = patchesOf(result, side);
  if (patches.empty())
  {
    lines.push_back({formatted("%-5s wheel: no contact", nameOf(side)), Tone::warning});
  }
  else
  {
    const core::WheelForces& forces = result.wheel[side];
    const auto highest = std::max_element(
        patches.begin(), patches.end(), [](const auto* a, const auto* b) { return a->max_pressure < b->max_pressure; });
    lines.push_back({formatted("%-5s wheel: Q %.1f kN, Y %+.1f kN, highest pressure %s", nameOf(side),
                               forces.vertical / 1e3, forces.lateral / 1e3, pressureText(**highest).c_str())});
    if (result.speed != 0)
    {
      lines.push_back({frictionLine(forces)});
    }
  }
  const core::RailDeflection& rail = result.rail[side].deflection;
  if (isDisplaced(rail))
  {
    lines.push_back({railLine(rail)});
  }
  for (const core::PatchResult* patch : patches)
  {
    lines.push_back({patchLine(*patch)});
    if (result.speed != 0)
    {
      lines.push_back({creepLine(patch->creep)});
    }
    if (hasStress(*patch))
    {
      lines.push_back({stressLine(*patch)});
    }
  }
}
}  // namespace

std::vector<TextLine> statusLines(const ContactOutput& output, std::size_t width)
{
  const Tone tone = toneOf(output);
  std::vector<TextLine> lines{{statusName(output.status) + std::string(output.held ? ", held" : ""), tone}};
  for (const std::string& line : wrapped(output.reason, width))
  {
    lines.push_back({line, tone});
  }
  return lines;
}

std::vector<TextLine> resultLines(const ContactOutput& output, const std::vector<core::Side>& sides)
{
  std::vector<TextLine> lines = statusLines(output, panel_width);
  lines.front().text += formatted(" at %.3f s", output.header.stamp.toSec());
  if (hasPose(output))
  {
    lines.push_back({poseLine(output.pose())});
  }
  if (output.result)
  {
    for (const core::Side side : sides)
    {
      addWheelLines(*output.result, side, lines);
    }
  }
  return lines;
}
}  // namespace wheel_rail_contact
