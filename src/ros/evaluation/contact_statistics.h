// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <array>
#include <cstdint>
#include <string>

#include "core/state_check.h"
#include "ros/evaluation/contact_evaluator.h"
#include "ros/evaluation/stamp_pairing.h"

namespace wheel_rail_contact
{
/// Name of a status constant, as in the message WheelsetContact.
const char* statusName(std::uint8_t status);
/// Text for the log and the output of a replay. For messages without a match, with the smallest difference of two
/// stamps and the parameters that help.
std::string dropText(DropReason reason, const PairingCounts& counts);

/// Numbers of service requests of a node since its start.
struct ServiceCounts
{
  std::uint64_t evaluate = 0;           ///< results of ~evaluate
  std::uint64_t static_start = 0;       ///< results of ~static_start
  std::uint64_t unusable = 0;           ///< results of both whose status is not usable
  std::uint64_t lacking_neighbour = 0;  ///< results of both without the forces of a neighbour
  std::uint64_t failed = 0;             ///< requests without a result, because of an internal error
};

/// Counts of a server since its start. Each message that is lost is counted here.
struct ContactStatistics
{
  static constexpr std::size_t statuses = 8;  ///< number of status constants

  PairingCounts pairing;                          ///< single messages
  std::uint64_t truncated = 0;                    ///< messages that end early, or contain false sizes
  std::uint64_t overload = 0;                     ///< inputs that newer ones pushed out of the queue
  std::array<std::uint64_t, statuses> results{};  ///< by status constant of the message WheelsetContact
  std::uint64_t held = 0;                         ///< results with the forces of the last usable one (HoldLast)
  std::uint64_t internal_errors = 0;      ///< inputs whose evaluation threw an exception: a fault of the program
  std::uint64_t beyond_linear_range = 0;  ///< results with |Y|/Q beyond the range of the compliance table
  std::uint64_t above_tolerance = 0;      ///< usable results with an error estimate above contact/tolerance
  std::uint64_t implausible_force = 0;    ///< usable results with a wheel force beyond the plausible bound
  std::uint64_t lacking_neighbour = 0;    ///< results without the forces of a neighbour
  std::uint64_t messages_built = 0;       ///< result messages, built only for subscribers
  std::uint64_t marker_arrays_built = 0;  ///< marker arrays, built only for subscribers
  core::LoadTally loads;                  ///< of the results
  std::string load_doubt;                 ///< about `loads`, set for a report
  ServiceCounts services;                 ///< requests, which none of the other members contains
  double solve_time_sum = 0;              ///< of all results [s]
  double solve_time_max = 0;              ///< since the last report [s]
  std::string last_beyond_linear_range;   ///< warning of the newest result beyond the linear range
  std::string last_reason;                ///< reason of the newest result that has one

  /// Adds a result.
  void count(const ContactOutput& output);

  /// Number of results, of any status.
  std::uint64_t evaluated() const;
  /// Number of usable results.
  std::uint64_t usable() const;
  /// Number of dropped inputs and of dropped single messages, without loads that the interpolation does not need.
  std::uint64_t dropped() const;
};

/// Numbers of messages and inputs dropped between two statistics, with the reasons; empty if there are none.
std::string droppedBetween(const ContactStatistics& before, const ContactStatistics& now);

/// Fills a diagnostic report on the time since the last report.
///
/// ERROR: an internal error, or results of which none is usable. WARN: unusable results, dropped inputs or messages,
/// messages but no results, an implausible wheel force, unknown forces of a neighbour, a rail beyond the range of its
/// table, or an error estimate above the tolerance. OK: otherwise.
/// @param before statistics at the last report
void diagnose(const ContactStatistics& now, const ContactStatistics& before,
              diagnostic_updater::DiagnosticStatusWrapper& report);
}  // namespace wheel_rail_contact
