// SPDX-License-Identifier: BSD-3-Clause
// Profile files of all formats: each gives a profile that can be evaluated at every point, or a FileError.
#include <array>
#include <cstdlib>

#include "../temporary_folder.h"
#include "sound_profile.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace
{
using namespace wheel_rail_contact;

struct Format
{
  const char* file;
  core::ProfileKind kind;
};

constexpr std::array<Format, 6> formats{{{"input.prw", core::ProfileKind::wheel},
                                         {"input.prr", core::ProfileKind::rail},
                                         {"input.whl", core::ProfileKind::wheel},
                                         {"input.ban", core::ProfileKind::rail},
                                         {"wheel.csv", core::ProfileKind::wheel},
                                         {"rail.csv", core::ProfileKind::rail}}};
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Folder folder;
  for (const Format& format : formats)
  {
    try
    {
      if (!isSound(core::readProfile(folder.write(format.file, {data, data + size}), format.kind)))
      {
        std::abort();
      }
    }
    catch (const core::FileError&)  // rejected with a reason
    {
    }
  }
  return 0;
}
