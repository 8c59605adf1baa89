// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace wheel_rail_contact
{
/// A bag cannot be read or written.
class BagError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/// @throw BagError if there is a fault. Only then are the parts of the reason joined.
template <typename... Parts>
void refuseBagIf(bool fault, const Parts&... parts)
{
  if (fault)
  {
    std::ostringstream reason;
    (reason << ... << parts);
    throw BagError(reason.str());
  }
}

// Records of the rosbag format 2.0: <length><header><length><data>. A header is a list of <length>name=value. Lengths
// have 4 bytes. Numbers are little-endian, as on every machine on which ROS 1 runs, and are therefore copied unchanged.

/// Record types: values of the header field `op`. Comments: header fields | data.
enum class BagOp : std::uint8_t
{
  message = 2,     ///< conn, time | serialised message
  bag_header = 3,  ///< index_pos, conn_count, chunk_count | spaces
  index = 4,       ///< ver, conn, count | (time, offset) of each message of one connection in the preceding chunk
  chunk = 5,       ///< compression, size | connection and message records
  chunk_info = 6,  ///< ver, chunk_pos, start_time, end_time, count | (conn, number of messages) of each connection
  connection = 7   ///< conn, topic | header of the connection: topic, type, md5sum, message_definition, ...
};

/// First bytes of every bag of version 2.0.
inline constexpr std::string_view bag_magic = "#ROSBAG V2.0\n";
/// Length of the bag header record, including the spaces [B].
inline constexpr std::size_t bag_header_length = 4096;
/// Largest record that is read, and largest decompressed chunk [B]. Larger ones are regarded as damaged, to limit the
/// memory. `rosbag record` makes chunks of 0.75 MiB by default.
inline constexpr std::uint64_t largest_record = 1 << 28;
/// Largest sum of the sizes of decompressed chunks: this times the size of the file, and at least largest_record.
inline constexpr std::uint64_t usual_expansion = 100;
/// Length of one entry (time, offset) of an index record [B].
inline constexpr std::size_t index_entry_length = 12;

/// Number at the beginning of `bytes`. @throw BagError if there are too few bytes.
template <typename Number>
Number numberAt(std::string_view bytes)
{
  Number number = 0;
  refuseBagIf(bytes.size() < sizeof(number), "a number is truncated");
  std::memcpy(&number, bytes.data(), sizeof(number));
  return number;
}

/// Bytes of a number.
template <typename Number>
std::string bytesOf(Number number)
{
  std::string bytes(sizeof(number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(number));
  return bytes;
}

/// Time [ns] at the beginning of `bytes`, in the format of bags: seconds and nanoseconds, 4 bytes each.
/// @throw BagError if there are too few bytes.
std::uint64_t timeAt(std::string_view bytes);
/// Bytes of a time [ns] in the format of bags.
std::string timeBytes(std::uint64_t nanoseconds);

/// Header of a record: fields by name.
class BagFields
{
 public:
  BagFields() = default;
  /// Parses a header. @throw BagError if the bytes are not a list of fields.
  explicit BagFields(std::string_view bytes);

  /// True if the header has a field of this name.
  bool has(const std::string& name) const { return fields_.count(name) > 0; }
  /// Bytes of a field. @throw BagError if it is missing.
  const std::string& text(const std::string& name) const;
  /// Field as a little-endian number. @throw BagError if it is missing or too short.
  template <typename Number>
  Number number(const std::string& name) const
  {
    return numberAt<Number>(text(name));
  }
  /// Field as a time [ns]. @throw BagError if it is missing or too short.
  std::uint64_t time(const std::string& name) const { return timeAt(text(name)); }
  /// Type of the record. @throw BagError if the field `op` is missing.
  BagOp op() const { return static_cast<BagOp>(number<std::uint8_t>("op")); }

  /// Sets a field.
  BagFields& set(const std::string& name, std::string value);
  /// Sets the type of the record.
  BagFields& set(BagOp op) { return set("op", bytesOf(static_cast<std::uint8_t>(op))); }
  /// Bytes of the header; fields in alphabetical order.
  std::string bytes() const;

 private:
  std::map<std::string, std::string> fields_;
};

/// A record in memory.
struct BagRecord
{
  BagFields header;        ///< fields of the record
  std::string_view data;   ///< points into the bytes from which the record was read
  std::size_t length = 0;  ///< of the whole record [B]
};

/// Record at the beginning of `bytes`. @throw BagError if it is truncated or invalid.
BagRecord recordAt(std::string_view bytes);

/// Calls `action` with each record of a chunk.
/// @throw BagError at the first truncated or invalid record, after the calls for the records before it.
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

/// Calls `action` with the recording time [ns] of each message in the data of an index record.
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

/// Sum of the sizes of decompressed chunks. Its limit protects the reader from small files that expand without end.
class ExpandedSize
{
 public:
  /// @param limit largest sum [B]
  explicit ExpandedSize(std::uint64_t limit) : limit_(limit) {}

  /// Adds a size [B]. @throw BagError if the sum exceeds the limit, then and for all later chunks.
  void add(std::uint64_t size);
  /// True if the limit was exceeded.
  bool isOver() const { return is_over_; }

 private:
  std::uint64_t limit_, sum_ = 0;
  bool is_over_ = false;
};

/// Content of a chunk.
/// @param compression from the header of the chunk: none, bz2 or lz4
/// @param data of the chunk, compressed
/// @param size of the content, from the header of the chunk [B]
/// @param expanded sum to which the size of decompressed data is added
/// @throw BagError if the data is damaged, the size exceeds largest_record, the sum its limit, or the compression is
/// unknown.
std::string decompressed(const std::string& compression, std::string data, std::size_t size, ExpandedSize& expanded);

/// Compressed data of a chunk.
/// @param compression none or lz4
/// @throw BagError for another compression, or if lz4 fails.
std::string compressed(const std::string& compression, std::string content);

/// A bag file (rosbag format 2.0), opened for reading record by record.
class BagFile
{
 public:
  /// @throw BagError if the file cannot be read, is not a bag of version 2.0 or is encrypted.
  /// @param most_expanded largest sum of the sizes of decompressed chunks [B]; 0: see usual_expansion
  explicit BagFile(const std::string& path, std::uint64_t most_expanded = 0);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  /// Path passed to the constructor.
  const std::string& path() const { return path_; }
  /// Size of the file [B].
  std::uint64_t size() const { return size_; }
  /// Largest sum of the sizes of decompressed chunks [B].
  std::uint64_t mostExpanded() const { return most_expanded_; }

  /// Bytes of the file. Position and length in bytes.
  /// @throw BagError if they extend beyond the end of the file, or if `length` exceeds largest_record.
  std::string bytes(std::uint64_t position, std::uint64_t length) const;

  /// Header of a record and position of its data.
  struct Place
  {
    BagFields header;          ///< fields of the record
    std::uint64_t data = 0;    ///< position of the data in the file [B]
    std::uint64_t length = 0;  ///< length of the data [B]
    /// Position of the next record [B].
    std::uint64_t end() const { return data + length; }
  };
  /// Reads the header of the record at a position [B]. Its data may extend beyond the end of the file.
  /// @throw BagError if there is no valid header.
  Place recordAt(std::uint64_t position) const;
  /// Data of a record. @throw BagError as bytes().
  std::string dataOf(const Place& place) const { return bytes(place.data, place.length); }

  /// Position of the record after the bag header [B].
  std::uint64_t firstRecord() const { return first_record_; }
  /// Position of the index section [B]; 0 if the bag was not closed.
  std::uint64_t indexSection() const { return index_section_; }

 private:
  void readBagHeader();

  std::string path_;
  int descriptor_;
  std::uint64_t most_expanded_ = 0, size_ = 0, first_record_ = 0, index_section_ = 0;
};
}  // namespace wheel_rail_contact
