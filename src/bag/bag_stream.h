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
/// A message of a bag as it was published.
struct BagMessage
{
  std::uint32_t connection_id = 0;            ///< number of the connection
  const BagConnection* connection = nullptr;  ///< that of BagContents
  std::uint64_t time = 0;                     ///< at which it was recorded [ns]
  std::string_view data;                      ///< valid until the next message is asked for
};

/// Delivers the messages of a bag in the order of their recording times, as `rosbag play` does; messages of equal time
/// in the order of the file. Keeps only those chunks in memory that overlap in time, so that a bag may have any length.
/// What cannot be read is left out and reported.
class BagStream
{
 public:
  /// @param span messages before it are passed over; those after it are delivered
  /// @throw BagError if the file cannot be read or is no bag, not for damage further on.
  BagStream(const std::string& path, TopicFilter wanted, const BagSpan& span = {});

  /// As far as it could be read.
  const BagContents& contents() const { return contents_; }
  /// Of the bag [B].
  std::uint64_t fileSize() const { return file_.size(); }

  /// The next message, nothing at the end.
  std::optional<BagMessage> next();

  /// What could not be read so far, in sentences; empty if everything was.
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
    std::vector<Entry> entries;  ///< by time
    std::size_t next = 0;
  };
  struct Later
  {
    bool operator()(const std::unique_ptr<OpenChunk>& a, const std::unique_ptr<OpenChunk>& b) const;
  };

  void openDueChunks();
  void open(const BagChunk& chunk);
  void listMessages(OpenChunk& chunk);
  bool isWanted(std::uint32_t connection) const;
  void report(const std::string& fault);

  TopicFilter wanted_;
  std::uint64_t from_;  ///< [ns]
  BagFile file_;
  BagContents contents_;  ///< chunks by start
  std::size_t next_chunk_ = 0;
  std::vector<std::unique_ptr<OpenChunk>> open_;  ///< heap, earliest next message first
  std::vector<std::string> faults_;
};
}  // namespace wheel_rail_contact
