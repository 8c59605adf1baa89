// SPDX-License-Identifier: BSD-3-Clause
#include "replay/evaluation_pool.h"

#include <exception>
#include <tuple>

#include "replay/bag_messages.h"
#include "replay/csv_rows.h"
#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
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
