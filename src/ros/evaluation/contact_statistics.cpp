// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/contact_statistics.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

#include "config/text.h"
#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

constexpr std::array<const char*, PairingCounts::reasons> drop_names{
    "no message with a matching stamp",
    "second load with the same stamp (sync/load: interpolate)",
    "time went back",
    "queue full while waiting for a match",
    "stamp 0, which means that the stamp is unknown",
    "no load before and after it within sync/longest_gap",
    "load not needed, because no pose is next to it"};
constexpr const char* truncated_name = "truncated or damaged";

template <typename Counts>
std::uint64_t total(const Counts& counts)
{
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

void summarize(const ContactStatistics& now, const ContactStatistics& before,
               diagnostic_updater::DiagnosticStatusWrapper& report)
{
  using Count = std::uint64_t;
  struct Finding
  {
    bool is_true;
    unsigned char level;
    std::string text;
  };
  const Count evaluated = now.evaluated() - before.evaluated();
  const Count unusable = evaluated - (now.usable() - before.usable());
  const Count dropped = now.dropped() - before.dropped();
  const Count unstamped = now.pairing[DropReason::unstamped] - before.pairing[DropReason::unstamped];
  const auto since = [&](Count ContactStatistics::*count) { return now.*count - before.*count; };
  const auto part = [&](Count count)
  { return std::to_string(count) + " of " + std::to_string(evaluated) + " results "; };
  const auto warning = [&](Count ContactStatistics::*count, const std::string& text) -> Finding {
    return {since(count) > 0, DiagnosticStatus::WARN, part(since(count)) + text};
  };
  const Finding findings[] = {
      {since(&ContactStatistics::internal_errors) > 0, DiagnosticStatus::ERROR, "internal error: " + now.last_reason},
      {evaluated > 0 && unusable == evaluated, DiagnosticStatus::ERROR, "no usable result: " + now.last_reason},
      {unusable > 0, DiagnosticStatus::WARN, part(unusable) + "not usable: " + now.last_reason},
      {evaluated > 0 && !now.load_doubt.empty(), DiagnosticStatus::WARN, now.load_doubt},
      warning(&ContactStatistics::implausible_force, "with an implausible wheel force: " + now.last_reason),
      {unstamped > 0, DiagnosticStatus::WARN,
       std::to_string(unstamped) + " messages dropped: their stamp is 0, which means unknown"},
      {dropped > 0, DiagnosticStatus::WARN, std::to_string(dropped) + " inputs dropped"},
      {evaluated == 0 && now.pairing.received > before.pairing.received, DiagnosticStatus::WARN,
       "no inputs with matching stamps"},
      warning(&ContactStatistics::lacking_neighbour, "lack a neighbour's forces"),
      {since(&ContactStatistics::beyond_linear_range) > 0, DiagnosticStatus::WARN, now.last_beyond_linear_range},
      warning(&ContactStatistics::above_tolerance, "with an error estimate above contact/tolerance"),
      {evaluated > 0, DiagnosticStatus::OK, std::to_string(evaluated) + " results"},
      {true, DiagnosticStatus::OK, "no input"}};
  const Finding& first =
      *std::find_if(std::begin(findings), std::end(findings), [](const Finding& finding) { return finding.is_true; });
  report.summary(first.level, first.text);
}
}  // namespace

const char* statusName(std::uint8_t status)
{
  return nameOf(static_cast<core::ContactStatus>(status));
}

std::string dropText(DropReason reason, const PairingCounts& counts)
{
  std::string text = drop_names.at(static_cast<std::size_t>(reason));
  if (reason == DropReason::unmatched && counts.smallest_miss < std::numeric_limits<std::int64_t>::max())
  {
    text += formatted(", the stamps differ by %.3g s or more: see sync/slop, or sync/load for loads of another rate",
                      1e-9 * static_cast<double>(counts.smallest_miss));
  }
  return text;
}

void ContactStatistics::count(const ContactOutput& output)
{
  ++results.at(output.status);
  held += output.held ? 1U : 0U;
  if (!output.beyond_linear_range.empty())
  {
    ++beyond_linear_range;
    last_beyond_linear_range = output.beyond_linear_range;
  }
  if (!output.rejected)
  {
    loads.add(output.state, output.status == WheelsetContact::LIFT_OFF);
  }
  const bool is_solved = output.result && !output.held;
  above_tolerance += is_solved && output.result->above_tolerance ? 1U : 0U;
  implausible_force += is_solved && output.result->implausible_force ? 1U : 0U;
  lacking_neighbour += output.lacks_neighbour ? 1U : 0U;
  solve_time_sum += output.solve_time;
  solve_time_max = std::max(solve_time_max, output.solve_time);
  if (!output.reason.empty())
  {
    last_reason = output.reason;
  }
}

std::uint64_t ContactStatistics::evaluated() const
{
  return total(results);
}

std::uint64_t ContactStatistics::usable() const
{
  std::uint64_t sum = 0;
  for (std::uint8_t status = 0; status < statuses; ++status)
  {
    sum += isUsable(status) ? results[status] : 0;
  }
  return sum;
}

std::uint64_t ContactStatistics::dropped() const
{
  return total(pairing.dropped) - pairing[DropReason::unneeded] + truncated + overload;
}

std::string droppedBetween(const ContactStatistics& before, const ContactStatistics& now)
{
  std::string text;
  const auto add = [&text](std::uint64_t count, const std::string& reason)
  { text += count == 0 ? "" : formatted("%s%llu (%s)", text.empty() ? "" : ", ", 0ULL + count, reason.c_str()); };
  for (std::size_t i = 0; i < drop_names.size(); ++i)
  {
    const auto reason = static_cast<DropReason>(i);
    const bool is_loss = reason != DropReason::unneeded;
    add(is_loss ? now.pairing[reason] - before.pairing[reason] : 0, dropText(reason, now.pairing));
  }
  add(now.truncated - before.truncated, truncated_name);
  add(now.overload - before.overload, "pairs too many for the speed of the node");
  return text;
}

void diagnose(const ContactStatistics& now, const ContactStatistics& before,
              diagnostic_updater::DiagnosticStatusWrapper& report)
{
  summarize(now, before, report);
  report.add("messages received", now.pairing.received);
  report.add("messages waiting for a match", now.pairing.waiting);
  for (std::size_t i = 0; i < drop_names.size(); ++i)
  {
    report.add(std::string("messages dropped: ") + drop_names[i], now.pairing.dropped[i]);
  }
  report.add(std::string("messages dropped: ") + truncated_name, now.truncated);
  report.add("inputs dropped: overload", now.overload);
  report.add("results", now.evaluated());
  for (std::uint8_t status = 0; status < ContactStatistics::statuses; ++status)
  {
    report.add(std::string("results ") + statusName(status), now.results[status]);
  }
  report.add("results held", now.held);
  report.add("internal errors", now.internal_errors);
  report.add("results beyond the table's linear range", now.beyond_linear_range);
  report.add("last result beyond the table's linear range", now.last_beyond_linear_range);
  report.add("results with an error estimate above contact/tolerance", now.above_tolerance);
  report.add("results with an implausible wheel force", now.implausible_force);
  report.add("results that lack a neighbour's forces", now.lacking_neighbour);
  report.add("service results ~evaluate", now.services.evaluate);
  report.add("service results ~static_start", now.services.static_start);
  report.add("service results that are not usable", now.services.unusable);
  report.add("service results that lack a neighbour's forces", now.services.lacking_neighbour);
  report.add("service requests failed: internal error", now.services.failed);
  report.add("contact messages built", now.messages_built);
  report.add("marker arrays built", now.marker_arrays_built);
  const std::uint64_t evaluated = now.evaluated() - before.evaluated();
  const double sum = now.solve_time_sum - before.solve_time_sum;
  report.addf("solve time, mean [ms]", "%.3f", evaluated > 0 ? 1e3 * sum / static_cast<double>(evaluated) : 0.0);
  report.addf("solve time, max [ms]", "%.3f", 1e3 * now.solve_time_max);
  report.add("last reason", now.last_reason);
}
}  // namespace wheel_rail_contact
