// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bag/bag_stream.h"
#include "replay/replay_item.h"
#include "ros/node/contact_input.h"
#include "ros/node/neighbour_forces.h"

namespace wheel_rail_contact
{
/// What comes next in a replay: an input to be answered, or a message to be kept.
struct ReplayEvent : ReplayItem
{
  PreparedInput input;   ///< of an answer
  bool warm_up = false;  ///< not asked for, but the answers after it may start from it
};

/// Makes of a bag's messages the inputs that the live node would make of them: pairs them by their stamps, and brings
/// them to the track frame by the bag's transforms, for which they wait as long as in the live node. Forces of
/// neighbouring wheelsets come from their answers in the bag.
class ReplaySource
{
 public:
  /// @param wheelsets namespaces, "" or "/name"
  /// @param keep true: all messages are delivered too, but for answers of an earlier run
  /// @param span what becomes ready in it is delivered
  /// @param warm_up where to begin to read, at or before the span [ns]; see warmUpStart()
  /// @throw BagError if the bag cannot be read.
  ReplaySource(const std::string& bag, const NodeConfig& config, const std::vector<std::string>& wheelsets, bool keep,
               const BagSpan& span = {}, std::uint64_t warm_up = 0);

  /// The next event, nothing at the end.
  std::optional<ReplayEvent> next();

  /// Number of messages that will be read.
  std::uint64_t messages() const;
  /// Of the bag [B].
  std::uint64_t fileSize() const { return stream_.fileSize(); }
  /// Messages dropped in the span, by DropReason.
  std::array<std::uint64_t, PairingCounts::reasons> dropped(std::size_t wheelset) const;
  /// Inputs in the span that are evaluated without the forces of a neighbour.
  std::uint64_t lackingNeighbour(std::size_t wheelset) const { return wheelsets_[wheelset].lacking_neighbour; }
  /// True if every wheelset's next input will be what it is to one who has read the bag from its beginning, and its
  /// answer as well: there was a fresh start after pairs had come out even. (For equal stamps, and without transforms.)
  bool isCertain() const;
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
    explicit Wheelset(const NodeConfig& config) : pairing(config), preparation(config), neighbours(config) {}

    InputPairing pairing;
    InputPreparation preparation;
    NeighbourForces neighbours;
    std::deque<Waiting> waiting;                                         ///< for their transforms
    std::array<std::uint64_t, PairingCounts::reasons> dropped_before{};  ///< the span
    std::uint64_t lacking_neighbour = 0;                                 ///< inputs in the span
    std::optional<ros::Time> last_stamp;
    bool settled = false;  ///< pairs have come out even
    bool certain = false;  ///< see isCertain()
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
  void beginSpan();
  static void observe(Wheelset& wheelset, const ros::Time& stamp);

  BagSpan span_;
  bool in_span_ = false;
  std::set<std::string> results_;  ///< topics
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
std::string resultTopic(const std::string& wheelset);
}  // namespace wheel_rail_contact
