// SPDX-License-Identifier: BSD-3-Clause
#include "replay/join.h"

#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "bag/bag_stream.h"
#include "bag/bag_writer.h"
#include "replay/replay_options.h"
#include "replay/replay_source.h"

namespace wheel_rail_contact
{
namespace
{
/// The description of a whole replay, and the stretch of the part that a part's description tells beside it.
struct Description
{
  std::string whole;
  BagSpan span;
};

Description descriptionOf(const BagConnection& connection)
{
  const std::string& text = connection.header.text(description_field);
  const std::size_t line = text.rfind(part_line);
  Description description{text.substr(0, line), {}};
  if (line != std::string::npos)
  {
    std::string word;
    std::istringstream(text.substr(line)) >> word >> description.span.from >> word >> word >> description.span.to;
  }
  return description;
}

/// Topics of the answers, by the numbers of their connections, of a replay with this description.
std::vector<std::string> topicsOf(const std::string& description)
{
  std::vector<std::string> topics;
  for (const std::string& wheelset : describedWheelsets(description))
  {
    topics.push_back(resultTopic(wheelset));
  }
  return topics;
}

/// By their numbers.
using Connections = std::map<std::uint32_t, BagConnection>;

/// Topics of the parts' own answers. A bag whose topics were kept may hold answers of an earlier replay too; their
/// connections are numbered after those of the wheelsets, so that the lowest number is the parts' own.
std::vector<std::string> topicsOf(const std::vector<Connections>& parts)
{
  std::vector<std::string> topics;
  std::uint32_t lowest = std::numeric_limits<std::uint32_t>::max();
  for (const Connections& connections : parts)
  {
    for (const auto& [number, connection] : connections)
    {
      if (number < lowest && connection.header.has(description_field))
      {
        const std::vector<std::string> described = topicsOf(connection.header.text(description_field));
        if (number < described.size() && described[number] == connection.topic)
        {
          lowest = number;
          topics = described;
        }
      }
    }
  }
  return topics;
}

/// Collects the parts' answers and checks that the parts follow one another.
class Results
{
 public:
  explicit Results(const std::vector<std::string>& parts)
  {
    if (parts.empty())
    {
      throw std::invalid_argument("parts: must be one or more");
    }
    std::vector<Connections> connections;
    connections.reserve(parts.size());
    for (const std::string& part : parts)
    {
      connections.push_back(readContents(BagFile(part), [](const std::string&) { return true; }).connections);
    }
    topics_ = topicsOf(connections);
    connections_.resize(topics_.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      take(parts[i], connections[i]);
    }
    requireNoGap(parts.back(), std::numeric_limits<std::uint64_t>::max());
  }

  /// By wheelset; empty for one without answers.
  const std::vector<BagConnection>& connections() const { return connections_; }

 private:
  void take(const std::string& part, const Connections& connections)
  {
    const auto own_end = connections.lower_bound(static_cast<std::uint32_t>(topics_.size()));
    BagSpan span;
    for (auto own = connections.begin(); own != own_end; ++own)
    {
      span = take(part, own->first, own->second);
    }
    if (own_end == connections.begin())
    {
      is_end_known_ = false;
      return;
    }
    requireNoGap(part, span.from);
    end_ = span.to;
    is_end_known_ = true;
  }

  BagSpan take(const std::string& part, std::uint32_t number, BagConnection connection)
  {
    const bool is_own = connection.topic == topics_[number] && connection.header.has(description_field);
    const Description description = is_own ? descriptionOf(connection) : Description{};
    if (!is_own || (!whole_.empty() && description.whole != whole_) || description.span.from < end_)
    {
      throw BagError(part + ": is not a later part of the same replay as those before it");
    }
    whole_ = description.whole;
    connection.header.set(description_field, whole_);
    connections_[number] = std::move(connection);
    return description.span;
  }

  /// A part without answers does not tell its stretch: after it, how much is missing is not known.
  void requireNoGap(const std::string& part, std::uint64_t next) const
  {
    if (is_end_known_ && end_ < next)
    {
      throw BagError(part + ": a part is missing that begins at " + std::to_string(end_) + " ns" +
                     (next < std::numeric_limits<std::uint64_t>::max()
                          ? ", before this one at " + std::to_string(next) + " ns"
                          : ", after this one"));
    }
  }

  std::vector<std::string> topics_;  ///< by wheelset
  std::vector<BagConnection> connections_;
  std::string whole_;         ///< description
  std::uint64_t end_ = 0;     ///< of the last part with answers [ns]
  bool is_end_known_ = true;  ///< no part without answers came after it
};

/// Writes one part after the other.
class Joiner
{
 public:
  Joiner(const std::vector<BagConnection>& results, const std::string& output, const std::string& compression)
      : writer_(output, compression), sequence_(results.size(), 0)
  {
    for (const BagConnection& connection : results)
    {
      writer_.addConnection(connection);
    }
  }

  void add(const std::string& part)
  {
    kept_.clear();
    BagStream stream(part, [](const std::string&) { return true; });
    while (const auto message = stream.next())
    {
      write(*message);
    }
    if (!stream.faults().empty())
    {
      throw BagError(part + ": " + stream.faults().front());
    }
  }

  std::uint64_t finish()
  {
    writer_.close();
    return messages_;
  }

 private:
  void write(const BagMessage& message)
  {
    ++messages_;
    if (message.connection_id >= sequence_.size())
    {
      writer_.write(numberOf(message), message.time, message.data);
      return;
    }
    // An answer begins with its header, and that with `seq`: its number among those of its wheelset.
    std::string data = bytesOf(sequence_[message.connection_id]++);
    writer_.write(message.connection_id, message.time, data.append(message.data.substr(data.size())));
  }

  /// Number of a message that was kept. Parts number the same connection by when they come to it.
  std::uint32_t numberOf(const BagMessage& message)
  {
    const auto known = kept_.find(message.connection_id);
    if (known != kept_.end())
    {
      return known->second;
    }
    const auto [place, is_new] = by_header_.emplace(message.connection->header.bytes(), 0);
    place->second = is_new ? writer_.addConnection(*message.connection) : place->second;
    return kept_[message.connection_id] = place->second;
  }

  BagWriter writer_;
  std::vector<std::uint32_t> sequence_;             ///< of the next answer, by wheelset
  std::map<std::uint32_t, std::uint32_t> kept_;     ///< numbers in the output by those in the part
  std::map<std::string, std::uint32_t> by_header_;  ///< numbers in the output of connections that were kept
  std::uint64_t messages_ = 0;
};
}  // namespace

std::uint64_t joinParts(const std::vector<std::string>& parts, const std::string& output,
                        const std::string& compression)
{
  Joiner joiner(Results(parts).connections(), output, compression);
  for (const std::string& part : parts)
  {
    joiner.add(part);
  }
  return joiner.finish();
}
}  // namespace wheel_rail_contact
