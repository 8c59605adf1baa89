// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace wheel_rail_contact
{
/// Bounded queue between a writer that must not wait and a reader. If it is full, a new entry replaces the oldest one,
/// and the dropped entry is counted. Thread-safe.
template <typename Entry>
class NewestQueue
{
 public:
  /// @param capacity largest number of entries, >= 1
  explicit NewestQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Adds an entry, without waiting for the reader. Ignored after close().
  void push(Entry entry)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (closed_)
    {
      return;
    }
    if (entries_.size() == capacity_)
    {
      entries_.pop_front();
      ++dropped_;
    }
    entries_.push_back(std::move(entry));
    wake_.notify_one();
  }

  /// Waits for an entry and removes the oldest one. @return it, or nothing if the queue is closed.
  std::optional<Entry> pop()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    wake_.wait(lock, [this] { return closed_ || !entries_.empty(); });
    if (closed_)
    {
      return std::nullopt;
    }
    std::optional<Entry> entry(std::move(entries_.front()));
    entries_.pop_front();
    return entry;
  }

  /// Waits for an entry, at most the given time [s]. @return true if there is an entry or the queue is closed.
  bool waitForEntry(double seconds)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    return wake_.wait_for(lock, std::chrono::duration<double>(seconds),
                          [this] { return closed_ || !entries_.empty(); });
  }

  /// Ends all waiting. The remaining entries are not delivered.
  void close()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    wake_.notify_all();
  }

  /// True after close().
  bool closed() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return closed_;
  }

  /// Number of entries replaced by newer ones.
  std::uint64_t dropped() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return dropped_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Entry> entries_;
  std::size_t capacity_;
  std::uint64_t dropped_ = 0;
  bool closed_ = false;
};
}  // namespace wheel_rail_contact
