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
/// Connection of a bag: one publisher on one topic.
struct BagConnection
{
  std::string topic;  ///< name of the topic in the bag
  BagFields header;   ///< type, md5sum, message_definition and further fields of the publisher
};

/// Span of recording times, from `from` (inclusive) to `to` (exclusive).
struct BagSpan
{
  std::uint64_t from = 0;                                        ///< [ns]
  std::uint64_t to = std::numeric_limits<std::uint64_t>::max();  ///< [ns]

  /// True if the span contains all recording times.
  bool isWhole() const { return from == 0 && to == std::numeric_limits<std::uint64_t>::max(); }
};

/// Part of a bag that is read at once: a chunk, or the loose records of an unclosed chunk.
struct BagChunk
{
  std::uint64_t position = 0;   ///< of the chunk record, or of the first loose record [B]
  std::uint64_t start = 0;      ///< earliest recording time of its messages [ns]
  std::uint64_t loose_end = 0;  ///< of loose records: where they end at the latest [B]; 0: a chunk
};

/// Contents of a bag without the messages.
struct BagContents
{
  std::map<std::uint32_t, BagConnection> connections;  ///< by number
  /// Number of messages by connection, which is one of `connections`. With an index, only chunks that overlap the span
  /// count.
  std::map<std::uint32_t, std::uint64_t> messages;
  /// Chunks with messages of wanted topics, in the order of the file. With an index, chunks that end before the span
  /// are left out.
  std::vector<BagChunk> chunks;
  std::string fault;  ///< reason why the bag is incomplete; empty if it is complete
};

/// Predicate: true for the topics whose messages are wanted.
using TopicFilter = std::function<bool(const std::string& topic)>;

/// True if the contents have this connection, and its topic is wanted.
bool isWanted(const BagContents& contents, std::uint32_t connection, const TopicFilter& wanted);

/// Reads the index of a bag. If there is none (crashed recorder, truncated file), reads the whole file. If chunks
/// follow the last one that the index lists (`rosbag reindex` of a truncated file), reads them, too, and reports a
/// fault. Memory: 24 B per chunk.
BagContents readContents(const BagFile& file, const TopicFilter& wanted, const BagSpan& span = {});

/// Bytes of the records in a chunk, decompressed. Of loose records only the complete ones are returned.
/// @param expanded sum to which the size of a compressed chunk is added
/// @throw BagError if the data is damaged, or with it the sum exceeds its limit.
std::string chunkRecords(const BagFile& file, const BagChunk& chunk, ExpandedSize& expanded);

/// Largest number of connections of a bag. The limit protects the memory from damaged bags.
inline constexpr std::size_t most_connections = 1 << 16;

/// Adds the connection of a connection record, unless `contents` already has a connection of this number.
/// @throw BagError if the record is damaged, or if there are more than most_connections.
void addConnection(const BagFields& record_header, std::string_view data, BagContents& contents);
}  // namespace wheel_rail_contact
