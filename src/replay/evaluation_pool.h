// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "replay/output_queue.h"
#include "ros/node/contact_evaluator.h"

namespace wheel_rail_contact
{
/// Threads that answer inputs. Each slice (ResetRule) is answered in its order by one evaluator, which starts
/// cold, so that the answers do not depend on the number of threads.
class EvaluationPool
{
 public:
  /// What an answer is turned into.
  struct Format
  {
    bool grids = true;                   ///< false leaves the pressure grids empty
    bool csv = false;                    ///< true: rows of the table too
    std::vector<std::string> wheelsets;  ///< names, for the table
  };

  /// @param output gets the answers, and what goes wrong in a thread; must outlive the pool
  EvaluationPool(NodeConfig config, int threads, Format format, OutputQueue& output);
  /// Ends after the evaluations in hand.
  ~EvaluationPool();
  EvaluationPool(const EvaluationPool&) = delete;
  EvaluationPool& operator=(const EvaluationPool&) = delete;

  /// @param item to be completed; null: the answer is not asked for, but those after it in its slice may start from it
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
    bool wanted = false;  ///< one of its answers is asked for
    bool taken = false;   ///< a thread works on it
    bool closed = false;  ///< no input will come
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
  std::vector<std::shared_ptr<Slice>> open_;                 ///< by wheelset; null before its first input
  std::map<std::uint64_t, std::shared_ptr<Slice>> offered_;  ///< that have something to do, the oldest first
  std::vector<std::unique_ptr<ContactEvaluator>> idle_;
  std::uint64_t slices_ = 0;
  bool stopped_ = false;
  std::vector<std::thread> threads_;
};
}  // namespace wheel_rail_contact
