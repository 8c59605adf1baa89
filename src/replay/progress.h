// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

namespace wheel_rail_contact
{
/// Displays progress, speed and remaining time of a replay on stderr: a bar on a terminal, otherwise a line every 10 s.
class Progress
{
 public:
  /// @param total number of messages to read
  explicit Progress(std::uint64_t total);

  /// Updates the display if it is due. May be called often.
  /// @param read messages read so far
  /// @param results results written so far in this run
  void show(std::uint64_t read, std::uint64_t results);
  /// Prints the final state on a terminal and ends the line.
  void finish(std::uint64_t read, std::uint64_t results);

  /// Time since construction [s].
  double elapsed() const;

 private:
  using Clock = std::chrono::steady_clock;
  void print(std::uint64_t read, std::uint64_t results) const;

  std::uint64_t total_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};
}  // namespace wheel_rail_contact
