// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bag/bag_writer.h"
#include "replay/csv_rows.h"
#include "replay/evaluation_pool.h"
#include "replay/replay_options.h"
#include "replay/replay_source.h"
#include "replay/result_counts.h"

namespace wheel_rail_contact
{
/// One run of contact_replay. One thread reads and matches messages, several evaluate, the caller's thread writes.
class Replay
{
 public:
  /// Reads the parameters and opens the files.
  /// @throw std::exception if parameters or files cannot be used, or if an output exists without `resume`.
  explicit Replay(ReplayOptions options);

  /// Runs to the end, or until `interrupted` becomes true. In both cases the output is a complete bag. It contains at
  /// least the results that were in the resumed bag.
  /// @throw std::exception for any failure during reading, evaluating or writing.
  void run(const std::atomic<bool>& interrupted);

  /// Prints number of results, speed, statuses and dropped messages. Shares are those of all poses. contact_campaign
  /// parses this text.
  void printSummary(std::ostream& out) const;
  /// What was understood of the profile files, and warnings, one line each. contact_campaign takes all lines before the
  /// summary as notes.
  std::vector<std::string> notes() const { return config_.remarks(); }
  /// Parts of the input that could not be read, as text; empty if all was read.
  std::vector<std::string> faults() const { return source_.faults(); }
  /// Number of results in the output, including those of the resumed bag.
  std::uint64_t results() const { return results_; }
  /// Number of poses that have a result or were dropped.
  std::uint64_t poses() const { return results_ + source_.droppedPoses(); }
  /// Number of results whose input is usable, including those of the resumed bag; see ResultCounts::unusableInputs().
  std::uint64_t resultsOfUsableInput() const { return results_ - counts_.unusableInputs(); }
  /// Reason to doubt the loads of this run; empty if there is none.
  std::string loadDoubt() const { return loads_.doubt(config_.model.wheelset); }
  /// True if fewer than half of the poses of a whole bag have a result of usable input.
  bool lacksMostResults() const { return options_.span.isWhole() && 2 * resultsOfUsableInput() < poses(); }

 private:
  std::unique_ptr<BagWriter> resumeOutput();
  void read(EvaluationPool& pool);
  void keepForWarmUp(ReplayItem item);
  bool addWarmUp(EvaluationPool& pool);
  void write(const ReplayItem& item);
  std::uint32_t keptConnection(const ReplayItem& item);

  const ReplayOptions options_;
  const ParameterTree parameters_;
  const NodeConfig config_;
  ReplaySource source_;
  const std::string description_;
  BagResumePoint resume_point_;
  std::unique_ptr<BagWriter> bag_;
  std::unique_ptr<CsvFile> csv_;
  std::map<std::uint32_t, std::uint32_t> kept_connections_;  ///< numbers in the output by numbers in the input
  std::uint64_t written_ = 0;                                ///< messages in the output, including resumed ones
  std::uint64_t results_ = 0;                                ///< results in the output, including resumed ones
  std::uint64_t results_before_ = 0;                         ///< resumed results
  std::uint64_t last_read_ = 0;                              ///< messages of the input that are processed
  std::vector<std::deque<ReplayItem>> warm_up_;              ///< by wheelset; thread of the reader only
  ResultCounts counts_;                                      ///< of all results in the output, including resumed ones
  core::LoadTally loads_;                                    ///< of this run
  double seconds_ = 0;
};
}  // namespace wheel_rail_contact
