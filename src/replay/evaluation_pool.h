// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "replay/replay_source.h"
#include "ros/evaluation/contact_evaluator.h"

namespace wheel_rail_contact
{
/// A message of the output. A result may still be in evaluation.
struct OutputItem : ReplayItem
{
  std::uint64_t result = 0;    ///< number of the result in the output
  std::uint32_t sequence = 0;  ///< number of the result among those of its wheelset
  bool ready = false;          ///< `data` and the members below are complete
  ContactOutput output;        ///< the result
  std::string csv;             ///< rows of the table; they and `data` are empty unless the result is usable
  bool warm_up = false;        ///< not output, but later results may be completed with it
  std::size_t charged = 0;     ///< memory attributed to the item by the queue [B]
};

/// Queue of output items in the order of the output. The reader appends items, workers complete them and the writer
/// takes them. The reader is blocked while the waiting items exceed a memory budget. Thread-safe.
class OutputQueue
{
 public:
  /// @param budget approximate memory limit of the waiting items [B]
  explicit OutputQueue(std::size_t budget) : budget_(budget) {}

  /// Reader: waits until the memory budget allows another item, then appends it.
  /// @return the item; null after stop()
  OutputItem* append(OutputItem item);
  /// Workers: completes an item with its result.
  void complete(OutputItem& item, ContactOutput output, std::string data, std::string csv);
  /// Reader: no further item will be appended.
  void close();

  /// Outcome of pop().
  enum class State
  {
    item,   ///< an item was taken
    later,  ///< the next item is not ready yet
    end     ///< the queue is closed and empty, or stopped
  };
  /// Writer: takes the next item; waits for it up to 0.1 s.
  /// @throw the exception that was passed to stop().
  State pop(OutputItem& item);

  /// Ends all waiting. Afterwards no item is accepted or delivered.
  /// @param reason exception for pop(); of several calls the first exception counts
  void stop(std::exception_ptr reason = nullptr);

 private:
  void charge(OutputItem& item);

  std::mutex mutex_;
  std::condition_variable space_, front_ready_;
  std::deque<OutputItem> items_;
  std::size_t budget_;
  std::size_t bytes_ = 0;           ///< memory attributed to all items [B]
  std::size_t largest_result_ = 0;  ///< size of the largest result so far [B]; assumed for unfinished results
  bool closed_ = false, stopped_ = false;
  std::exception_ptr reason_;
};

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
