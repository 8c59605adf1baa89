// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <array>
#include <cstdint>
#include <string>

#include "ros/node/contact_evaluator.h"
#include "ros/node/stamp_pairing.h"

namespace wheel_rail_contact
{
/// Name of a status constant of the message WheelsetContact, as it stands there.
const char* statusName(std::uint8_t status);
/// In words.
const char* dropName(DropReason reason);

/// What a server has done since it started. Nothing that comes in is lost without being counted here.
struct ContactStatistics
{
  static constexpr std::size_t statuses = 6;  ///< number of status constants

  PairingCounts pairing;                          ///< of single messages
  std::uint64_t overload = 0;                     ///< inputs pushed out by newer ones before their turn came
  std::array<std::uint64_t, statuses> results{};  ///< by status constant of the message WheelsetContact
  std::uint64_t internal_errors = 0;              ///< inputs that ended in an exception: mistakes of this program
  std::uint64_t beyond_linear_range = 0;          ///< answers with |Y|/Q beyond the compliance table's range
  std::uint64_t above_tolerance = 0;              ///< usable answers with an error estimate above contact/tolerance
  std::uint64_t lacking_neighbour = 0;            ///< answers evaluated without the forces of a neighbour
  std::uint64_t messages_built = 0;               ///< answers turned into messages, because someone listened
  std::uint64_t marker_arrays_built = 0;          ///< answers turned into markers, because someone listened
  double solve_time_sum = 0;                      ///< of all answers [s]
  double solve_time_max = 0;                      ///< since the last report [s]
  std::string last_beyond_linear_range;           ///< figures of the newest of them
  std::string last_reason;                        ///< of the newest answer that had one

  /// Adds an answer that took so long [s].
  void count(const ContactOutput& output, double solve_time);

  /// Answers of any status.
  std::uint64_t evaluated() const;
  /// Answers that may be used.
  std::uint64_t usable() const;
  /// Inputs and single messages that got none.
  std::uint64_t dropped() const;
};

/// Describes what happened between two reports. OK: every answer usable, nothing dropped. WARN: something dropped, an
/// unusable answer, no partner for what came in, a neighbour's forces unknown, a rail beyond its table's range, or an
/// error above the tolerance.
/// ERROR: answers, but none usable.
void diagnose(const ContactStatistics& now, const ContactStatistics& before,
              diagnostic_updater::DiagnosticStatusWrapper& report);
}  // namespace wheel_rail_contact
