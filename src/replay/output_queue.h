// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <string>

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
}  // namespace wheel_rail_contact
