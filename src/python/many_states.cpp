// SPDX-License-Identifier: BSD-3-Clause
#include "python/many_states.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>

#include "python/contact_model.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
namespace
{
using core::PatchResult;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::chrono::milliseconds between_checks{50};  ///< of an interruption

/// Patch of a side with the largest normal force, or null.
const PatchResult* mainPatch(const core::WheelsetResult& result, core::Side side)
{
  const PatchResult* found = nullptr;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side && (found == nullptr || patch.normal_force > found->normal_force))
    {
      found = &patch;
    }
  }
  return found;
}

/// Threads that share the states of one call.
class Evaluation
{
 public:
  Evaluation(const NodeConfig& config, const std::vector<core::WheelsetState>& states, bool keep_results)
      : config_(config), states_(states), results_(states.size())
  {
    if (keep_results)
    {
      results_.results.resize(states.size());
    }
  }

  ManyResults run(std::size_t threads, const std::function<bool()>& is_interrupted)
  {
    std::vector<std::thread> workers = start(threads);
    wait(is_interrupted);
    for (std::thread& worker : workers)
    {
      worker.join();
    }
    if (error_)
    {
      std::rethrow_exception(error_);
    }
    return std::move(results_);
  }

 private:
  /// Starts the threads; fewer if the system has no more.
  std::vector<std::thread> start(std::size_t threads)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::thread> workers;
    workers.reserve(threads);
    try
    {
      for (; running_ < threads; ++running_)
      {
        workers.emplace_back([this] { work(); });
      }
    }
    catch (const std::system_error&)
    {
      if (workers.empty())
      {
        throw;
      }
    }
    return workers;
  }

  void wait(const std::function<bool()>& is_interrupted)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!ended_.wait_for(lock, between_checks, [this] { return running_ == 0; }))
    {
      lock.unlock();  // is_interrupted may wait for the interpreter
      const bool interrupted = is_interrupted();
      lock.lock();
      next_ = interrupted ? states_.size() : next_;
    }
  }

  void work()
  {
    std::exception_ptr error;
    try
    {
      core::WheelsetContact contact(config_.model);
      for (std::size_t i = take(); i < states_.size(); i = take())
      {
        evaluate(contact, i);
      }
    }
    catch (...)
    {
      error = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    if (error)
    {
      error_ = error;
      next_ = states_.size();
    }
    --running_;
    ended_.notify_one();
  }

  std::size_t take()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return next_ < states_.size() ? next_++ : next_;
  }

  void evaluate(core::WheelsetContact& contact, std::size_t i)
  {
    contact.reset();
    const core::WheelsetResult& result = contact.evaluate(states_[i]);
    results_.set(i, result, config_.linear_range);
    if (!results_.results.empty())
    {
      results_.results[i] = std::make_shared<core::WheelsetResult>(result);
      results_.results[i]->reason = results_.status_text[i];
    }
  }

  const NodeConfig& config_;
  const std::vector<core::WheelsetState>& states_;
  ManyResults results_;  ///< each row is written by one thread
  std::mutex mutex_;     ///< of all below
  std::condition_variable ended_;
  std::size_t next_ = 0;     ///< first state that no thread has taken
  std::size_t running_ = 0;  ///< number of threads
  std::exception_ptr error_;
};
}  // namespace

ManyResults::ManyResults(std::size_t count) : status(count), status_text(count)
{
  const auto rows = static_cast<Eigen::Index>(count);
  above_tolerance.setConstant(rows, 1, false);
  implausible_force.setConstant(rows, 1, false);
  z.setConstant(rows, nan);
  roll.setConstant(rows, nan);
  patches.setZero(rows, 2);
  for (SideColumns* columns :
       {&vertical_force, &lateral_force, &max_pressure, &area, &error_estimate, &contact_angle, &rolling_radius,
        &wheel_von_mises, &rail_von_mises, &rail_lateral, &rail_vertical, &rail_roll})
  {
    columns->setConstant(rows, 2, nan);
  }
}

Eigen::Array<bool, Eigen::Dynamic, 1> ManyResults::usable() const
{
  Eigen::Array<bool, Eigen::Dynamic, 1> flags(above_tolerance.rows());
  std::transform(status.begin(), status.end(), flags.data(),
                 [](core::ContactStatus each) { return core::isUsable(each); });
  return flags;
}

void ManyResults::set(std::size_t i, const core::WheelsetResult& result, const core::Sides<double>& linear_range)
{
  status[i] = result.status;
  status_text[i] = statusTextOf(result, linear_range);
  if (!isUsable(result.status))
  {
    return;
  }
  const auto row = static_cast<Eigen::Index>(i);
  above_tolerance(row) = result.above_tolerance;
  implausible_force(row) = result.implausible_force;
  z(row) = result.z;
  roll(row) = result.roll;
  for (const core::Side side : core::sides)
  {
    setSide(row, side, result);
  }
}

void ManyResults::setSide(Eigen::Index row, core::Side side, const core::WheelsetResult& result)
{
  const Eigen::Index column = side == core::Side::left ? 0 : 1;
  const core::WheelForces& wheel = result.wheel[side];
  const core::RailDeflection& rail = result.rail[side].deflection;
  vertical_force(row, column) = wheel.vertical;
  lateral_force(row, column) = wheel.lateral;
  rail_lateral(row, column) = rail.lateral;
  rail_vertical(row, column) = rail.vertical;
  rail_roll(row, column) = rail.roll;
  max_pressure(row, column) = area(row, column) = error_estimate(row, column) = 0;
  wheel_von_mises(row, column) = rail_von_mises(row, column) = 0;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      ++patches(row, column);
      max_pressure(row, column) = std::max(max_pressure(row, column), patch.max_pressure);
      area(row, column) += patch.area;
      error_estimate(row, column) = std::max(error_estimate(row, column), patch.error_estimate);
      wheel_von_mises(row, column) = std::max(wheel_von_mises(row, column), patch.wheel_stress.von_mises.value);
      rail_von_mises(row, column) = std::max(rail_von_mises(row, column), patch.rail_stress.von_mises.value);
    }
  }
  if (const PatchResult* patch = mainPatch(result, side))
  {
    contact_angle(row, column) = patch->contact_angle;
    rolling_radius(row, column) = patch->rolling_radius;
  }
}

ManyResults evaluateMany(const NodeConfig& config, const std::vector<core::WheelsetState>& states,
                         const ManyOptions& options, const std::function<bool()>& is_interrupted)
{
  const auto threads = std::min(static_cast<std::size_t>(options.threads), states.size());
  return Evaluation(config, states, options.keep_results).run(threads, is_interrupted);
}
}  // namespace wheel_rail_contact
