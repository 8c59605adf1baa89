// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "replay/replay_options.h"

namespace wheel_rail_contact
{
/// Recording time [ns] from which a bag must be read, so that the answers in `options.span` are those of a replay of
/// the whole bag: before the span every wheelset's pairs come out even, then has a fresh start, and neighbours' answers
/// are known as long as they count. 0, the bag's beginning, where that cannot be told from a part: with transforms,
/// whose buffer depends on all before; with a slop, which may shift who is paired with whom; without an index.
/// @throw BagError if the bag cannot be read.
std::uint64_t warmUpStart(const ReplayOptions& options, const NodeConfig& config);
}  // namespace wheel_rail_contact
