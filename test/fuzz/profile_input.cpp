// SPDX-License-Identifier: BSD-3-Clause
// Profile files of every format: a profile that can be evaluated everywhere, or a ProfileError.
#include <array>
#include <cmath>
#include <cstdlib>

#include "scratch_folder.h"
#include "wheel_rail_contact/geometry/profile_reader.h"

namespace
{
using namespace wheel_rail_contact;

struct Format
{
  const char* file;
  ProfileKind kind;
};

constexpr std::array<Format, 6> formats{{{"input.prw", ProfileKind::wheel},
                                         {"input.prr", ProfileKind::rail},
                                         {"input.whl", ProfileKind::wheel},
                                         {"input.ban", ProfileKind::rail},
                                         {"wheel.csv", ProfileKind::wheel},
                                         {"rail.csv", ProfileKind::rail}}};

bool isSound(const Profile& profile)
{
  constexpr int places = 1000;
  bool sound = std::isfinite(profile.length()) && profile.length() > 0;
  for (int i = 0; i <= places && sound; ++i)
  {
    const CurvePoint point = profile.at(profile.length() * i / places);
    sound = std::isfinite(point.y) && std::isfinite(point.z) && std::hypot(point.dy, point.dz) > 0;
  }
  return sound;
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const fuzz::ScratchFolder folder;
  for (const Format& format : formats)
  {
    try
    {
      if (!isSound(readProfile(folder.write(format.file, data, size), format.kind)))
      {
        std::abort();
      }
    }
    catch (const ProfileError&)  // refused with a reason
    {
    }
  }
  return 0;
}
