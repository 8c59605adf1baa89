// SPDX-License-Identifier: BSD-3-Clause
#include "replay/replay_source.h"

#include <tf2_msgs/TFMessage.h>

#include "core/option_check.h"
#include "replay/bag_messages.h"
#include "ros/evaluation/hold_last.h"

namespace wheel_rail_contact
{
namespace
{
/// Transforms in the bytes of a message tf2_msgs/TFMessage. They are added one by one, without reserving memory: the
/// count in a damaged message may be arbitrarily large.
/// @throw ros::serialization::StreamOverrunException if the message is truncated.
std::vector<geometry_msgs::TransformStamped> parseTransforms(std::string_view data)
{
  std::vector<geometry_msgs::TransformStamped> transforms;
  readStream(data,
             [&transforms](auto& stream)
             {
               std::uint32_t count = 0;
               stream.next(count);
               for (; count > 0; --count)
               {
                 stream.next(transforms.emplace_back());
               }
             });
  return transforms;
}

/// Longest time for which an input waits for its transform [ns].
constexpr auto transform_timeout_ns = static_cast<std::uint64_t>(InputPreparation::transform_timeout * 1e9);

/// Topic with a leading slash. `rosbag play` publishes a topic without one in the root namespace.
std::string absolute(const std::string& topic)
{
  return topic.empty() || topic[0] != '/' ? "/" + topic : topic;
}

std::set<std::string> resultTopics(const std::vector<std::string>& wheelsets)
{
  std::set<std::string> topics;
  std::transform(wheelsets.begin(), wheelsets.end(), std::inserter(topics, topics.end()), resultTopic);
  return topics;
}
}  // namespace

std::string resultTopic(const std::string& wheelset)
{
  return wheelset + "/contact_node/contact";
}

ReplaySource::ReplaySource(const std::string& bag, const NodeConfig& config, const BagInputs& inputs, bool keep,
                           const BagSpan& span, std::uint64_t warm_up, std::uint64_t most_expanded)
    : span_(span),
      results_(resultTopics(inputs.wheelsets)),
      uses_(usesOf(config, inputs)),
      keep_(keep),
      stream_(
          bag, [this](const std::string& topic) { return isRead(topic); }, {warm_up, span.to}, most_expanded)
{
  for (std::size_t i = 0; i < inputs.wheelsets.size(); ++i)
  {
    wheelsets_.emplace_back(config, transforms_);
  }
  requireTopics();
  requireTypes();
}

void ReplaySource::readStaticTransforms(const std::string& bag)
{
  BagStream first(bag, [](const std::string& topic) { return absolute(topic) == "/tf_static"; });
  std::uint64_t count = 0;
  for (; const auto message = first.next(); ++count)
  {
    use({Role::static_transform}, *message);
  }
  refuseBagIf(count == 0, bag + ": has no message on /tf_static");
}

ReplaySource::Uses ReplaySource::usesOf(const NodeConfig& config, const BagInputs& inputs) const
{
  const std::vector<InputTopic> topics = inputTopics(config);
  inputs.check(topics);
  const std::vector<std::string>& wheelsets = inputs.wheelsets;
  Uses uses{{"/tf", {Role::transform}}, {"/tf_static", {Role::static_transform}}};
  for (std::size_t i = 0; i < wheelsets.size(); ++i)
  {
    for (const InputTopic topic : topics)
    {
      uses.insert({inputs.topicOf(wheelsets[i], topic), {Role::input, i, topic}});
    }
    for (std::size_t k = 0; k < config.neighbours.size(); ++k)
    {
      const std::string& topic = config.neighbours[k].topic;
      const std::string name = topic[0] == '/' ? topic : wheelsets[i] + "/" + topic;
      requireFromEarlierRun(name);
      uses.insert({name, {Role::neighbour, i, {}, k}});
    }
  }
  return uses;
}

bool ReplaySource::isRead(const std::string& topic) const
{
  const std::string name = absolute(topic);
  return uses_.count(name) > 0 || (keep_ && results_.count(name) == 0);
}

/// Rejects a neighbour whose results this run computes: only results of an earlier run are in the input.
void ReplaySource::requireFromEarlierRun(const std::string& topic) const
{
  core::refuseIf(results_.count(topic) > 0,
                 "rail_bending/neighbours: topic " + topic +
                     " is a result of this same run; replay that wheelset first with --keep-topics, and use "
                     "the resulting bag as the input for the other wheelset");
}

std::string ReplaySource::reasonOfMissing(const std::string& topic, const Use& use) const
{
  const std::string type = typeAndSumOf(use).first;
  std::string topics;
  for (const auto& entry : stream_.contents().connections)
  {
    const BagConnection& connection = entry.second;
    if (connection.header.has("type") && connection.header.text("type") == type)
    {
      topics.append(" ").append(connection.topic);
    }
  }
  const std::string reason =
      "the bag has no topic " + topic + "; its topics of type " + type + ":" + (topics.empty() ? " none" : topics);
  return use.role == Role::input && !topics.empty() ? reason + "; " + optionOf(use.topic) + " names another topic"
                                                    : reason;
}

void ReplaySource::requireTopics() const
{
  std::string reasons;
  for (const auto& [topic, use] : uses_)
  {
    const auto& connections = stream_.contents().connections;
    const bool is_there =
        std::any_of(connections.begin(), connections.end(),
                    [&name = topic](const auto& entry) { return absolute(entry.second.topic) == name; });
    if (!is_there && use.role != Role::transform && use.role != Role::static_transform)
    {
      reasons += (reasons.empty() ? "" : "; ") + reasonOfMissing(topic, use);
    }
  }
  if (!reasons.empty())
  {
    for (const std::string& fault : stream_.faults())
    {
      reasons.append("; ").append(fault);
    }
    throw BagError(reasons);
  }
}

std::pair<std::string, std::string> ReplaySource::typeAndSumOf(const Use& use)
{
  switch (use.role)
  {
    case Role::neighbour:
      return typeAndSum<WheelsetContact>();
    case Role::transform:
    case Role::static_transform:
      return typeAndSum<tf2_msgs::TFMessage>();
    default:
      return withMessageType(use.topic, [](auto type) { return typeAndSum<typename decltype(type)::Message>(); });
  }
}

void ReplaySource::requireTypes() const
{
  for (const auto& entry : stream_.contents().connections)
  {
    const BagConnection& connection = entry.second;
    const auto [first, last] = uses_.equal_range(absolute(connection.topic));
    for (auto use = first; use != last; ++use)
    {
      const auto wanted = typeAndSumOf(use->second);
      if (connection.header.text("md5sum") != wanted.second)
      {
        const std::string type = connection.header.text("type");
        throw BagError("the bag's topic " + connection.topic + " is of type " + type +
                       (type == wanted.first
                            ? ", but of another version of its package: `rosbag fix` converts it (doc/replay.md)"
                            : ", not " + wanted.first));
      }
    }
  }
}

std::uint64_t ReplaySource::messages() const
{
  std::uint64_t sum = 0;
  for (const auto& [connection, count] : stream_.contents().messages)
  {
    sum += isRead(stream_.contents().connections.at(connection).topic) ? count : 0;
  }
  return sum;
}

std::vector<std::string> ReplaySource::faults() const
{
  std::vector<std::string> faults = stream_.faults();
  if (damaged_ > 0)
  {
    faults.push_back(std::to_string(damaged_) + " messages are truncated");
  }
  return faults;
}

std::optional<ReplayItem> ReplaySource::next()
{
  while (items_.empty() && !finished_)
  {
    const auto message = stream_.next();
    if (!message)
    {
      finish();
    }
    else if (message->time < span_.to)
    {
      take(*message);
    }
    else  // waiting inputs become complete after the span
    {
      finished_ = true;
    }
  }
  if (items_.empty())
  {
    return std::nullopt;
  }
  ReplayItem item = std::move(items_.front());
  items_.pop_front();
  return item;
}

void ReplaySource::take(const BagMessage& message)
{
  ++read_;
  now_ = std::max(now_, message.time);
  beginSpan();
  release(true);
  if (keep_ && in_span_)
  {
    ReplayItem& item = items_.emplace_back();
    item.time = now_;
    item.connection_id = message.connection_id;
    item.connection = message.connection;
    item.data = message.data;
    item.read = read_;
  }
  const auto [first, last] = uses_.equal_range(absolute(message.connection->topic));
  try
  {
    for (auto found = first; found != last; ++found)
    {
      use(found->second, message);
    }
  }
  catch (const ros::serialization::StreamOverrunException&)
  {
    ++damaged_;
  }
  release(false);
}

void ReplaySource::use(const Use& use, const BagMessage& message)
{
  if (use.role == Role::transform || use.role == Role::static_transform)
  {
    for (const auto& transform : parseTransforms(message.data))
    {
      transforms_.add(transform, use.role == Role::static_transform);
    }
    return;
  }
  if (use.role == Role::neighbour)
  {
    wheelsets_[use.wheelset].neighbours.add(use.neighbour, *parse<ResultHead>(message.data));
    return;
  }
  Wheelset& wheelset = wheelsets_[use.wheelset];
  auto inputs = withMessageType(
      use.topic, [&](auto type)
      { return wheelset.pairing.add(use.topic, parse<typename decltype(type)::Message>(message.data)); });
  for (ContactInput& input : inputs)
  {
    wheelset.waiting.push_back({std::move(input), now_ + transform_timeout_ns});
  }
}

/// Emits the inputs that need not wait any longer, in order for each wheelset.
/// @param only_overdue true: only inputs whose deadline has passed; false: also inputs whose transform is available
void ReplaySource::release(bool only_overdue)
{
  for (std::size_t i = 0; i < wheelsets_.size(); ++i)
  {
    Wheelset& wheelset = wheelsets_[i];
    while (!wheelset.waiting.empty() &&
           (wheelset.waiting.front().deadline < now_ ||
            (!only_overdue && wheelset.preparation.isReady(wheelset.waiting.front().input))))
    {
      emit(i);
    }
  }
}

void ReplaySource::emit(std::size_t wheelset)
{
  Wheelset& own = wheelsets_[wheelset];
  ReplayItem& item = items_.emplace_back();
  item.time = now_;
  item.wheelset = wheelset;
  item.input = own.preparation.prepare(own.waiting.front().input);
  item.read = read_;
  item.warm_up = !in_span_;
  const bool is_evaluated = item.input.status == WheelsetContact::OK;
  has_moved_ = has_moved_ || (in_span_ && is_evaluated && item.input.state.distance != 0);
  own.lacking_neighbour += in_span_ && is_evaluated && item.input.lacks_neighbour ? 1U : 0U;
  observe(own, item.input.stamp);
  own.waiting.pop_front();
}

/// Begins the span when it is reached: messages dropped from now on are counted.
void ReplaySource::beginSpan()
{
  if (!in_span_ && (finished_ || now_ >= span_.from))
  {
    in_span_ = true;
    for (Wheelset& wheelset : wheelsets_)
    {
      wheelset.dropped_before = wheelset.pairing.counts().dropped;
      wheelset.poses_dropped_before = wheelset.pairing.droppedPoses();
    }
  }
}

/// Updates the state of the warm-up of a wheelset, see isWarmedUp().
void ReplaySource::observe(Wheelset& wheelset, const ros::Time& stamp)
{
  const bool is_reset = wheelset.last_stamp && ResetRule::isBoundary(*wheelset.last_stamp, stamp);
  wheelset.warmed_up =
      wheelset.warmed_up || (is_reset && wheelset.all_matched && wheelset.neighbours.reachBackFrom(stamp));
  wheelset.results += wheelset.warmed_up && wheelset.results < HoldLast::memory ? 1 : 0;
  wheelset.all_matched = wheelset.all_matched || wheelset.pairing.isSettled();
  wheelset.last_stamp = stamp;
}

bool ReplaySource::isWarmedUp() const
{
  return std::all_of(wheelsets_.begin(), wheelsets_.end(),
                     [](const Wheelset& wheelset) { return wheelset.results == HoldLast::memory; });
}

PairingCounts ReplaySource::pairing(std::size_t wheelset) const
{
  PairingCounts counts = wheelsets_[wheelset].pairing.counts();
  for (std::size_t reason = 0; reason < counts.dropped.size(); ++reason)
  {
    counts.dropped[reason] -= wheelsets_[wheelset].dropped_before[reason];
  }
  return counts;
}

std::uint64_t ReplaySource::droppedPoses() const
{
  std::uint64_t sum = 0;
  for (const Wheelset& wheelset : wheelsets_)
  {
    sum += wheelset.pairing.droppedPoses() - wheelset.poses_dropped_before;
  }
  return sum;
}

/// Emits the inputs that still wait at the end of the bag.
void ReplaySource::finish()
{
  for (std::size_t i = 0; i < wheelsets_.size(); ++i)
  {
    while (!wheelsets_[i].waiting.empty())
    {
      emit(i);
    }
    wheelsets_[i].pairing.finish();
  }
  finished_ = true;
  beginSpan();
}
}  // namespace wheel_rail_contact
