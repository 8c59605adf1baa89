// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bag/bag_contents.h"

namespace wheel_rail_contact
{
/// A message of the output of a replay: a result, or a copied message of the input (--keep-topics).
struct ReplayItem
{
  std::optional<std::size_t> wheelset;        ///< wheelset of a result; empty: a copied message
  std::uint32_t connection_id = 0;            ///< of a copied message, in the input
  const BagConnection* connection = nullptr;  ///< of a copied message
  std::uint64_t time = 0;  ///< recording time: of a copied message, or when the input became complete [ns]
  std::uint64_t read = 0;  ///< messages read from the input so far
  std::string data;        ///< bytes of the message; for a result set later
};
}  // namespace wheel_rail_contact
