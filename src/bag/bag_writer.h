// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bag/bag_contents.h"

namespace wheel_rail_contact
{
/// Position in an unfinished bag from which a BagWriter can continue: the end of its last full chunk.
struct BagResumePoint
{
  std::uint64_t messages = 0;  ///< number of messages before this position
  std::uint64_t end = 0;       ///< position of the next chunk in the file [B]
  std::string chunk_infos;     ///< chunk info records of the full chunks
  std::uint32_t chunks = 0;    ///< number of full chunks
};

/// Writes a bag sequentially. The same messages give the same file, to the last byte, also if writing was interrupted
/// and resumed. Memory: the current chunk, two copies of it while it is written, and about 100 B per chunk written.
class BagWriter
{
 public:
  /// A chunk is closed when it has at least this size before compression [B].
  static constexpr std::size_t full_chunk = 1 << 22;

  /// Creates the file and locks it.
  /// @param compression none or lz4
  /// @throw BagError if the file already exists or cannot be written.
  BagWriter(const std::string& path, std::string compression);
  /// Truncates an unfinished bag to its full chunks and continues it. The first `resume_point.messages` messages passed
  /// to write() must be those in the file; they are not written again.
  /// @throw BagError if the file cannot be written.
  BagWriter(const std::string& path, std::string compression, const BagResumePoint& resume_point);
  /// Does not complete an unfinished bag; see close().
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// Sets a function that is called before each chunk is written.
  void onChunk(std::function<void()> action) { on_chunk_ = std::move(action); }

  /// Adds a connection. @return its number
  std::uint32_t addConnection(const BagConnection& connection);
  /// Adds a message.
  /// @param time recording time [ns]
  /// @param data serialised message
  /// @throw BagError if the file cannot be written.
  void write(std::uint32_t connection, std::uint64_t time, std::string_view data);
  /// Writes the last chunk and the index section. @throw BagError if the file cannot be written.
  void close();

 private:
  struct Connection
  {
    std::string record;  ///< connection record, as in chunks and in the index section
    bool written = false;
    std::string index;  ///< index entries of the current chunk
  };

  void writeBagHeader();
  void finishChunk();
  void put(std::string_view bytes);
  [[noreturn]] void fail() const;

  std::string path_, compression_;
  int descriptor_;
  std::uint64_t already_there_;  ///< messages in the resumed file that are still to be skipped
  std::uint64_t position_ = 0;   ///< end of the file so far [B]
  std::uint64_t index_section_ = 0;
  std::vector<Connection> connections_;
  std::string chunk_;  ///< content of the current chunk
  std::uint64_t chunk_start_ = 0, chunk_end_ = 0;
  std::string chunk_infos_;
  std::uint32_t chunks_ = 0;
  std::function<void()> on_chunk_;
};

/// Resume point of a bag that a BagWriter did not finish, or closed before the end of the messages. A chunk counts if
/// it is full and followed by another record; the last chunk may be truncated.
/// @throw BagError if the file cannot be read or is not a bag.
BagResumePoint resumePointOf(const BagFile& file);
}  // namespace wheel_rail_contact
