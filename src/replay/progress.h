// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

namespace wheel_rail_contact
{
/// Shows on stderr how far a replay has come, how fast it is and how long it will take: a bar on a terminal, otherwise
/// a line now and then.
class Progress
{
 public:
  /// @param total number of messages to be read
  explicit Progress(std::uint64_t total);

  /// Called often; shows something only when it is time.
  void show(std::uint64_t read, std::uint64_t results);
  /// Shows the last state and ends the line.
  void finish(std::uint64_t read, std::uint64_t results);

  /// Since the beginning [s].
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
