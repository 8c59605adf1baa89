// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "wheel_rail_contact/bag/bag_stream.h"
#include "wheel_rail_contact/replay/replay_item.h"
#include "wheel_rail_contact/ros/contact_input.h"
#include "wheel_rail_contact/ros/neighbour_forces.h"

namespace wheel_rail_contact
{
/// What comes next in a replay: an input to be answered, or a message to be kept.
struct ReplayEvent : ReplayItem
{
  PreparedInput input;  ///< of an answer
};

/// Makes of a bag's messages the inputs that the live node would make of them: pairs them by their stamps, and brings
/// them to the track frame by the bag's transforms, for which they wait as long as in the live node. Forces of
/// neighbouring wheelsets come from their answers in the bag.
class ReplaySource
{
 public:
  /// @param wheelsets namespaces, "" or "/name"
  /// @param keep true: all messages are delivered too, but for answers of an earlier run
  /// @throw BagError if the bag cannot be read.
  ReplaySource(const std::string& bag, const NodeConfig& config, const std::vector<std::string>& wheelsets, bool keep);

  /// The next event, nothing at the end.
  std::optional<ReplayEvent> next();

  /// Number of messages that will be read.
  std::uint64_t messages() const;
  /// Of the bag [B].
  std::uint64_t fileSize() const { return stream_.fileSize(); }
  /// Where a wheelset's messages went.
  const PairingCounts& counts(std::size_t wheelset) const { return wheelsets_[wheelset].pairing.counts(); }
  /// What could not be read so far, in sentences.
  std::vector<std::string> faults() const;

 private:
  enum class Role
  {
    pose,
    load,
    left_rail_force,
    right_rail_force,
    neighbour,
    transform,
    static_transform
  };
  struct Use
  {
    Role role;
    std::size_t wheelset;
    std::size_t neighbour = 0;  ///< its number in the configuration
  };
  using Uses = std::multimap<std::string, Use>;  ///< by topic
  struct Waiting
  {
    ContactInput input;
    std::uint64_t deadline;  ///< [ns]
  };
  struct Wheelset
  {
    InputPairing pairing;
    InputPreparation preparation;
    NeighbourForces neighbours;
    std::deque<Waiting> waiting;  ///< for their transforms
  };

  Uses usesOf(const NodeConfig& config, const std::vector<std::string>& wheelsets) const;
  static std::pair<std::string, std::string> typeAndSumOf(Role role);
  bool wants(const std::string& topic) const;
  void requireTopics() const;
  void requireTypes() const;
  void requireAnotherRuns(const std::string& topic) const;
  [[noreturn]] void refuseWithout(const std::string& topic, const std::string& type) const;
  void take(const BagMessage& message);
  void use(const Use& use, const BagMessage& message);
  std::optional<ContactInput> pair(const Use& use, const BagMessage& message);
  void release(bool only_overdue);
  void emit(std::size_t wheelset);
  void finish();

  std::set<std::string> answers_;  ///< topics
  Uses uses_;
  bool keep_;
  std::vector<Wheelset> wheelsets_;
  tf2::BufferCore transforms_;
  BagStream stream_;
  std::deque<ReplayEvent> events_;
  std::uint64_t now_ = 0;   ///< recording time of the last message [ns]
  std::uint64_t read_ = 0;  ///< messages
  std::uint64_t damaged_ = 0;
  bool finished_ = false;
};

/// Topic of a wheelset's answers.
std::string answerTopic(const std::string& wheelset);
}  // namespace wheel_rail_contact
