// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bag/bag_writer.h"
#include "replay/csv_rows.h"
#include "replay/evaluation_pool.h"
#include "replay/output_queue.h"
#include "replay/replay_options.h"
#include "replay/replay_source.h"
#include "ros/node/contact_statistics.h"

namespace wheel_rail_contact
{
/// One run of contact_replay: a thread reads and pairs, some evaluate, and the caller's writes.
class Replay
{
 public:
  /// Opens the files.
  /// @throw std::exception if the parameters or the files cannot be used, or the output exists already.
  explicit Replay(ReplayOptions options);

  /// Runs to the end, or until `interrupted` becomes true; the output is a whole bag in either case, with at least what
  /// was resumed.
  /// @throw std::exception if something goes wrong on the way.
  void run(const std::atomic<bool>& interrupted);

  /// What was done, in sentences.
  void printSummary(std::ostream& out) const;
  /// What could not be read, in sentences; empty if everything was.
  std::vector<std::string> faults() const { return source_.faults(); }
  /// Answers written, those resumed among them.
  std::uint64_t results() const { return results_; }

 private:
  std::unique_ptr<BagWriter> resumeOutput();
  void read(EvaluationPool& pool);
  void write(const OutputItem& item);
  std::uint32_t keptConnection(const OutputItem& item);

  const ReplayOptions options_;
  const ParameterTree parameters_;
  const NodeConfig config_;
  ReplaySource source_;
  const std::string description_;
  BagRemains remains_;
  std::unique_ptr<BagWriter> bag_;
  std::unique_ptr<CsvFile> csv_;
  OutputQueue queue_;
  std::map<std::uint32_t, std::uint32_t> kept_connections_;  ///< numbers in the output by those in the input
  std::uint64_t written_ = 0;                                ///< messages, with those that were there before
  std::uint64_t results_ = 0;                                ///< with those that were there before
  std::uint64_t results_before_ = 0;                         ///< that were there before
  std::uint64_t last_read_ = 0;                              ///< messages of the input that are dealt with
  std::array<std::uint64_t, ContactStatistics::statuses> statuses_{};
  std::array<std::string, ContactStatistics::statuses> first_reasons_;  ///< of each status
  double seconds_ = 0;
};
}  // namespace wheel_rail_contact
