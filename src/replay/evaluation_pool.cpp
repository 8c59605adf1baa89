// SPDX-License-Identifier: BSD-3-Clause
#include "replay/evaluation_pool.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <tuple>
#include <utility>

#include "replay/bag_messages.h"
#include "replay/csv_rows.h"
#include "ros/evaluation/conversions.h"

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

EvaluationPool::EvaluationPool(NodeConfig config, int threads, Format format, OutputQueue& output)
    : config_(std::move(config)), format_(std::move(format)), output_(output), open_(format_.wheelsets.size())
{
  for (int i = 0; i < threads; ++i)
  {
    threads_.emplace_back(&EvaluationPool::work, this);
  }
}

EvaluationPool::~EvaluationPool()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = true;
    wake_.notify_all();
  }
  for (std::thread& thread : threads_)
  {
    thread.join();
  }
}

void EvaluationPool::add(std::size_t wheelset, PreparedInput input, OutputItem* item)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  std::shared_ptr<Slice>& slice = open_[wheelset];
  if (!slice || input.resets)
  {
    if (slice)
    {
      slice->closed = true;
      offer(slice);
    }
    slice = std::make_shared<Slice>();
    slice->number = slices_++;
  }
  slice->waiting.push_back({std::move(input), item});
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
  try
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
  catch (...)
  {
    output_.stop(std::current_exception());
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
    const std::vector<Job> jobs = std::exchange(slice.waiting, {});
    lock.unlock();
    if (!slice.evaluator)
    {
      slice.evaluator = std::make_unique<ContactEvaluator>(config_);
    }
    for (const Job& job : jobs)
    {
      evaluate(*slice.evaluator, job);
    }
    lock.lock();
  }
  slice.taken = false;
  if (slice.closed && slice.evaluator)
  {
    idle_.push_back(std::move(slice.evaluator));
  }
}

void EvaluationPool::evaluate(ContactEvaluator& evaluator, const Job& job) const
{
  ContactOutput output = evaluator.evaluate(job.input);
  std::string data, csv;
  if (isUsable(output.status))
  {
    std::tie(data, csv) = format_.write(output, *job.item);
    if (config_.hold_last == 0)
    {
      output.release();
    }
  }
  output_.complete(*job.item, std::move(output), std::move(data), std::move(csv));
}

std::pair<std::string, std::string> EvaluationPool::Format::write(const ContactOutput& output,
                                                                  const OutputItem& item) const
{
  WheelsetContact message = toMessage(output, grids);
  message.header.seq = item.sequence;
  return {serialized(message), csv ? csvRows(message, item.result, wheelsets[*item.wheelset]) : ""};
}
}  // namespace wheel_rail_contact
