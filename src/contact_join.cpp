// SPDX-License-Identifier: BSD-3-Clause
// Joins the results of consecutive parts of a bag (contact_replay with --from and --to). contact_campaign calls it.
//
//   contact_join [--lz4] OUT.bag PART.bag...
#include <boost/program_options.hpp>
#include <cstdint>
#include <exception>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bag/bag_stream.h"
#include "bag/bag_writer.h"
#include "replay/replay_options.h"
#include "replay/replay_source.h"

namespace wheel_rail_contact
{
namespace
{
/// Description of a part: that of the replay of the whole bag, and the span of recording times of the part.
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

/// Topics of the results of a replay with this description. The index is the number of the connection.
std::vector<std::string> topicsOf(const std::string& description)
{
  std::vector<std::string> topics;
  for (const std::string& wheelset : describedWheelsets(description))
  {
    topics.push_back(resultTopic(wheelset));
  }
  return topics;
}

/// Connections by number.
using Connections = std::map<std::uint32_t, BagConnection>;

/// Topics of the results of this replay. With --keep-topics, the parts may also contain results of an earlier replay.
/// Their connections have higher numbers than those of the wheelsets, so the lowest number belongs to this replay.
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

/// Collects the connections of the results and checks that the parts follow one another without a gap.
class Results
{
 public:
  explicit Results(const std::vector<std::string>& parts)
  {
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

  /// Connections of the results by wheelset; empty for a wheelset without results.
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
    refuseBagIf(!is_own || (!whole_.empty() && description.whole != whole_) || description.span.from < end_,
                part + ": is not a later part of the same replay as the parts before it");
    whole_ = description.whole;
    connection.header.set(description_field, whole_);
    connections_[number] = std::move(connection);
    return description.span;
  }

  /// A part without results does not contain its span. A gap next to such a part is not detected.
  void requireNoGap(const std::string& part, std::uint64_t next) const
  {
    refuseBagIf(
        is_end_known_ && end_ < next,
        part + ": the part that begins at " + std::to_string(end_) + " ns is missing" +
            (next < std::numeric_limits<std::uint64_t>::max() ? "; this part begins at " + std::to_string(next) + " ns"
                                                              : "; this is the last part"));
  }

  std::vector<std::string> topics_;  ///< by wheelset
  std::vector<BagConnection> connections_;
  std::string whole_;         ///< description of the replay of the whole bag
  std::uint64_t end_ = 0;     ///< of the last part with results [ns]
  bool is_end_known_ = true;  ///< false after a part without results
};

/// Appends the parts to the output.
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
    // A result begins with `seq` of its header: its number among the results of its wheelset.
    std::string data = bytesOf(sequence_[message.connection_id]++);
    writer_.write(message.connection_id, message.time, data.append(message.data.substr(data.size())));
  }

  /// Connection number in the output of a copied message. The parts may give one connection different numbers.
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
  std::vector<std::uint32_t> sequence_;             ///< of the next result, by wheelset
  std::map<std::uint32_t, std::uint32_t> kept_;     ///< numbers in the output by numbers in the part
  std::map<std::string, std::uint32_t> by_header_;  ///< numbers in the output of copied connections
  std::uint64_t messages_ = 0;
};

/// Joins the results of consecutive parts of one bag (contact_replay with --from and --to). The output is identical to
/// the file that one replay of the whole bag writes: to the last byte, with --keep-topics to the last message.
/// @param parts in their order, at least one
/// @param compression none or lz4, as that of the parts
/// @return number of messages written
/// @throw BagError if a part is damaged, does not belong to the same replay, is out of order or is missing, or if the
/// output exists. A part without results does not contain its span; a gap next to such a part is not detected.
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
}  // namespace
}  // namespace wheel_rail_contact

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  using po::command_line_style::allow_guessing;
  using po::command_line_style::unix_style;
  po::options_description described("usage: contact_join [--lz4] OUT.bag PART.bag...");
  described.add_options()("lz4", po::bool_switch(), "compresses OUT.bag; for parts that are compressed")(
      "help,h", po::bool_switch(), "prints this text");
  try
  {
    const po::parsed_options parsed =
        po::command_line_parser(argc, argv).options(described).style(unix_style ^ allow_guessing).run();
    po::variables_map values;
    po::store(parsed, values);
    const std::vector<std::string> files = po::collect_unrecognized(parsed.options, po::include_positional);
    if (values["help"].as<bool>())
    {
      std::cout << described;
      return 0;
    }
    if (files.size() < 2)
    {
      throw po::error("OUT.bag and at least one PART.bag are required");
    }
    const std::vector<std::string> parts(files.begin() + 1, files.end());
    const std::string compression = values["lz4"].as<bool>() ? "lz4" : "none";
    std::cout << wheel_rail_contact::joinParts(parts, files.front(), compression) << " messages\n";
    return 0;
  }
  catch (const po::error& error)
  {
    std::cerr << "contact_join: " << error.what() << "\n(contact_join --help)\n";
    return 2;
  }
  catch (const std::exception& error)
  {
    std::cerr << "contact_join: " << error.what() << '\n';
    return 1;
  }
}
