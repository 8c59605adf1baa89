// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bag/bag_contents.h"

namespace wheel_rail_contact
{
/// A serialised message of a bag.
struct BagMessage
{
  std::uint32_t connection_id = 0;            ///< number of the connection
  const BagConnection* connection = nullptr;  ///< in BagContents::connections
  std::uint64_t time = 0;                     ///< recording time [ns]
  std::string_view data;                      ///< valid until the next call of BagStream::next()
};

/// Delivers the messages of a bag in the order of their recording times, as `rosbag play` does. Messages with equal
/// times are delivered in the order of the file. Only chunks that overlap in time are in memory, so a bag may have any
/// length. Unreadable parts are skipped and reported.
class BagStream
{
 public:
  /// @param span messages before it are skipped; messages after it are delivered
  /// @throw BagError if the file cannot be read or is not a bag. Damage further on causes no exception.
  /// @param most_expanded see BagFile
  BagStream(const std::string& path, TopicFilter wanted, const BagSpan& span = {}, std::uint64_t most_expanded = 0);

  /// Contents of the bag, as far as readable.
  const BagContents& contents() const { return contents_; }
  /// Size of the bag [B].
  std::uint64_t fileSize() const { return file_.size(); }

  /// The next message; empty at the end.
  /// @throw BagError if more than 128 MiB of chunks overlap in time.
  std::optional<BagMessage> next();

  /// Parts that could not be read so far, as text; empty if everything was read.
  const std::vector<std::string>& faults() const { return faults_; }

 private:
  struct Entry
  {
    std::uint64_t time;
    std::uint32_t connection;
    std::string_view data;
  };
  struct OpenChunk
  {
    std::uint64_t position = 0;
    std::string records;
    std::vector<Entry> entries;  ///< in the order of time
    std::size_t next = 0;
  };
  struct Later
  {
    bool operator()(const std::unique_ptr<OpenChunk>& a, const std::unique_ptr<OpenChunk>& b) const;
  };

  void openDueChunks();
  void open(const BagChunk& chunk);
  void listMessages(OpenChunk& chunk);
  void report(const std::string& fault);

  TopicFilter wanted_;
  std::uint64_t from_;  ///< beginning of the span [ns]
  BagFile file_;
  BagContents contents_;  ///< chunks in the order of their start
  std::size_t next_chunk_ = 0;
  ExpandedSize expanded_;
  std::vector<std::unique_ptr<OpenChunk>> open_;  ///< heap; the chunk with the earliest next message is first
  std::vector<std::string> faults_;
};
}  // namespace wheel_rail_contact
