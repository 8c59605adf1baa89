// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "replay/replay_options.h"

namespace wheel_rail_contact
{
/// Recording time [ns] at which reading must begin. The results in `options.span` are then those of a replay of the
/// whole bag: ReplaySource::isWarmedUp() is true at the beginning of the span.
///
/// Returns 0, the beginning of the bag, where a part of the bag is not sufficient to verify this:
/// - with transforms, because their buffer depends on all earlier messages;
/// - with a slop, because an earlier message may change which messages are matched;
/// - without an index.
/// @throw BagError if the bag cannot be read.
std::uint64_t warmUpStart(const ReplayOptions& options, const NodeConfig& config);
}  // namespace wheel_rail_contact
