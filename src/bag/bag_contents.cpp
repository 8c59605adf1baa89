// SPDX-License-Identifier: BSD-3-Clause
#include "bag/bag_contents.h"

#include <algorithm>
#include <utility>

namespace wheel_rail_contact
{
namespace
{
constexpr std::size_t pair_length = 8;  ///< (conn, number of messages) in a chunk info record [B]

/// Adds to the number of messages of a connection. Messages of a connection without a record are not counted.
void countMessages(BagContents& contents, std::uint32_t connection, std::uint64_t count)
{
  if (contents.connections.count(connection) > 0)
  {
    contents.messages[connection] += count;
  }
}

void addChunkInfo(const BagFields& header, std::string_view data, const TopicFilter& wanted, const BagSpan& span,
                  BagContents& contents)
{
  if (header.time("end_time") < span.from)
  {
    return;
  }
  const bool touches = header.time("start_time") < span.to;
  bool holds_wanted = false;
  for (; data.size() >= pair_length; data.remove_prefix(pair_length))
  {
    const auto connection = numberAt<std::uint32_t>(data);
    const auto count = numberAt<std::uint32_t>(data.substr(sizeof(connection)));
    countMessages(contents, connection, touches ? count : 0);
    holds_wanted = holds_wanted || (count > 0 && isWanted(contents, connection, wanted));
  }
  if (holds_wanted)
  {
    contents.chunks.push_back({header.number<std::uint64_t>("chunk_pos"), header.time("start_time"), 0});
  }
}

/// Reads the index section.
/// @param last_chunk set to the position of the last chunk in it [B]; unchanged if it has none
/// @throw BagError if it is missing or incomplete.
BagContents readIndexSection(const BagFile& file, const TopicFilter& wanted, const BagSpan& span,
                             std::uint64_t& last_chunk)
{
  refuseBagIf(file.indexSection() == 0, "it was not closed");
  BagContents contents;
  for (std::uint64_t position = file.indexSection(); position < file.size();)
  {
    const BagFile::Place record = file.recordAt(position);
    const std::string data = file.dataOf(record);
    if (record.header.op() == BagOp::connection)
    {
      addConnection(record.header, data, contents);
    }
    else if (record.header.op() == BagOp::chunk_info)
    {
      addChunkInfo(record.header, data, wanted, span, contents);
      last_chunk = std::max(last_chunk, record.header.number<std::uint64_t>("chunk_pos"));
    }
    position = record.end();
  }
  const BagFields& header = file.recordAt(bag_magic.size()).header;
  refuseBagIf(contents.connections.size() != header.number<std::uint32_t>("conn_count"), "the index is incomplete");
  const auto earlier = [](const BagChunk& a, const BagChunk& b) { return a.position < b.position; };
  std::sort(contents.chunks.begin(), contents.chunks.end(), earlier);
  return contents;
}

/// Position of the first chunk or loose record after the last chunk in the index; the end of the chunks if there is
/// none.
/// @param last_chunk position of this last chunk; 0: the index has no chunk
std::uint64_t firstUnlisted(const BagFile& file, std::uint64_t last_chunk)
{
  const std::uint64_t end = std::min(file.indexSection(), file.size());
  try
  {
    std::uint64_t position = last_chunk > 0 ? file.recordAt(last_chunk).end() : file.firstRecord();
    while (position < end)
    {
      const BagFile::Place record = file.recordAt(position);
      const BagOp op = record.header.op();
      if (op == BagOp::chunk || op == BagOp::message || op == BagOp::connection)
      {
        return position;
      }
      position = record.end();
    }
  }
  catch (const BagError&)  // the last chunk is damaged; this is reported when it is read
  {
  }
  return end;
}

/// Reads the records of a bag that no index lists.
class Scan
{
 public:
  /// @param end position at which the records end [B]
  /// @param contents of the index
  Scan(const BagFile& file, const TopicFilter& wanted, std::uint64_t end, BagContents contents = {})
      : file_(file), wanted_(wanted), end_(end), contents_(std::move(contents)), expanded_(file.mostExpanded())
  {
  }

  /// Reads from a position [B] on. @return the contents, with the fault and what could not be read
  BagContents run(std::uint64_t position, const std::string& fault)
  {
    contents_.fault = fault;
    try
    {
      while (position < end_ && !expanded_.isOver())
      {
        position = take(position);
      }
    }
    catch (const BagError&)
    {
      contents_.fault +=
          "; it is unreadable from byte " + std::to_string(position) + " of " + std::to_string(file_.size()) + " on";
    }
    if (!expanded_.isOver())
    {
      finishChunk();
    }
    return std::move(contents_);
  }

 private:
  /// Processes the record at a position. @return position of the next record
  std::uint64_t take(std::uint64_t position)
  {
    const BagFile::Place record = file_.recordAt(position);
    switch (record.header.op())
    {
      case BagOp::chunk:
        return takeChunk(position, record);
      case BagOp::index:
        takeIndex(record);
        return record.end();
      case BagOp::message:
        return takeLoose(position);
      case BagOp::connection:
        addConnection(record.header, file_.dataOf(record), contents_);
        return record.end();
      default:
        return record.end();
    }
  }

  std::uint64_t takeChunk(std::uint64_t position, const BagFile::Place& record)
  {
    finishChunk();
    const bool unfinished = record.length == 0 || record.end() > end_;
    if (!unfinished)
    {
      chunk_ = {position, std::numeric_limits<std::uint64_t>::max(), 0};
      in_chunk_ = true;
      return record.end();
    }
    refuseBagIf(record.header.text("compression") != "none", "an unfinished compressed chunk");
    return takeLoose(record.data);
  }

  void takeIndex(const BagFile::Place& record)
  {
    const auto connection = record.header.number<std::uint32_t>("conn");
    const std::string data = file_.dataOf(record);
    if (contents_.connections.count(connection) == 0 && !damaged_)
    {
      tryToScanChunk(false);
    }
    holds_wanted_ = holds_wanted_ || isWanted(contents_, connection, wanted_);
    std::uint64_t count = 0;
    forEachIndexTime(data,
                     [&](std::uint64_t time)
                     {
                       chunk_.start = std::min(chunk_.start, time);
                       ++count;
                     });
    countMessages(contents_, connection, count);
    indexed_ = indexed_ || count > 0;
  }

  /// Takes all records from a position to the end as an unclosed chunk. @return the end
  std::uint64_t takeLoose(std::uint64_t position)
  {
    if (end_ - position > largest_record)
    {
      contents_.fault += "; only the first 256 MiB are read of the chunk that was not closed";
    }
    chunk_ = {position, std::numeric_limits<std::uint64_t>::max(), end_};
    in_chunk_ = true;
    finishChunk();
    return end_;
  }

  void finishChunk()
  {
    if (in_chunk_ && !indexed_)
    {
      tryToScanChunk(true);
    }
    if (in_chunk_ && holds_wanted_ && !damaged_)
    {
      contents_.chunks.push_back(chunk_);
    }
    in_chunk_ = indexed_ = holds_wanted_ = damaged_ = false;
  }

  /// Scans the current chunk. If it is damaged, it is skipped and reported; the following chunks are still read.
  void tryToScanChunk(bool with_messages)
  {
    try
    {
      scanChunk(chunk_, with_messages);
    }
    catch (const BagError& error)
    {
      damaged_ = true;
      contents_.fault += "; the chunk at byte " + std::to_string(chunk_.position) + ": " + error.what();
    }
  }

  /// Reads the connections of a chunk.
  /// @param with_messages true: also reads the times and numbers of its messages, if the chunk has no index records
  void scanChunk(BagChunk& chunk, bool with_messages)
  {
    forEachRecord(chunkRecords(file_, chunk, expanded_),
                  [&](const BagRecord& record)
                  {
                    if (record.header.op() == BagOp::connection)
                    {
                      addConnection(record.header, record.data, contents_);
                    }
                    else if (record.header.op() == BagOp::message && with_messages)
                    {
                      chunk.start = std::min(chunk.start, record.header.time("time"));
                      const auto connection = record.header.number<std::uint32_t>("conn");
                      countMessages(contents_, connection, 1);
                      holds_wanted_ = holds_wanted_ || isWanted(contents_, connection, wanted_);
                    }
                  });
  }

  const BagFile& file_;
  const TopicFilter& wanted_;
  std::uint64_t end_;  ///< of the records [B]
  BagContents contents_;
  ExpandedSize expanded_;
  BagChunk chunk_;             ///< chunk to which the current index records belong
  bool in_chunk_ = false;      ///< `chunk_` is valid
  bool indexed_ = false;       ///< its index records contain messages
  bool holds_wanted_ = false;  ///< it contains messages of wanted topics
  bool damaged_ = false;       ///< it cannot be read
};

/// The complete message and connection records at the beginning of `bytes`.
std::string wholeRecords(std::string bytes)
{
  std::size_t length = 0;
  try
  {
    while (length < bytes.size())
    {
      const BagRecord record = recordAt(std::string_view(bytes).substr(length));
      if (record.header.op() != BagOp::message && record.header.op() != BagOp::connection)
      {
        break;
      }
      length += record.length;
    }
  }
  catch (const BagError&)  // the remaining bytes are not a complete record
  {
  }
  bytes.resize(length);
  return bytes;
}
}  // namespace

bool isWanted(const BagContents& contents, std::uint32_t connection, const TopicFilter& wanted)
{
  const auto found = contents.connections.find(connection);
  return found != contents.connections.end() && wanted(found->second.topic);
}

BagContents readContents(const BagFile& file, const TopicFilter& wanted, const BagSpan& span)
{
  BagContents contents;
  std::uint64_t last_chunk = 0;
  try
  {
    contents = readIndexSection(file, wanted, span, last_chunk);
  }
  catch (const BagError& error)
  {
    return Scan(file, wanted, file.size())
        .run(file.firstRecord(), std::string("the bag has no usable index: ") + error.what());
  }
  const std::uint64_t unlisted = firstUnlisted(file, last_chunk), end = std::min(file.indexSection(), file.size());
  if (unlisted == end)
  {
    return contents;
  }
  return Scan(file, wanted, end, std::move(contents))
      .run(unlisted, "the index of the bag does not list the records from byte " + std::to_string(unlisted) + " on");
}

std::string chunkRecords(const BagFile& file, const BagChunk& chunk, ExpandedSize& expanded)
{
  if (chunk.loose_end > 0)
  {
    return wholeRecords(file.bytes(chunk.position, std::min(chunk.loose_end - chunk.position, largest_record)));
  }
  const BagFile::Place record = file.recordAt(chunk.position);
  refuseBagIf(record.header.op() != BagOp::chunk, "there is no chunk at byte ", chunk.position);
  return decompressed(record.header.text("compression"), file.dataOf(record),
                      record.header.number<std::uint32_t>("size"), expanded);
}

void addConnection(const BagFields& record_header, std::string_view data, BagContents& contents)
{
  const auto number = record_header.number<std::uint32_t>("conn");
  if (contents.connections.count(number) == 0)
  {
    refuseBagIf(contents.connections.size() == most_connections, "more than ", most_connections, " connections");
    contents.connections[number] = {record_header.text("topic"), BagFields(data)};
  }
}
}  // namespace wheel_rail_contact
