// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bag/bag_contents.h"

namespace wheel_rail_contact
{
/// One place in the output of a replay: an answer, or a message that is kept.
struct ReplayItem
{
  std::optional<std::size_t> wheelset;        ///< whose answer this is; nothing: a message that is kept
  std::uint32_t connection_id = 0;            ///< of a message that is kept, as in the input
  const BagConnection* connection = nullptr;  ///< of a message that is kept
  std::uint64_t time = 0;                     ///< recording time at which the input was ready, or of the message [ns]
  std::uint64_t read = 0;                     ///< messages read from the input so far
  std::string data;                           ///< the message; that of an answer is filled in later
};
}  // namespace wheel_rail_contact
