// SPDX-License-Identifier: BSD-3-Clause
#include "replay/replay.h"

#include <ros/package.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include "replay/result_connection.h"
#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
namespace
{
constexpr std::size_t queue_budget = 96 << 20;  ///< [B]
constexpr std::chrono::milliseconds bar_period(200);
constexpr std::chrono::seconds line_period(10);
constexpr int bar_width = 30;

/// Displays progress, speed and remaining time of a replay on stderr: a bar on a terminal, otherwise a line every 10 s.
class Progress
{
 public:
  /// @param total number of messages to read
  explicit Progress(std::uint64_t total);

  /// Updates the display if it is due. May be called often.
  /// @param read messages read so far
  /// @param results results written so far in this run
  void show(std::uint64_t read, std::uint64_t results);
  /// Prints the final state on a terminal and ends the line.
  void finish(std::uint64_t read, std::uint64_t results);

  /// Time since construction [s].
  double elapsed() const;

 private:
  using Clock = std::chrono::steady_clock;
  void print(std::uint64_t read, std::uint64_t results) const;

  std::uint64_t total_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};

Progress::Progress(std::uint64_t total)
    : total_(total), terminal_(isatty(STDERR_FILENO) != 0), next_(terminal_ ? start_ : start_ + line_period)
{
}

double Progress::elapsed() const
{
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::show(std::uint64_t read, std::uint64_t results)
{
  if (Clock::now() >= next_)
  {
    print(read, results);
    next_ = Clock::now() + (terminal_ ? Clock::duration(bar_period) : Clock::duration(line_period));
  }
}

void Progress::finish(std::uint64_t read, std::uint64_t results)
{
  if (terminal_)
  {
    print(read, results);
    std::fputc('\n', stderr);
  }
}

void Progress::print(std::uint64_t read, std::uint64_t results) const
{
  const double share = total_ > 0 ? std::min(1.0, static_cast<double>(read) / static_cast<double>(total_)) : 1.0;
  const double rate = static_cast<double>(results) / std::max(elapsed(), 1e-3);
  const double left = share > 0 ? elapsed() * (1 - share) / share : 0;
  const auto filled = static_cast<std::size_t>(std::lround(share * bar_width));
  const std::string bar =
      terminal_ ? "\r[" + std::string(filled, '#') + std::string(bar_width - filled, '.') + "] " : std::string();
  std::fprintf(stderr, "%s%5.1f %%  %llu results, %.0f/s, %.0f s left %s", bar.c_str(), 100 * share,
               static_cast<unsigned long long>(results), rate, std::ceil(left), terminal_ ? "  " : "\n");
}

/// Checks the output files before the input is opened, because a bag without index is read completely. Clears `resume`
/// if the output does not exist.
ReplayOptions withCheckedOutputs(ReplayOptions options)
{
  if (std::filesystem::exists(options.output))
  {
    if (!options.resume)
    {
      throw std::runtime_error(options.output + ": already exists and is not overwritten (--resume continues it)");
    }
  }
  else
  {
    options.resume = false;
  }
  if (!options.csv.empty())
  {
    CsvFile::requireUsablePath(options.csv, options.resume);
  }
  return options;
}
}  // namespace

Replay::Replay(ReplayOptions options)
    : options_(withCheckedOutputs(std::move(options))),
      parameters_(replayParameters(options_)),
      config_(readNodeConfig(parameters_, "", {".", ros::package::getPath})),
      source_(options_.input, config_, options_.inputs, options_.keep_topics, options_.span,
              warmUpStart(options_, config_)),
      description_(replayDescription(options_, parameters_, source_.fileSize())),
      queue_(queue_budget),
      warm_up_(options_.inputs.wheelsets.size(), WarmUpInputs(HoldLast::memory)),
      hold_(options_.inputs.wheelsets.size(), HoldLast(config_)),
      format_{options_.grids, !options_.csv.empty(), options_.inputs.wheelsets}
{
  if (options_.resume)
  {
    bag_ = resumeOutput();
  }
  if (!options_.csv.empty())
  {
    csv_ = std::make_unique<CsvFile>(options_.csv, options_.resume);
  }
  if (!options_.resume)
  {
    bag_ = std::make_unique<BagWriter>(options_.output, options_.compression);
  }
  bag_->onChunk(
      [this]
      {
        if (csv_)
        {
          csv_->flush();
        }
      });
  for (const std::string& wheelset : options_.inputs.wheelsets)
  {
    bag_->addConnection(resultConnection(wheelset, description_, config_.model));
  }
}

/// Opens the output for resuming, if its results have the same description: same input, parameters and options.
std::unique_ptr<BagWriter> Replay::resumeOutput()
{
  const BagFile file(options_.output);
  const auto any_topic = [](const std::string&) { return true; };
  const BagContents contents = readContents(file, any_topic);
  const bool has_messages = !contents.chunks.empty();
  bool is_same = !has_messages;
  for (const auto& [number, connection] : contents.connections)
  {
    is_same = is_same ||
              (connection.header.has(description_field) && connection.header.text(description_field) == description_);
  }
  if (!is_same)
  {
    throw std::runtime_error(options_.output +
                             ": cannot be resumed; it contains no results of this input with "
                             "these parameters and options");
  }
  resume_point_ = resumePointOf(file);
  auto bag = std::make_unique<BagWriter>(options_.output, options_.compression, resume_point_);
  counts_ = resumedResults(options_.output, resume_point_, options_.inputs.wheelsets.size());
  return bag;
}

void Replay::run(const std::atomic<bool>& interrupted)
{
  Progress progress(source_.messages());
  {
    EvaluationPool pool(config_, options_.threads, format_, queue_);
    std::thread reader([this, &pool] { read(pool); });
    try
    {
      OutputItem item;
      // An interrupt takes effect after the resumed messages. Otherwise table and connections would be incomplete.
      const auto is_over = [&] { return interrupted && written_ >= resume_point_.messages; };
      for (auto state = OutputQueue::State::later; state != OutputQueue::State::end && !is_over();)
      {
        state = queue_.pop(item);
        if (state == OutputQueue::State::item)
        {
          write(item);
        }
        progress.show(last_read_, results_ - results_before_);
      }
    }
    catch (...)
    {
      queue_.stop();
      reader.join();
      throw;
    }
    queue_.stop();
    reader.join();
  }
  if (csv_)
  {
    csv_->finish(results_);
  }
  bag_->close();
  seconds_ = progress.elapsed();
  progress.finish(last_read_, results_ - results_before_);
}

/// Reads the input and distributes the evaluations. Runs in the thread of the reader.
void Replay::read(EvaluationPool& pool)
{
  try
  {
    std::uint64_t messages = 0, results = 0;
    bool has_begun = false;
    std::vector<std::uint32_t> sequence(options_.inputs.wheelsets.size(), 0);
    while (auto event = source_.next())
    {
      const bool wanted = !event->warm_up && messages >= resume_point_.messages;
      if (event->wheelset && !wanted)
      {
        warm_up_[*event->wheelset].add(std::move(event->input));
      }
      if (event->warm_up)
      {
        continue;
      }
      if (wanted && !has_begun && !addWarmUp(pool))
      {
        return;
      }
      has_begun = wanted;
      ++messages;
      OutputItem item;
      static_cast<ReplayItem&>(item) = std::move(static_cast<ReplayItem&>(*event));
      item.ready = !event->wheelset || !wanted;
      if (event->wheelset)
      {
        item.result = results++;
        item.sequence = sequence[*event->wheelset]++;
      }
      OutputItem* const place = queue_.append(std::move(item));
      if (!place)
      {
        return;
      }
      if (event->wheelset && wanted)
      {
        pool.add(*event->wheelset, std::move(event->input), place);
      }
    }
    queue_.close();
  }
  catch (...)
  {
    queue_.stop(std::current_exception());
  }
}

/// Evaluates the last inputs before the output.
/// @return false if the queue was stopped
bool Replay::addWarmUp(EvaluationPool& pool)
{
  for (std::size_t i = 0; i < warm_up_.size(); ++i)
  {
    for (PreparedInput& input : warm_up_[i].inputs())
    {
      OutputItem item;
      item.wheelset = i;
      item.warm_up = true;
      OutputItem* const place = queue_.append(std::move(item));
      if (!place)
      {
        return false;
      }
      pool.add(i, std::move(input), place);
    }
    warm_up_[i].inputs().clear();
  }
  return true;
}

void Replay::write(OutputItem& item)
{
  if (item.warm_up)
  {
    hold_[*item.wheelset].apply(item.output);
    return;
  }
  const bool is_resumed = written_++ < resume_point_.messages;
  if (item.wheelset)
  {
    ++results_;
    results_before_ += is_resumed ? 1U : 0U;
  }
  if (item.wheelset && !is_resumed)
  {
    hold_[*item.wheelset].apply(item.output);
    if (!isUsable(item.output.status))
    {
      std::tie(item.data, item.csv) = format_.write(item.output, item);
    }
    counts_.add(item.output.status, item.output.reason, item.output.held);
  }
  if (csv_ && item.wheelset && !is_resumed)
  {
    csv_->write(item.result, item.csv);
  }
  last_read_ = item.read;
  const auto number = item.wheelset ? static_cast<std::uint32_t>(*item.wheelset) : keptConnection(item);
  bag_->write(number, item.time, item.data);
}

std::uint32_t Replay::keptConnection(const OutputItem& item)
{
  const auto found = kept_connections_.find(item.connection_id);
  if (found != kept_connections_.end())
  {
    return found->second;
  }
  return kept_connections_[item.connection_id] = bag_->addConnection(*item.connection);
}

void Replay::printSummary(std::ostream& out) const
{
  const std::uint64_t evaluated = results_ - results_before_;
  out << evaluated << " pairs evaluated in " << seconds_ << " s, "
      << static_cast<std::uint64_t>(static_cast<double>(evaluated) / seconds_) << "/s";
  if (results_before_ > 0)
  {
    out << "; " << results_before_ << " results were already in the output";
  }
  out << "\n";
  counts_.print(out, poses());
  for (std::size_t i = 0; i < options_.inputs.wheelsets.size(); ++i)
  {
    const auto dropped = source_.dropped(i);
    for (std::size_t reason = 0; reason < dropped.size(); ++reason)
    {
      if (dropped[reason] > 0)
      {
        out << "  " << options_.inputs.wheelsets[i] << "/wheelset: " << dropped[reason]
            << " messages dropped: " << dropName(static_cast<DropReason>(reason)) << "\n";
      }
    }
    if (const std::uint64_t lacking = source_.lackingNeighbour(i))
    {
      out << "  " << resultTopic(options_.inputs.wheelsets[i]) << ": " << lacking
          << " results lack a neighbour's forces\n";
    }
  }
  const auto& sections = config_.model.rail_sections;
  if ((config_.model.track.line || sections.left || sections.right) && evaluated > 1 && !source_.hasMoved())
  {
    out << "  all results are at 0 m on the line; the place is x of the pose, or wheelset/distance (track/distance)\n";
  }
  out << "  " << results_ << " of " << poses() << " poses have a result";
  if (const std::uint64_t unusable = counts_.unusableInputs())
  {
    out << "; the input of " << unusable << " of these is unusable (INVALID_INPUT, NO_TRANSFORM)";
  }
  out << "\n";
}
}  // namespace wheel_rail_contact
