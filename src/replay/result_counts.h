// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>

#include "bag/bag_writer.h"
#include "ros/evaluation/contact_statistics.h"

namespace wheel_rail_contact
{
/// Results of a replay by status, with the first reason of each status.
class ResultCounts
{
 public:
  /// @param status of the result, as in the message
  /// @param reason status_text of the result; not used if the status is OK
  void add(std::uint8_t status, const std::string& reason, bool held);

  /// Number of results whose status is INVALID_INPUT or NO_TRANSFORM. The input of all others was usable, also of those
  /// with OFF_PROFILE, NOT_CONVERGED or OUTSIDE_LINE.
  std::uint64_t unusableInputs() const;
  /// Prints one line per status that occurs. Shares are those of `poses`.
  void print(std::ostream& out, std::uint64_t poses) const;

 private:
  std::array<std::uint64_t, ContactStatistics::statuses> counts_{};
  std::array<std::string, ContactStatistics::statuses> first_reasons_;
  std::uint64_t held_ = 0;
};

/// Counts of the results in a bag that is resumed.
/// @param path of the bag, which ends at the resume point
/// @param wheelsets number of wheelsets; the numbers of their connections are below it
/// @throw BagError if the bag cannot be read.
ResultCounts resumedResults(const std::string& path, const BagResumePoint& resume_point, std::size_t wheelsets);
}  // namespace wheel_rail_contact
