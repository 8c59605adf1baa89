// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "replay/replay_source.h"
#include "ros/evaluation/contact_evaluator.h"
#include "ros/evaluation/hold_last.h"

namespace wheel_rail_contact
{
/// Distributes the stages of EvaluationChain over threads, and delivers the results in the order of the inputs.
///
/// A thread of its own reads the inputs, which ReplaySource prepares. Others evaluate them: one evaluator processes the
/// inputs of a slice (see ResetRule) in order, from a cold start. The caller of pop() holds the results of each
/// wheelset in order. The results therefore do not depend on the number of threads.
class EvaluationPool
{
 public:
  /// Output format of a result.
  struct Format
  {
    bool grids = true;                   ///< false: the pressure grids are left empty
    bool csv = false;                    ///< true: rows of the table are also made
    std::vector<std::string> wheelsets;  ///< names in the table

    /// Makes the bytes of the message of a result, and its rows of the table.
    void write(ReplayItem& item) const;
  };

  /// @param threads number of threads that evaluate
  /// @param read appends all items, until it has no more or append() returns false
  EvaluationPool(NodeConfig config, int threads, Format format, std::function<void(EvaluationPool&)> read);
  /// Waits for the current calls in all threads. Inputs that wait are not evaluated.
  ~EvaluationPool();
  EvaluationPool(const EvaluationPool&) = delete;
  EvaluationPool& operator=(const EvaluationPool&) = delete;

  /// For `read`: waits while the items in the pool exceed a memory limit, then appends an item.
  /// @return false if the item is not needed any more, because the pool ends
  bool append(ReplayItem item);

  /// Takes the next item of the output. @return nothing if it is not ready within 0.1 s, or is not output
  /// @throw the first exception of a thread.
  std::optional<ReplayItem> pop();
  /// True once all items have been taken.
  bool isEmpty();

 private:
  struct Entry : ReplayItem
  {
    explicit Entry(ReplayItem item)
        : ReplayItem(std::move(item)), is_evaluated(wheelset && !resumed), ready(!is_evaluated)
    {
    }

    bool is_evaluated;        ///< in this run
    bool ready;               ///< can be taken
    std::size_t charged = 0;  ///< memory attributed to the item [B]
  };
  struct Slice
  {
    std::uint64_t number = 0;
    std::deque<Entry*> waiting;
    bool taken = false;   ///< a thread is evaluating it
    bool closed = false;  ///< no further input will be added
    std::unique_ptr<ContactEvaluator> evaluator;
  };

  void start(const std::function<void()>& task);
  void stop(std::exception_ptr reason);
  void addToSlice(Entry& entry);
  void offer(const std::shared_ptr<Slice>& slice);
  void work();
  void run(Slice& slice, std::unique_lock<std::mutex>& lock);
  void complete(Entry& entry);
  void charge(Entry& entry);

  const NodeConfig config_;
  const Format format_;
  std::vector<HoldLast> hold_;  ///< by wheelset; only for the caller of pop()
  std::mutex mutex_;            ///< guards all that follows, except the results of entries that are not ready
  std::condition_variable space_, wake_, front_ready_;
  std::deque<Entry> entries_;
  std::size_t bytes_ = 0;                                    ///< memory attributed to all items [B]
  std::size_t largest_result_ = 0;                           ///< so far [B]; assumed for unfinished results
  std::vector<std::shared_ptr<Slice>> open_;                 ///< by wheelset; null before the first input
  std::map<std::uint64_t, std::shared_ptr<Slice>> offered_;  ///< slices with work to do, oldest first
  std::vector<std::unique_ptr<ContactEvaluator>> idle_;
  std::uint64_t slices_ = 0;
  bool closed_ = false;   ///< no further item will be appended
  bool stopped_ = false;  ///< all waiting ends
  std::exception_ptr reason_;
  std::vector<std::thread> threads_;
};
}  // namespace wheel_rail_contact
