// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <string>

#include "replay/replay_item.h"

namespace wheel_rail_contact
{
/// A message of the output, which may still be worked on.
struct OutputItem : ReplayItem
{
  std::uint64_t result = 0;    ///< number of the answer in the output
  std::uint32_t sequence = 0;  ///< number of the answer among those of its wheelset
  bool ready = false;          ///< `data` and what follows is there
  std::string csv;             ///< rows of the table
  std::uint8_t status = 0;     ///< of the answer, as in the message
  std::string reason;          ///< of the status, as in the message; empty if it is OK
  std::size_t charged = 0;     ///< by the queue [B]
};

/// The output in its order, between those who fill it and the one who writes it. Holds back the reader when too much is
/// waiting, so that memory stays bounded. Thread-safe.
class OutputQueue
{
 public:
  /// @param budget of waiting items, about [B]
  explicit OutputQueue(std::size_t budget) : budget_(budget) {}

  /// Reader: appends an item, as soon as there is room. @return the item, null once the queue has been stopped.
  OutputItem* append(OutputItem item);
  /// Workers: fills an item.
  void complete(OutputItem& item, std::string data, std::string csv, std::uint8_t status, std::string reason);
  /// Reader: nothing more will come.
  void close();

  /// What the writer is given.
  enum class State
  {
    item,   ///< the next item
    later,  ///< nothing is ready yet
    end     ///< no more will come
  };
  /// Writer: takes the next item; waits for it a moment.
  /// @throw what stop() was given.
  State pop(OutputItem& item);

  /// Lets go whoever waits; nothing is delivered any more.
  void stop(std::exception_ptr reason = nullptr);

 private:
  void charge(OutputItem& item);

  std::mutex mutex_;
  std::condition_variable room_, front_ready_;
  std::deque<OutputItem> items_;
  std::size_t budget_;
  std::size_t bytes_ = 0;           ///< of all items
  std::size_t largest_result_ = 0;  ///< so far; answers still to come count as much
  bool closed_ = false, stopped_ = false;
  std::exception_ptr reason_;
};
}  // namespace wheel_rail_contact
