// SPDX-License-Identifier: BSD-3-Clause
#include "bag/bag_stream.h"

#include <algorithm>
#include <utility>

namespace wheel_rail_contact
{
constexpr std::size_t most_faults = 20;           ///< reported individually
constexpr std::size_t most_open_bytes = 1 << 27;  ///< limit for chunks that overlap in time [B]

bool BagStream::Later::operator()(const std::unique_ptr<OpenChunk>& a, const std::unique_ptr<OpenChunk>& b) const
{
  const auto key = [](const OpenChunk& chunk)
  { return std::make_pair(chunk.entries[chunk.next].time, chunk.position); };
  return key(*a) > key(*b);
}

BagStream::BagStream(const std::string& path, TopicFilter wanted, const BagSpan& span, std::uint64_t most_expanded)
    : wanted_(std::move(wanted)),
      from_(span.from),
      file_(path, most_expanded),
      contents_(readContents(file_, wanted_, span)),
      expanded_(file_.mostExpanded())
{
  const auto earlier = [](const BagChunk& a, const BagChunk& b) { return a.start < b.start; };
  std::stable_sort(contents_.chunks.begin(), contents_.chunks.end(), earlier);
  if (!contents_.fault.empty())
  {
    report(contents_.fault);
  }
}

std::optional<BagMessage> BagStream::next()
{
  if (!open_.empty() && open_.back()->next == open_.back()->entries.size())
  {
    open_.pop_back();
  }
  else if (!open_.empty())
  {
    std::push_heap(open_.begin(), open_.end(), Later());
  }
  openDueChunks();
  if (open_.empty())
  {
    return std::nullopt;
  }
  std::pop_heap(open_.begin(), open_.end(), Later());
  OpenChunk& chunk = *open_.back();
  const Entry& entry = chunk.entries[chunk.next++];
  return BagMessage{entry.connection, &contents_.connections.at(entry.connection), entry.time, entry.data};
}

/// Opens the chunks that may contain the next message.
void BagStream::openDueChunks()
{
  const auto& chunks = contents_.chunks;
  while (next_chunk_ < chunks.size() && !expanded_.isOver() &&
         (open_.empty() || chunks[next_chunk_].start <= open_.front()->entries[open_.front()->next].time))
  {
    open(chunks[next_chunk_++]);
  }
}

void BagStream::open(const BagChunk& chunk)
{
  auto opened = std::make_unique<OpenChunk>();
  opened->position = chunk.position;
  try
  {
    opened->records = chunkRecords(file_, chunk, expanded_);
    listMessages(*opened);
  }
  catch (const BagError& error)
  {
    report("the chunk at byte " + std::to_string(chunk.position) + ": " + error.what());
  }
  if (opened->entries.empty())
  {
    return;
  }
  std::stable_sort(opened->entries.begin(), opened->entries.end(),
                   [](const Entry& a, const Entry& b) { return a.time < b.time; });
  open_.push_back(std::move(opened));
  std::push_heap(open_.begin(), open_.end(), Later());
  std::size_t bytes = 0;
  for (const auto& other : open_)
  {
    bytes += other->records.size();
  }
  refuseBagIf(open_.size() > 1 && bytes > most_open_bytes,
              file_.path() + ": more than 128 MiB of chunks overlap in time; sort the bag first (rosbag filter)");
}

/// Lists the wanted messages of a chunk in their order in the chunk. Messages before a damaged record are kept.
void BagStream::listMessages(OpenChunk& chunk)
{
  forEachRecord(chunk.records,
                [&](const BagRecord& record)
                {
                  const auto id = record.header.number<std::uint32_t>("conn");
                  if (record.header.op() == BagOp::connection)
                  {
                    addConnection(record.header, record.data, contents_);
                  }
                  else if (record.header.op() == BagOp::message && isWanted(contents_, id, wanted_) &&
                           record.header.time("time") >= from_)
                  {
                    chunk.entries.push_back({record.header.time("time"), id, record.data});
                  }
                });
}

void BagStream::report(const std::string& fault)
{
  if (faults_.size() < most_faults)
  {
    faults_.push_back(fault);
  }
  else if (faults_.size() == most_faults)
  {
    faults_.emplace_back("further faults are not listed");
  }
}
}  // namespace wheel_rail_contact
