// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bag/bag_file.h"

namespace wheel_rail_contact
{
/// Who published what on which topic.
struct BagConnection
{
  std::string topic;  ///< as the publisher named it
  BagFields header;   ///< type, md5sum, message_definition, and what else the publisher said
};

/// A stretch of recording times: `from` belongs to it, `to` does not [ns].
struct BagSpan
{
  std::uint64_t from = 0;                                        ///< [ns]
  std::uint64_t to = std::numeric_limits<std::uint64_t>::max();  ///< [ns]

  /// True if nothing lies outside.
  bool isWhole() const { return from == 0 && to == std::numeric_limits<std::uint64_t>::max(); }
};

/// Part of a bag that is read in one go.
struct BagChunk
{
  std::uint64_t position = 0;  ///< of its record, or of the first of its loose records
  std::uint64_t start = 0;     ///< earliest time of its messages [ns]
  bool loose = false;          ///< records up to the end of the file that no chunk was closed around
};

/// What is in a bag, without its messages.
struct BagContents
{
  std::map<std::uint32_t, BagConnection> connections;  ///< by number
  std::map<std::uint32_t, std::uint64_t> messages;     ///< by connection, in the chunks that touch the span
  /// Those with messages asked for, in the order of the file; none that ends before the span, as far as an index tells.
  std::vector<BagChunk> chunks;
  std::string fault;  ///< why the bag is not whole; empty if it is
};

/// True for the topics whose messages are asked for.
using TopicFilter = std::function<bool(const std::string& topic)>;

/// Reads a bag's index; where there is none (the recorder crashed, the file was cut off), looks through the whole file.
/// Memory: 24 B for each chunk.
BagContents readContents(const BagFile& file, const TopicFilter& wanted, const BagSpan& span = {});

/// The chunk's records as they stand there; of loose records all that are whole.
/// @throw BagError if the data is damaged.
std::string chunkRecords(const BagFile& file, const BagChunk& chunk);

/// Greatest number of a bag's connections: what has more is damaged, and shall not fill the memory.
inline constexpr std::size_t most_connections = 1 << 16;

/// Adds the connection that a connection record describes, unless one of its number is there already.
/// @throw BagError if the record is damaged, or there are too many.
void addConnection(const BagFields& record_header, std::string_view data, BagContents& contents);
}  // namespace wheel_rail_contact
