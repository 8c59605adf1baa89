// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/replay/join.h"

#include <algorithm>
#include <map>
#include <memory>
#include <sstream>

#include "wheel_rail_contact/bag/bag_stream.h"
#include "wheel_rail_contact/bag/bag_writer.h"
#include "wheel_rail_contact/replay/replay_options.h"

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

bool isAnswers(const BagConnection& connection)
{
  return connection.header.has(description_field);
}

/// Connections of answers by their numbers, which are those of the wheelsets.
using Connections = std::map<std::uint32_t, BagConnection>;

Connections answersOf(const std::vector<std::string>& parts)
{
  Connections answers;
  std::string whole;
  std::uint64_t end = 0;
  for (const std::string& part : parts)
  {
    const BagContents contents = readContents(BagFile(part), [](const std::string&) { return true; });
    std::uint64_t own_end = end;
    for (auto [number, connection] : contents.connections)
    {
      if (isAnswers(connection))
      {
        const Description description = descriptionOf(connection);
        if ((!whole.empty() && description.whole != whole) || description.span.from < end)
        {
          throw BagError(part + ": is not a later part of the same replay as those before it");
        }
        whole = description.whole;
        own_end = description.span.to;
        connection.header.set(description_field, whole);
        answers.emplace(number, std::move(connection));
      }
    }
    end = own_end;
  }
  return answers;
}

/// Writes one part after the other.
class Joiner
{
 public:
  Joiner(const Connections& answers, const std::string& output, const std::string& compression)
      : writer_(output, compression)
  {
    for (const auto& [number, connection] : answers)
    {
      while (wheelsets_ < number)  // has no answer, but its number
      {
        addWheelset({});
      }
      addWheelset(connection);
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
  void addWheelset(const BagConnection& connection)
  {
    writer_.addConnection(connection);
    sequence_.push_back(0);
    ++wheelsets_;
  }

  void write(const BagMessage& message)
  {
    ++messages_;
    if (!isAnswers(*message.connection))
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
  std::uint32_t wheelsets_ = 0;
  std::vector<std::uint32_t> sequence_;             ///< of the next answer, by wheelset
  std::map<std::uint32_t, std::uint32_t> kept_;     ///< numbers in the output by those in the part
  std::map<std::string, std::uint32_t> by_header_;  ///< numbers in the output of connections that were kept
  std::uint64_t messages_ = 0;
};
}  // namespace

std::uint64_t joinParts(const std::vector<std::string>& parts, const std::string& output,
                        const std::string& compression)
{
  Joiner joiner(answersOf(parts), output, compression);
  for (const std::string& part : parts)
  {
    joiner.add(part);
  }
  return joiner.finish();
}
}  // namespace wheel_rail_contact
