// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "replay/output_queue.h"
#include "ros/evaluation/contact_evaluator.h"

namespace wheel_rail_contact
{
/// Threads that evaluate inputs. One evaluator processes the inputs of a slice (see ResetRule) in order, from a cold
/// start. The results therefore do not depend on the number of threads.
class EvaluationPool
{
 public:
  /// Output format of a result.
  struct Format
  {
    bool grids = true;                   ///< false: the pressure grids are left empty
    bool csv = false;                    ///< true: rows of the table are also made
    std::vector<std::string> wheelsets;  ///< names in the table

    /// Bytes of the message of a result, and its rows of the table.
    std::pair<std::string, std::string> write(const ContactOutput& output, const OutputItem& item) const;
  };

  /// @param output receives the results and any exception of a thread; must outlive the pool
  EvaluationPool(NodeConfig config, int threads, Format format, OutputQueue& output);
  /// Waits for the evaluations in progress. Inputs that wait are not evaluated.
  ~EvaluationPool();
  EvaluationPool(const EvaluationPool&) = delete;
  EvaluationPool& operator=(const EvaluationPool&) = delete;

  /// Adds the next input of a wheelset.
  /// @param item to be completed. The bytes of a result that is not usable are left to the caller (HoldLast)
  void add(std::size_t wheelset, PreparedInput input, OutputItem* item);

 private:
  struct Job
  {
    PreparedInput input;
    OutputItem* item;
  };
  struct Slice
  {
    std::uint64_t number = 0;
    std::vector<Job> waiting;
    bool taken = false;   ///< a thread is evaluating it
    bool closed = false;  ///< no further input will be added
    std::unique_ptr<ContactEvaluator> evaluator;
  };

  void offer(const std::shared_ptr<Slice>& slice);
  void work();
  void run(Slice& slice, std::unique_lock<std::mutex>& lock);
  void evaluate(ContactEvaluator& evaluator, const Job& job) const;

  const NodeConfig config_;
  const Format format_;
  OutputQueue& output_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<std::shared_ptr<Slice>> open_;                 ///< by wheelset; null before the first input
  std::map<std::uint64_t, std::shared_ptr<Slice>> offered_;  ///< slices with work to do, oldest first
  std::vector<std::unique_ptr<ContactEvaluator>> idle_;
  std::uint64_t slices_ = 0;
  bool stopped_ = false;
  std::vector<std::thread> threads_;
};
}  // namespace wheel_rail_contact
