// SPDX-License-Identifier: BSD-3-Clause
#include "replay/replay.h"

#include <ros/package.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <ostream>

#include "core/option_check.h"
#include "replay/result_connection.h"

namespace wheel_rail_contact
{
namespace
{
/// Number of inputs before the output from which a slice begins early enough for HoldLast.
constexpr std::size_t warm_up_inputs = HoldLast::memory + ResetRule::slice_capacity;
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

/// First warm-up [ns]. It suffices if stamps are recording times: any two seconds contain a whole second of the stamps,
/// and results of neighbours are used for one second.
constexpr std::uint64_t shortest_lead = 3'000'000'000;
constexpr std::uint64_t lead_growth = 4;

bool isTransform(const std::string& topic)
{
  return topic == "/tf" || topic == "/tf_static" || topic == "tf" || topic == "tf_static";
}

bool holdsTransforms(const BagContents& contents)
{
  return std::any_of(contents.messages.begin(), contents.messages.end(),
                     [&contents](const auto& entry)
                     { return entry.second > 0 && isTransform(contents.connections.at(entry.first).topic); });
}

std::uint64_t startOf(const BagContents& contents)
{
  std::uint64_t start = std::numeric_limits<std::uint64_t>::max();
  for (const BagChunk& chunk : contents.chunks)
  {
    start = std::min(start, chunk.start);
  }
  return start;
}

/// Recording time [ns] at which reading must begin. The results in `options.span` are then those of a replay of the
/// whole bag: ReplaySource::isWarmedUp() is true at the beginning of the span.
///
/// Returns 0, the beginning of the bag, where a part of the bag is not sufficient to verify this:
/// - with transforms, because their buffer depends on all earlier messages;
/// - with a slop, because an earlier message may change which messages are matched;
/// - without an index.
/// @throw BagError if the bag cannot be read.
std::uint64_t warmUpStart(const ReplayOptions& options, const NodeConfig& config)
{
  const std::uint64_t from = options.span.from;
  if (from == 0 || config.slop > 0)
  {
    return 0;
  }
  const BagContents contents =
      readContents(BagFile(options.input, options.most_expanded), [](const std::string&) { return true; });
  if (!contents.fault.empty() || holdsTransforms(contents))
  {
    return 0;
  }
  const std::uint64_t start = startOf(contents);
  for (std::uint64_t lead = shortest_lead; lead < from && from - lead > start; lead *= lead_growth)
  {
    ReplaySource before(options.input, config, options.inputs, false, {from - lead, from}, from - lead,
                        options.most_expanded);
    while (before.next())
    {
    }
    if (before.isWarmedUp())
    {
      return from - lead;
    }
  }
  return 0;
}

/// Checks the output files before the input is opened, because a bag without index is read completely. Clears `resume`
/// if the output does not exist.
ReplayOptions withCheckedOutputs(ReplayOptions options)
{
  const auto place = [](const std::string& path)
  { return std::filesystem::weakly_canonical("./" / std::filesystem::path(path)); };
  core::refuseIf(place(options.csv) == place(options.output), "--csv: is the bag of the results");
  const bool exists = std::filesystem::exists(options.output);
  core::refuseIf<std::runtime_error>(
      exists && !options.resume, options.output + ": already exists and is not overwritten (--resume continues it)");
  options.resume = exists;
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
              warmUpStart(options_, config_), options_.most_expanded),
      description_(replayDescription(options_, parameters_, source_.fileSize())),
      warm_up_(options_.inputs.wheelsets.size())
{
  if (!options_.tf_static.empty())
  {
    source_.readStaticTransforms(options_.tf_static);
  }
  if (!options_.csv.empty())
  {
    csv_ = std::make_unique<CsvFile>(options_.csv, options_.resume);
  }
  bag_ = options_.resume ? resumeOutput() : std::make_unique<BagWriter>(options_.output, options_.compression);
  if (csv_)
  {
    bag_->onChunk([this] { csv_->flush(); });
  }
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
  const bool is_same = contents.chunks.empty() || std::any_of(contents.connections.begin(), contents.connections.end(),
                                                              [this](const auto& entry)
                                                              {
                                                                const BagFields& header = entry.second.header;
                                                                return header.has(description_field) &&
                                                                       header.text(description_field) == description_;
                                                              });
  core::refuseIf<std::runtime_error>(!is_same, options_.output +
                                                   ": cannot be resumed; it contains no results of this input with "
                                                   "these parameters and options");
  resume_point_ = resumePointOf(file);
  auto bag = std::make_unique<BagWriter>(options_.output, options_.compression, resume_point_);
  counts_ = resumedResults(options_.output, resume_point_, options_.inputs.wheelsets.size());
  return bag;
}

void Replay::run(const std::atomic<bool>& interrupted)
{
  Progress progress(source_.messages());
  {
    EvaluationPool pool(config_, options_.threads, {options_.grids, csv_ != nullptr, options_.inputs.wheelsets},
                        [this](EvaluationPool& own) { read(own); });
    // An interrupt takes effect after the resumed messages. Otherwise table and connections would be incomplete.
    while (!pool.isEmpty() && !(interrupted && written_ >= resume_point_.messages))
    {
      if (const auto item = pool.pop())
      {
        write(*item);
      }
      progress.show(last_read_, results_ - results_before_);
    }
  }
  if (csv_)
  {
    csv_->finish(results_);
  }
  bag_->close();
  seconds_ = progress.elapsed();
  progress.finish(last_read_, results_ - results_before_);
}

/// Reads the input, and passes on what belongs to the output.
void Replay::read(EvaluationPool& pool)
{
  std::uint64_t messages = 0, results = 0;
  std::vector<std::uint32_t> sequence(options_.inputs.wheelsets.size(), 0);
  while (auto item = source_.next())
  {
    item->resumed = !item->warm_up && messages < resume_point_.messages;
    if (item->wheelset && (item->warm_up || item->resumed))
    {
      keepForWarmUp(*item);
    }
    if (item->warm_up)
    {
      continue;
    }
    ++messages;
    if (item->wheelset)
    {
      item->result = results++;
      item->sequence = sequence[*item->wheelset]++;
    }
    if ((!item->resumed && !addWarmUp(pool)) || !pool.append(std::move(*item)))
    {
      return;
    }
  }
}

void Replay::keepForWarmUp(ReplayItem item)
{
  item.warm_up = true;
  item.resumed = false;
  std::deque<ReplayItem>& last = warm_up_[*item.wheelset];
  last.push_back(std::move(item));
  if (last.size() > warm_up_inputs)
  {
    last.pop_front();
  }
}

/// Evaluates the last inputs before the output, from the beginning of a slice.
/// @return false if the pool ends
bool Replay::addWarmUp(EvaluationPool& pool)
{
  for (std::deque<ReplayItem>& last : warm_up_)
  {
    auto item = std::find_if(last.begin(), last.end(), [](const ReplayItem& i) { return i.input.resets; });
    for (; item != last.end(); ++item)
    {
      if (!pool.append(std::move(*item)))
      {
        return false;
      }
    }
    last.clear();
  }
  return true;
}

void Replay::write(const ReplayItem& item)
{
  ++written_;
  if (item.wheelset)
  {
    ++results_;
    results_before_ += item.resumed ? 1U : 0U;
  }
  if (item.wheelset && !item.resumed)
  {
    counts_.add(item.output.status, item.output.reason, item.output.held);
    if (!item.output.rejected)
    {
      loads_.add(item.output.state, item.output.status == WheelsetContact::LIFT_OFF);
    }
    if (csv_)
    {
      csv_->write(item.result, item.csv);
    }
  }
  last_read_ = item.read;
  const auto number = item.wheelset ? static_cast<std::uint32_t>(*item.wheelset) : keptConnection(item);
  bag_->write(number, item.time, item.data);
}

std::uint32_t Replay::keptConnection(const ReplayItem& item)
{
  const auto [found, is_new] = kept_connections_.try_emplace(item.connection_id);
  if (is_new)
  {
    found->second = bag_->addConnection(*item.connection);
  }
  return found->second;
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
    const PairingCounts counts = source_.pairing(i);
    for (std::size_t reason = 0; reason < counts.dropped.size(); ++reason)
    {
      if (counts.dropped[reason] > 0)
      {
        out << "  " << options_.inputs.wheelsets[i] << "/wheelset: " << counts.dropped[reason]
            << " messages dropped: " << dropText(static_cast<DropReason>(reason), counts) << "\n";
      }
    }
    if (const std::uint64_t lacking = source_.lackingNeighbour(i))
    {
      out << "  " << resultTopic(options_.inputs.wheelsets[i]) << ": " << lacking
          << " results lack a neighbour's forces\n";
    }
  }
  if (const std::string doubt = loadDoubt(); !doubt.empty())
  {
    out << "  " << doubt << "\n";
  }
  const std::string refused = source_.transforms().refused();
  out << (refused.empty() ? "" : "  /tf: " + refused + "\n");
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
