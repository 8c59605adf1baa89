// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace wheel_rail_contact
{
/// Joins the results of consecutive parts of one bag (contact_replay with --from and --to). The output is identical to
/// the file that one replay of the whole bag writes: to the last byte, with --keep-topics to the last message.
/// @param parts in their order
/// @param compression none or lz4, as that of the parts
/// @return number of messages written
/// @throw BagError if a part is damaged, does not belong to the same replay, is out of order or is missing, or if the
/// output exists. A part without results does not contain its span; a gap next to such a part is not detected.
/// @throw std::invalid_argument if no parts are given.
std::uint64_t joinParts(const std::vector<std::string>& parts, const std::string& output,
                        const std::string& compression);
}  // namespace wheel_rail_contact
