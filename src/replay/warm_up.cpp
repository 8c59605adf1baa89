// SPDX-License-Identifier: BSD-3-Clause
#include "replay/warm_up.h"

#include <algorithm>

#include "replay/replay_source.h"

namespace wheel_rail_contact
{
namespace
{
/// First warm-up [ns]. It suffices if stamps are recording times: any two seconds contain a whole second of the stamps,
/// and results of neighbours are used for one second.
constexpr std::uint64_t shortest = 3'000'000'000;
constexpr std::uint64_t growth = 4;

bool isTransform(const std::string& topic)
{
  return topic == "/tf" || topic == "/tf_static" || topic == "tf" || topic == "tf_static";
}

bool holdsTransforms(const BagContents& contents)
{
  return std::any_of(contents.messages.begin(), contents.messages.end(),
                     [&contents](const auto& entry)
                     { return entry.second > 0 && isTransform(contents.connections.at(entry.first).topic); });
}

std::uint64_t startOf(const BagContents& contents)
{
  std::uint64_t start = std::numeric_limits<std::uint64_t>::max();
  for (const BagChunk& chunk : contents.chunks)
  {
    start = std::min(start, chunk.start);
  }
  return start;
}
}  // namespace

std::uint64_t warmUpStart(const ReplayOptions& options, const NodeConfig& config)
{
  const std::uint64_t from = options.span.from;
  if (from == 0 || config.slop > 0)
  {
    return 0;
  }
  const BagContents contents = readContents(BagFile(options.input), [](const std::string&) { return true; });
  if (!contents.fault.empty() || holdsTransforms(contents))
  {
    return 0;
  }
  const std::uint64_t start = startOf(contents);
  for (std::uint64_t lead = shortest; lead < from && from - lead > start; lead *= growth)
  {
    ReplaySource before(options.input, config, options.inputs, false, {from - lead, from}, from - lead);
    while (before.next())
    {
    }
    if (before.isWarmedUp())
    {
      return from - lead;
    }
  }
  return 0;
}
}  // namespace wheel_rail_contact
