// SPDX-License-Identifier: BSD-3-Clause
#include "replay/output_queue.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace wheel_rail_contact
{
namespace
{
constexpr std::size_t overhead = 1024;  ///< memory of an item and its input, without the data of the result [B]
constexpr std::chrono::milliseconds pop_timeout(100);

/// Memory of an evaluated item [B].
std::size_t sizeOf(const OutputItem& item)
{
  std::size_t cells = 0;
  if (item.output.result)
  {
    for (const core::PatchResult& patch : item.output.result->patches)
    {
      const std::size_t layers = patch.wheel_stress.field.size() + patch.rail_stress.field.size();
      cells += static_cast<std::size_t>(patch.pressure.size()) * (1 + 6 * layers);
    }
  }
  return item.data.size() + item.csv.size() + sizeof(double) * cells;
}
}  // namespace

/// Updates the memory attributed to an item. An unfinished result counts as much as the largest result so far.
void OutputQueue::charge(OutputItem& item)
{
  bytes_ -= item.charged;
  item.charged = overhead + (item.ready ? sizeOf(item) : largest_result_);
  bytes_ += item.charged;
}

OutputItem* OutputQueue::append(OutputItem item)
{
  std::unique_lock<std::mutex> lock(mutex_);
  space_.wait(lock, [this] { return stopped_ || items_.empty() || bytes_ < budget_; });
  if (stopped_)
  {
    return nullptr;
  }
  items_.push_back(std::move(item));
  charge(items_.back());
  if (items_.front().ready)
  {
    front_ready_.notify_one();
  }
  return &items_.back();
}

void OutputQueue::complete(OutputItem& item, ContactOutput output, std::string data, std::string csv)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (stopped_)
  {
    return;
  }
  item.data = std::move(data);
  item.csv = std::move(csv);
  item.output = std::move(output);
  item.ready = true;
  charge(item);
  largest_result_ = std::max(largest_result_, sizeOf(item));
  if (&item == &items_.front())
  {
    front_ready_.notify_one();
  }
}

void OutputQueue::close()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  closed_ = true;
  front_ready_.notify_one();
}

OutputQueue::State OutputQueue::pop(OutputItem& item)
{
  std::unique_lock<std::mutex> lock(mutex_);
  const auto is_ready = [this] { return !items_.empty() && items_.front().ready; };
  front_ready_.wait_for(lock, pop_timeout, [&] { return stopped_ || is_ready() || (closed_ && items_.empty()); });
  if (reason_)
  {
    std::rethrow_exception(reason_);
  }
  if (stopped_ || (closed_ && items_.empty()))
  {
    return State::end;
  }
  if (!is_ready())
  {
    return State::later;
  }
  item = std::move(items_.front());
  items_.pop_front();
  bytes_ -= item.charged;
  if (bytes_ < budget_ / 4 * 3 || items_.empty())
  {
    space_.notify_one();
  }
  return State::item;
}

void OutputQueue::stop(std::exception_ptr reason)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  stopped_ = true;
  reason_ = reason_ ? reason_ : std::move(reason);
  space_.notify_all();
  front_ready_.notify_all();
}
}  // namespace wheel_rail_contact
