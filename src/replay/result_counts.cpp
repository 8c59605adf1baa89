// SPDX-License-Identifier: BSD-3-Clause
#include "replay/result_counts.h"

#include <std_msgs/Header.h>

#include <ostream>

#include <wheel_rail_contact/WheelsetContact.h>
#include "bag/bag_stream.h"
#include "replay/bag_messages.h"
#include "ros/evaluation/conversions.h"
#include "ros/evaluation/hold_last.h"
#include "ros/evaluation/text.h"

namespace wheel_rail_contact
{
namespace
{
std::string percent(std::uint64_t part, std::uint64_t all)
{
  return formatted("%.1f", 100 * static_cast<double>(part) / static_cast<double>(all));
}

/// Adds a result from the bytes of its message, of which only the first fields are read.
/// @return its status
std::uint8_t addResult(std::string_view data, ResultCounts& counts)
{
  std::uint8_t status = 0;
  readStream(data,
             [&counts, &status](auto& stream)
             {
               std_msgs::Header header;
               std::string reason;
               bool held = false;
               stream.next(header);
               stream.next(status);
               stream.next(reason);
               stream.next(held);
               counts.add(status, status == WheelsetContact::OK ? std::string() : reason, held);
             });
  return status;
}

void keepLast(std::uint8_t status, std::string data, RecordedResults& last)
{
  if (isUsable(status))
  {
    last.clear();
  }
  last.emplace_back(status, std::move(data));
  if (last.size() > static_cast<std::size_t>(HoldLast::memory) + 1)
  {
    last.pop_front();
  }
}
}  // namespace

void ResultCounts::add(std::uint8_t status, const std::string& reason, bool held)
{
  held_ += held ? 1U : 0U;
  if (counts_.at(status)++ == 0)
  {
    first_reasons_[status] = reason;
  }
}

std::uint64_t ResultCounts::unusableInputs() const
{
  return counts_[WheelsetContact::INVALID_INPUT] + counts_[WheelsetContact::NO_TRANSFORM];
}

void ResultCounts::print(std::ostream& out, std::uint64_t poses) const
{
  for (std::size_t status = 0; status < counts_.size(); ++status)
  {
    if (counts_[status] > 0)
    {
      out << "  " << statusName(static_cast<std::uint8_t>(status)) << ": " << counts_[status] << " ("
          << percent(counts_[status], poses) << " %)" << (first_reasons_[status].empty() ? "" : "; first reason: ")
          << first_reasons_[status] << "\n";
    }
  }
  if (held_ > 0)
  {
    out << "  held: " << held_ << " (" << percent(held_, poses) << " %); forces of the last usable result\n";
  }
}

ResultCounts resumedResults(const std::string& path, const BagResumePoint& resume_point,
                            std::vector<RecordedResults>& last)
{
  ResultCounts counts;
  if (resume_point.messages == 0)
  {
    return counts;
  }
  BagStream stream(path, [](const std::string&) { return true; });
  std::uint64_t messages = 0;
  while (const auto message = stream.next())
  {
    ++messages;
    if (message->connection_id < last.size())
    {
      const std::uint8_t status = addResult(message->data, counts);
      keepLast(status, std::string(message->data), last[message->connection_id]);
    }
  }
  if (messages != resume_point.messages)
  {
    throw BagError(path + ": cannot be resumed; " + std::to_string(messages) + " of its " +
                   std::to_string(resume_point.messages) + " messages can be read");
  }
  return counts;
}
}  // namespace wheel_rail_contact
