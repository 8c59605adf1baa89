// SPDX-License-Identifier: BSD-3-Clause
#include "replay/evaluation_pool.h"

#include <chrono>

#include "replay/bag_messages.h"
#include "replay/csv_rows.h"
#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
namespace
{
constexpr std::size_t budget = 96 << 20;  ///< approximate memory limit of the items [B]
constexpr std::size_t overhead = 1024;    ///< memory of an item and its input, without the data of the result [B]
constexpr std::chrono::milliseconds pop_timeout(100);

/// Memory of the data of an evaluated item [B].
std::size_t sizeOf(const ReplayItem& item)
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

EvaluationPool::EvaluationPool(NodeConfig config, int threads, Format format, std::function<void(EvaluationPool&)> read)
    : config_(std::move(config)),
      format_(std::move(format)),
      hold_(format_.wheelsets.size(), HoldLast(config_)),
      open_(format_.wheelsets.size())
{
  for (int i = 0; i < threads; ++i)
  {
    start([this] { work(); });
  }
  start(
      [this, read = std::move(read)]
      {
        read(*this);
        const std::lock_guard<std::mutex> lock(mutex_);
        closed_ = true;
        front_ready_.notify_one();
      });
}

EvaluationPool::~EvaluationPool()
{
  stop(nullptr);
  for (std::thread& thread : threads_)
  {
    thread.join();
  }
}

/// Starts a thread. The pool ends at an exception in it.
void EvaluationPool::start(const std::function<void()>& task)
{
  threads_.emplace_back(
      [this, task]
      {
        try
        {
          task();
        }
        catch (...)
        {
          stop(std::current_exception());
        }
      });
}

/// Ends all waiting.
/// @param reason exception for pop(); of several calls the first exception counts
void EvaluationPool::stop(std::exception_ptr reason)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  stopped_ = true;
  reason_ = reason_ ? reason_ : std::move(reason);
  space_.notify_all();
  wake_.notify_all();
  front_ready_.notify_all();
}

bool EvaluationPool::append(ReplayItem item)
{
  std::unique_lock<std::mutex> lock(mutex_);
  space_.wait(lock, [this] { return stopped_ || entries_.empty() || bytes_ < budget; });
  if (stopped_)
  {
    return false;
  }
  Entry& entry = entries_.emplace_back(std::move(item));
  charge(entry);
  if (entry.is_evaluated)
  {
    addToSlice(entry);
  }
  else if (entries_.size() == 1)
  {
    front_ready_.notify_one();
  }
  return true;
}

void EvaluationPool::addToSlice(Entry& entry)
{
  std::shared_ptr<Slice>& slice = open_[*entry.wheelset];
  if (!slice || entry.input.resets)
  {
    if (slice)
    {
      slice->closed = true;
      offer(slice);
    }
    slice = std::make_shared<Slice>();
    slice->number = slices_++;
  }
  slice->waiting.push_back(&entry);
  offer(slice);
}

/// Offers a slice to the threads. A closed slice is offered once more, to release its evaluator.
void EvaluationPool::offer(const std::shared_ptr<Slice>& slice)
{
  if (!slice->taken && offered_.emplace(slice->number, slice).second)
  {
    wake_.notify_one();
  }
}

void EvaluationPool::work()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (true)
  {
    wake_.wait(lock, [this] { return stopped_ || !offered_.empty(); });
    if (stopped_)
    {
      return;
    }
    const std::shared_ptr<Slice> slice = offered_.begin()->second;
    offered_.erase(offered_.begin());
    run(*slice, lock);
  }
}

/// Evaluates the waiting inputs of a slice, and those that arrive meanwhile. The mutex is released during evaluations.
void EvaluationPool::run(Slice& slice, std::unique_lock<std::mutex>& lock)
{
  slice.taken = true;
  if (!slice.evaluator && !idle_.empty())
  {
    slice.evaluator = std::move(idle_.back());
    idle_.pop_back();
  }
  while (!slice.waiting.empty() && !stopped_)
  {
    Entry& entry = *slice.waiting.front();
    slice.waiting.pop_front();
    lock.unlock();
    if (!slice.evaluator)
    {
      slice.evaluator = std::make_unique<ContactEvaluator>(config_);
    }
    entry.output = slice.evaluator->evaluate(entry.input);
    if (isUsable(entry.output.status))
    {
      format_.write(entry);  // already here, because HoldLast does not change it
      if (config_.hold_last == 0)
      {
        entry.output.release();
      }
    }
    lock.lock();
    complete(entry);
  }
  slice.taken = false;
  if (slice.closed && slice.evaluator)
  {
    idle_.push_back(std::move(slice.evaluator));
  }
}

void EvaluationPool::complete(Entry& entry)
{
  entry.ready = true;
  charge(entry);
  largest_result_ = std::max(largest_result_, sizeOf(entry));
  if (&entry == &entries_.front())
  {
    front_ready_.notify_one();
  }
}

/// Updates the memory attributed to an item. An unfinished result counts as much as the largest result so far.
void EvaluationPool::charge(Entry& entry)
{
  bytes_ -= entry.charged;
  entry.charged = overhead + (entry.ready ? sizeOf(entry) : largest_result_);
  bytes_ += entry.charged;
}

std::optional<ReplayItem> EvaluationPool::pop()
{
  std::unique_lock<std::mutex> lock(mutex_);
  const auto is_ready = [this] { return !entries_.empty() && entries_.front().ready; };
  front_ready_.wait_for(lock, pop_timeout, [&] { return reason_ || is_ready() || (closed_ && entries_.empty()); });
  if (reason_)
  {
    std::rethrow_exception(reason_);
  }
  if (!is_ready())
  {
    return std::nullopt;
  }
  Entry entry = std::move(entries_.front());
  entries_.pop_front();
  bytes_ -= entry.charged;
  if (bytes_ < budget / 4 * 3 || entries_.empty())
  {
    space_.notify_one();
  }
  lock.unlock();
  if (entry.is_evaluated)
  {
    hold_[*entry.wheelset].apply(entry.output);
    if (!isUsable(entry.output.status))
    {
      format_.write(entry);
    }
  }
  return entry.warm_up ? std::nullopt : std::optional<ReplayItem>(std::move(entry));
}

bool EvaluationPool::isEmpty()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return closed_ && entries_.empty();
}

void EvaluationPool::Format::write(ReplayItem& item) const
{
  WheelsetContact message = toMessage(item.output, grids);
  message.header.seq = item.sequence;
  item.data = serialized(message);
  item.csv = csv ? csvRows(message, item.result, wheelsets[*item.wheelset]) : "";
}
}  // namespace wheel_rail_contact
