// SPDX-License-Identifier: BSD-3-Clause
// Slices of a rail: each file gives profiles that can be evaluated all along the rail, or an error with its reason.
#include <cstdlib>
#include <stdexcept>

#include "../temporary_folder.h"
#include "core/profile/along/changing_profile.h"
#include "sound_profile.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace
{
using namespace wheel_rail_contact;

/// Folder with the slices a.txt and b.txt, of rails with different heights.
const Folder& slices()
{
  static const Folder folder;
  for (const char* name : {"a.txt", "b.txt"})
  {
    const core::Profile rail = core::loadProfile("UIC60_manchester", core::ProfileKind::rail);
    std::string text;
    for (double u = 0; u < rail.length(); u += 0.5e-3)
    {
      const core::CurvePoint point = rail.at(u);
      text += std::to_string(1e3 * point.y) + " " + std::to_string(-1e3 * point.z + (*name == 'b' ? 2 : 0)) + "\n";
    }
    folder.write(name, text);
  }
  return folder;
}

bool isSoundAlong(const core::RailSeries& series)
{
  constexpr int places = 20;
  const core::RailSections sections({series}, core::RailSections::Placement::coordinates);
  core::ChangingProfile rail(sections);
  rail.reserve();
  bool sound = true;
  for (int i = 0; i <= places && sound; ++i)
  {
    const double x = series.front().x + (series.back().x - series.front().x) * i / places;
    if (sections.contains(x))
    {
      rail.moveTo(x);
      sound = isSound(*rail.profile());
    }
  }
  return sound;
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Folder& folder = slices();
  try
  {
    if (!isSoundAlong(core::readRailSlices(folder.write("rail.slcs", {data, data + size}))))
    {
      std::abort();
    }
  }
  catch (const std::invalid_argument&)  // rejected with a reason
  {
  }
  catch (const core::FileError&)  // rejected with a reason
  {
  }
  return 0;
}
