// SPDX-License-Identifier: BSD-3-Clause
#include "bag/bag_writer.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace wheel_rail_contact
{
namespace
{
constexpr std::uint32_t version = 1;  ///< of index and chunk info records
constexpr int permissions = 0666;     ///< reduced by the umask

std::string chunkInfoRecord(std::uint64_t position, std::uint64_t start, std::uint64_t end,
                            const std::map<std::uint32_t, std::uint32_t>& counts)
{
  BagFields header;
  header.set(BagOp::chunk_info)
      .set("ver", bytesOf(version))
      .set("chunk_pos", bytesOf(position))
      .set("start_time", timeBytes(start))
      .set("end_time", timeBytes(end))
      .set("count", bytesOf(static_cast<std::uint32_t>(counts.size())));
  std::string data;
  for (const auto& [connection, count] : counts)
  {
    data += bytesOf(connection) + bytesOf(count);
  }
  std::string record;
  appendRecord(header, data, record);
  return record;
}
}  // namespace

BagWriter::BagWriter(const std::string& path, std::string compression)
    : path_(path),
      compression_(std::move(compression)),
      descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions)),
      already_there_(0)
{
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
  {
    fail();
  }
  put(bag_magic);
  writeBagHeader();
}

BagWriter::BagWriter(const std::string& path, std::string compression, const BagResumePoint& resume_point)
    : path_(path),
      compression_(std::move(compression)),
      descriptor_(open(path.c_str(), O_WRONLY | O_CLOEXEC)),
      already_there_(resume_point.messages),
      position_(bag_magic.size()),
      chunk_infos_(resume_point.chunk_infos),
      chunks_(resume_point.chunks)
{
  if (descriptor_ < 0)
  {
    fail();
  }
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 || ftruncate(descriptor_, static_cast<off_t>(resume_point.end)) != 0)
  {
    const int reason = errno;
    ::close(descriptor_);
    errno = reason;
    fail();
  }
  lseek(descriptor_, static_cast<off_t>(position_), SEEK_SET);
  writeBagHeader();
  position_ = resume_point.end;
  lseek(descriptor_, static_cast<off_t>(position_), SEEK_SET);
}

BagWriter::~BagWriter()
{
  if (descriptor_ >= 0)
  {
    ::close(descriptor_);
  }
}

void BagWriter::fail() const
{
  throw BagError(path_ + ": " + std::generic_category().message(errno));
}

void BagWriter::put(std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR)
    {
      continue;
    }
    if (done < 0)
    {
      fail();
    }
    bytes.remove_prefix(static_cast<std::size_t>(done));
    position_ += static_cast<std::uint64_t>(done);
  }
}

/// Writes the bag header. Before the index section exists, its position and the counts are 0: the bag is not closed.
void BagWriter::writeBagHeader()
{
  const auto written = std::count_if(connections_.begin(), connections_.end(),
                                     [](const Connection& connection) { return connection.written; });
  BagFields header;
  header.set(BagOp::bag_header)
      .set("index_pos", bytesOf(index_section_))
      .set("conn_count", bytesOf(static_cast<std::uint32_t>(index_section_ > 0 ? written : 0)))
      .set("chunk_count", bytesOf(index_section_ > 0 ? chunks_ : 0));
  const std::size_t lengths = 2 * sizeof(std::uint32_t);
  std::string record;
  appendRecord(header, std::string(bag_header_length - lengths - header.bytes().size(), ' '), record);
  put(record);
}

std::uint32_t BagWriter::addConnection(const BagConnection& connection)
{
  const auto number = static_cast<std::uint32_t>(connections_.size());
  BagFields header;
  header.set(BagOp::connection).set("conn", bytesOf(number)).set("topic", connection.topic);
  connections_.emplace_back();
  appendRecord(header, connection.header.bytes(), connections_.back().record);
  return number;
}

void BagWriter::write(std::uint32_t connection, std::uint64_t time, std::string_view data)
{
  Connection& writer = connections_.at(connection);
  if (already_there_ > 0)
  {
    --already_there_;
    writer.written = true;
    return;
  }
  chunk_start_ = chunk_.empty() ? time : std::min(chunk_start_, time);
  chunk_end_ = chunk_.empty() ? time : std::max(chunk_end_, time);
  if (!std::exchange(writer.written, true))
  {
    chunk_ += writer.record;
  }
  writer.index += timeBytes(time) + bytesOf(static_cast<std::uint32_t>(chunk_.size()));
  BagFields header;
  header.set(BagOp::message).set("conn", bytesOf(connection)).set("time", timeBytes(time));
  appendRecord(header, data, chunk_);
  if (chunk_.size() >= full_chunk)
  {
    finishChunk();
  }
}

/// Writes the chunk and its index records at once. A killed process then rarely leaves an incomplete chunk.
void BagWriter::finishChunk()
{
  if (on_chunk_)
  {
    on_chunk_();
  }
  std::string bytes;
  BagFields header;
  header.set(BagOp::chunk)
      .set("compression", compression_)
      .set("size", bytesOf(static_cast<std::uint32_t>(chunk_.size())));
  appendRecord(header, compressed(compression_, std::exchange(chunk_, {})), bytes);
  std::map<std::uint32_t, std::uint32_t> counts;
  for (std::uint32_t number = 0; number < connections_.size(); ++number)
  {
    std::string& index = connections_[number].index;
    if (index.empty())
    {
      continue;
    }
    counts[number] = static_cast<std::uint32_t>(index.size() / index_entry_length);
    BagFields index_header;
    index_header.set(BagOp::index)
        .set("ver", bytesOf(version))
        .set("conn", bytesOf(number))
        .set("count", bytesOf(counts[number]));
    appendRecord(index_header, index, bytes);
    index.clear();
  }
  chunk_infos_ += chunkInfoRecord(position_, chunk_start_, chunk_end_, counts);
  ++chunks_;
  put(bytes);
}

void BagWriter::close()
{
  if (!chunk_.empty())
  {
    finishChunk();
  }
  index_section_ = position_;
  for (const Connection& connection : connections_)
  {
    put(connection.written ? connection.record : "");
  }
  put(chunk_infos_);
  if (lseek(descriptor_, static_cast<off_t>(bag_magic.size()), SEEK_SET) < 0)
  {
    fail();
  }
  writeBagHeader();
  if (::close(std::exchange(descriptor_, -1)) != 0)
  {
    fail();
  }
}

namespace
{
/// A chunk of an unfinished bag, with the content of its index records.
struct FoundChunk
{
  std::uint64_t position = 0, size = 0;
  std::uint64_t start = std::numeric_limits<std::uint64_t>::max(), end = 0;
  std::map<std::uint32_t, std::uint32_t> counts;

  void addIndex(const BagFields& header, std::string_view entries)
  {
    counts[header.number<std::uint32_t>("conn")] = header.number<std::uint32_t>("count");
    forEachIndexTime(entries,
                     [this](std::uint64_t time)
                     {
                       start = std::min(start, time);
                       end = std::max(end, time);
                     });
  }

  void addTo(BagResumePoint& resume_point) const
  {
    resume_point.chunk_infos += chunkInfoRecord(position, start, end, counts);
    ++resume_point.chunks;
    for (const auto& entry : counts)
    {
      resume_point.messages += entry.second;
    }
  }
};
}  // namespace

BagResumePoint resumePointOf(const BagFile& file)
{
  BagResumePoint resume_point;
  resume_point.end = file.firstRecord();
  FoundChunk chunk;
  try
  {
    for (std::uint64_t position = file.firstRecord(); position < file.size();)
    {
      const BagFile::Place record = file.recordAt(position);
      if (record.header.op() == BagOp::index)
      {
        chunk.addIndex(record.header, file.dataOf(record));
      }
      else  // the preceding chunk is complete
      {
        if (chunk.size >= BagWriter::full_chunk)
        {
          chunk.addTo(resume_point);
          resume_point.end = position;
        }
        if (record.header.op() != BagOp::chunk)
        {
          break;
        }
        chunk = FoundChunk();
        chunk.position = position;
        chunk.size = record.header.number<std::uint32_t>("size");
      }
      position = record.end();
    }
  }
  catch (const BagError&)  // truncated here
  {
  }
  return resume_point;
}
}  // namespace wheel_rail_contact
