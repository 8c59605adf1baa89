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
/// The part of an unfinished bag that a BagWriter can go on from: its full chunks.
struct BagRemains
{
  std::uint64_t messages = 0;  ///< in them
  std::uint64_t end = 0;       ///< where the next chunk goes in the file [B]
  std::string chunk_infos;     ///< records of the index section
  std::uint32_t chunks = 0;    ///< number of them
};

/// Writes a bag from front to end. The same messages give the same file, to the last byte, also when the writing was
/// broken off and taken up again. Memory: the chunk in hand, two copies as it goes to the file, and
/// about 100 B for each chunk written.
class BagWriter
{
 public:
  /// A chunk is closed by the message that makes it so large [B].
  static constexpr std::size_t full_chunk = 1 << 22;

  /// Creates the file.
  /// @param compression none or lz4
  /// @throw BagError if it exists already or cannot be written.
  BagWriter(const std::string& path, std::string compression);
  /// Cuts the file to what remains and goes on: the first `remains.messages` messages given to write() must be those
  /// that are in the file, and are not written again.
  BagWriter(const std::string& path, std::string compression, const BagRemains& remains);
  /// Leaves an unfinished file as it is; see close().
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// Called before a chunk goes to the file.
  void onChunk(std::function<void()> action) { on_chunk_ = std::move(action); }

  /// @return the connection's number
  std::uint32_t addConnection(const BagConnection& connection);
  /// @param time at which the message was recorded [ns]
  /// @throw BagError if the file cannot be written.
  void write(std::uint32_t connection, std::uint64_t time, std::string_view data);
  /// Writes what is left and the index.
  void close();

 private:
  struct Connection
  {
    std::string record;  ///< as it stands in chunks and in the index section
    bool written = false;
    std::string index;  ///< entries of the chunk in hand
  };

  void writeBagHeader();
  void finishChunk();
  void put(std::string_view bytes);
  [[noreturn]] void fail() const;

  std::string path_, compression_;
  int descriptor_;
  std::uint64_t already_there_;  ///< messages that are in the file from before
  std::uint64_t position_ = 0;   ///< in the file [B]
  std::uint64_t index_section_ = 0;
  std::vector<Connection> connections_;
  std::string chunk_;  ///< content of the chunk in hand
  std::uint64_t chunk_start_ = 0, chunk_end_ = 0;
  std::string chunk_infos_;
  std::uint32_t chunks_ = 0;
  std::function<void()> on_chunk_;
};

/// What remains of a bag that a BagWriter did not finish, or has closed before the end. The last chunk may be cut off,
/// so it does not count.
/// @throw BagError if the file cannot be read or is no bag.
BagRemains remainsOf(const BagFile& file);
}  // namespace wheel_rail_contact
