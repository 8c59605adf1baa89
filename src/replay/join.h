// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace wheel_rail_contact
{
/// Joins the answers of parts of one bag (contact_replay with --from and --to), given in their order, to the file that
/// one replay of the whole bag writes, to the last byte; with --keep-topics to the last message.
/// @param compression none or lz4, as the parts have
/// @return the number of messages
/// @throw BagError if a part is damaged, does not belong to the others or comes before one that is given before it, if
/// one is missing, or if the output exists. Parts without answers do not tell their times: beside them no other is
/// missed.
/// @throw std::invalid_argument if no parts are given.
std::uint64_t joinParts(const std::vector<std::string>& parts, const std::string& output,
                        const std::string& compression);
}  // namespace wheel_rail_contact
