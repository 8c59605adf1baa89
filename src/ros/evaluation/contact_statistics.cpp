// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/contact_statistics.h"

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

template <typename Counts>
std::uint64_t total(const Counts& counts)
{
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

void summarize(const ContactStatistics& now, const ContactStatistics& before,
               diagnostic_updater::DiagnosticStatusWrapper& report)
{
  const std::uint64_t evaluated = now.evaluated() - before.evaluated();
  const std::uint64_t unusable = evaluated - (now.usable() - before.usable());
  const std::uint64_t errors = now.internal_errors - before.internal_errors;
  const std::uint64_t dropped = now.dropped() - before.dropped();
  const std::uint64_t unstamped = now.pairing[DropReason::unstamped] - before.pairing[DropReason::unstamped];
  if (errors > 0)
  {
    report.summaryf(DiagnosticStatus::ERROR, "internal error: %s", now.last_reason.c_str());
  }
  else if (evaluated > 0 && unusable == evaluated)
  {
    report.summaryf(DiagnosticStatus::ERROR, "no usable result: %s", now.last_reason.c_str());
  }
  else if (unusable > 0)
  {
    report.summaryf(DiagnosticStatus::WARN, "%lu of %lu results not usable: %s", unusable, evaluated,
                    now.last_reason.c_str());
  }
  else if (evaluated > 0 && !now.load_doubt.empty())
  {
    report.summary(DiagnosticStatus::WARN, now.load_doubt);
  }
  else if (now.implausible_force > before.implausible_force)
  {
    report.summaryf(DiagnosticStatus::WARN, "%lu of %lu results with an implausible wheel force: %s",
                    now.implausible_force - before.implausible_force, evaluated, now.last_reason.c_str());
  }
  else if (unstamped > 0)
  {
    report.summaryf(DiagnosticStatus::WARN, "%lu messages dropped: their stamp is 0, which means unknown", unstamped);
  }
  else if (dropped > 0)
  {
    report.summaryf(DiagnosticStatus::WARN, "%lu inputs dropped", dropped);
  }
  else if (evaluated == 0 && now.pairing.received > before.pairing.received)
  {
    report.summary(DiagnosticStatus::WARN, "no inputs with matching stamps");
  }
  else if (now.lacking_neighbour > before.lacking_neighbour)
  {
    report.summaryf(DiagnosticStatus::WARN, "%lu of %lu results lack a neighbour's forces",
                    now.lacking_neighbour - before.lacking_neighbour, evaluated);
  }
  else if (now.beyond_linear_range > before.beyond_linear_range)
  {
    report.summary(DiagnosticStatus::WARN, now.last_beyond_linear_range);
  }
  else if (now.above_tolerance > before.above_tolerance)
  {
    report.summaryf(DiagnosticStatus::WARN, "%lu of %lu results with an error estimate above contact/tolerance",
                    now.above_tolerance - before.above_tolerance, evaluated);
  }
  else if (evaluated > 0)
  {
    report.summaryf(DiagnosticStatus::OK, "%lu results", evaluated);
  }
  else
  {
    report.summary(DiagnosticStatus::OK, "no input");
  }
}

void addTimes(const ContactStatistics& now, const ContactStatistics& before,
              diagnostic_updater::DiagnosticStatusWrapper& report)
{
  const std::uint64_t evaluated = now.evaluated() - before.evaluated();
  const double sum = now.solve_time_sum - before.solve_time_sum;
  report.addf("solve time, mean [ms]", "%.3f", evaluated > 0 ? 1e3 * sum / static_cast<double>(evaluated) : 0.0);
  report.addf("solve time, max [ms]", "%.3f", 1e3 * now.solve_time_max);
}
}  // namespace

const char* statusName(std::uint8_t status)
{
  return nameOf(static_cast<core::ContactStatus>(status));
}

const char* dropName(DropReason reason)
{
  return drop_names.at(static_cast<std::size_t>(reason));
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
  return total(pairing.dropped) - pairing[DropReason::unneeded] + overload;
}

std::string droppedBetween(const ContactStatistics& before, const ContactStatistics& now)
{
  std::string text;
  const auto add = [&text](std::uint64_t count, const char* reason)
  { text += count == 0 ? "" : formatted("%s%llu (%s)", text.empty() ? "" : ", ", 0ULL + count, reason); };
  for (std::size_t i = 0; i < drop_names.size(); ++i)
  {
    const bool is_loss = static_cast<DropReason>(i) != DropReason::unneeded;
    add(is_loss ? now.pairing.dropped[i] - before.pairing.dropped[i] : 0, drop_names[i]);
  }
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
  addTimes(now, before, report);
  report.add("last reason", now.last_reason);
}
}  // namespace wheel_rail_contact
