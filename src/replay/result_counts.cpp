// SPDX-License-Identifier: BSD-3-Clause
#include "replay/result_counts.h"

#include <ostream>

#include "bag/bag_stream.h"
#include "config/text.h"
#include "replay/bag_messages.h"

namespace wheel_rail_contact
{
namespace
{
std::string percent(std::uint64_t part, std::uint64_t all)
{
  return formatted("%.1f", 100 * static_cast<double>(part) / static_cast<double>(all));
}
}  // namespace

void ResultCounts::add(std::uint8_t status, const std::string& reason, bool held)
{
  held_ += held ? 1U : 0U;
  if (counts_.at(status)++ == 0)
  {
    first_reasons_[status] = status == WheelsetContact::OK ? "" : reason;
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

ResultCounts resumedResults(const std::string& path, const BagResumePoint& resume_point, std::size_t wheelsets)
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
    if (message->connection_id < wheelsets)
    {
      const auto head = parse<ResultHead>(message->data);
      counts.add(head->status, head->status_text, head->held);
    }
  }
  refuseBagIf(messages != resume_point.messages, path + ": cannot be resumed; " + std::to_string(messages) +
                                                     " of its " + std::to_string(resume_point.messages) +
                                                     " messages can be read");
  return counts;
}
}  // namespace wheel_rail_contact
