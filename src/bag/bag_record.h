// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

namespace wheel_rail_contact
{
/// Something is wrong with a bag.
class BagError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

// Records of the rosbag format 2.0: <length><header><length><data>, where a header is a list of <length>name=value.
// Lengths are 4 bytes; numbers stand least significant byte first, as on every machine that ROS 1 runs on.

/// Kinds of records, the header field `op`.
enum class BagOp : std::uint8_t
{
  message = 2,     ///< conn, time | the message as published
  bag_header = 3,  ///< index_pos, conn_count, chunk_count | blanks
  index = 4,       ///< ver, conn, count | (time, offset) of each message of one connection in the chunk before
  chunk = 5,       ///< compression, size | connection and message records
  chunk_info = 6,  ///< ver, chunk_pos, start_time, end_time, count | (conn, number of messages) of each connection
  connection = 7   ///< conn, topic | the connection's own header: topic, type, md5sum, message_definition, ...
};

/// What every bag of version 2.0 begins with.
inline constexpr std::string_view bag_magic = "#ROSBAG V2.0\n";
/// Length of the bag header record with its blanks.
inline constexpr std::size_t bag_header_length = 4096;
/// The longest record that is read, and the largest chunk as it is unpacked: what claims to be larger is taken for
/// damage that shall not fill the memory [B]. `rosbag record` makes chunks of 0.75 MiB unless told otherwise.
inline constexpr std::uint64_t largest_record = 1 << 28;
/// Length of one entry of an index record: time, offset.
inline constexpr std::size_t index_entry_length = 12;

/// The number whose bytes stand at the beginning of `bytes`. @throw BagError if there are too few.
template <typename Number>
Number numberAt(std::string_view bytes)
{
  Number number = 0;
  if (bytes.size() < sizeof(number))
  {
    throw BagError("a number is cut off");
  }
  std::memcpy(&number, bytes.data(), sizeof(number));
  return number;
}

/// The bytes of a number.
template <typename Number>
std::string bytesOf(Number number)
{
  std::string bytes(sizeof(number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(number));
  return bytes;
}

/// Time as bags write it (seconds and nanoseconds, 4 bytes each) from and to nanoseconds.
std::uint64_t timeAt(std::string_view bytes);
/// The bytes of a time.
std::string timeBytes(std::uint64_t nanoseconds);

/// Fields of a header by name.
class BagFields
{
 public:
  BagFields() = default;
  /// @throw BagError if the bytes are no list of fields.
  explicit BagFields(std::string_view bytes);

  /// True if there is a field of this name.
  bool has(const std::string& name) const { return fields_.count(name) > 0; }
  /// @throw BagError if there is none of the name.
  const std::string& text(const std::string& name) const;
  /// A field as a little-endian number. @throw BagError if there is none, or it is too short.
  template <typename Number>
  Number number(const std::string& name) const
  {
    return numberAt<Number>(text(name));
  }
  /// A field as a time [ns]. @throw BagError likewise.
  std::uint64_t time(const std::string& name) const { return timeAt(text(name)); }
  /// What kind of record this header begins.
  BagOp op() const { return static_cast<BagOp>(number<std::uint8_t>("op")); }

  /// Sets a field's bytes.
  BagFields& set(const std::string& name, std::string value);
  /// Sets the kind of record.
  BagFields& set(BagOp op) { return set("op", bytesOf(static_cast<std::uint8_t>(op))); }
  /// As a header, in alphabetical order.
  std::string bytes() const;

 private:
  std::map<std::string, std::string> fields_;
};

/// A record that stands in memory.
struct BagRecord
{
  BagFields header;        ///< its fields
  std::string_view data;   ///< within the bytes it was read from
  std::size_t length = 0;  ///< of the whole record in bytes
};

/// The record at the beginning of `bytes`. @throw BagError if it is cut off or none.
BagRecord recordAt(std::string_view bytes);

/// Calls `action` with each record of a chunk. @throw BagError where one is cut off or none, after those before it.
template <typename Action>
void forEachRecord(std::string_view bytes, const Action& action)
{
  while (!bytes.empty())
  {
    const BagRecord record = recordAt(bytes);
    bytes.remove_prefix(record.length);
    action(record);
  }
}

/// Calls `action` with each message's time [ns] in the data of an index record.
template <typename Action>
void forEachIndexTime(std::string_view entries, const Action& action)
{
  for (; entries.size() >= index_entry_length; entries.remove_prefix(index_entry_length))
  {
    action(timeAt(entries));
  }
}

/// Appends a record to `bytes`.
void appendRecord(const BagFields& header, std::string_view data, std::string& bytes);
}  // namespace wheel_rail_contact
