// SPDX-License-Identifier: BSD-3-Clause
// Tables of a line: each gives finite values all along the line, or std::invalid_argument.
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "../temporary_folder.h"
#include "wheel_rail_contact/core/track.h"

namespace
{
using namespace wheel_rail_contact;

bool isFinite(const core::TrackLine& line)
{
  constexpr int places = 1000;
  bool finite = line.end() > line.begin() || line.end() == line.begin();
  for (int i = 0; i <= places && finite; ++i)
  {
    const double x = line.begin() + (line.end() - line.begin()) * i / places;
    const core::LineStation station = line.at(x);
    finite = std::isfinite(station.cross_level);
    for (const core::Side side : core::sides)
    {
      const core::RailDeflection& rail = station.rail[side];
      finite = finite && std::isfinite(rail.lateral + rail.vertical + rail.roll);
    }
  }
  return finite;
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Folder folder;
  const std::string file = folder.write("line.csv", {data, data + size});
  for (const core::LineAxes axes : {core::LineAxes::rep103, core::LineAxes::railway})
  {
    try
    {
      core::LineReport report;
      if (!isFinite(core::readTrackLine(file, 1.435, {axes}, &report)))
      {
        std::abort();
      }
    }
    catch (const std::invalid_argument&)  // rejected with a reason
    {
    }
  }
  return 0;
}
