// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
#include "replay/replay_options.h"
#include "ros/evaluation/contact_evaluator.h"
#include "ros/evaluation/transform_store.h"

namespace wheel_rail_contact
{
/// A message of the output of a replay: a result, or a copied message of the input (--keep-topics). ReplaySource makes
/// it, the stages of the evaluation complete it (EvaluationPool).
struct ReplayItem
{
  std::optional<std::size_t> wheelset;        ///< wheelset of a result; empty: a copied message
  std::uint32_t connection_id = 0;            ///< of a copied message, in the input
  const BagConnection* connection = nullptr;  ///< of a copied message
  std::uint64_t time = 0;  ///< recording time: of a copied message, or when the input became complete [ns]
  std::uint64_t read = 0;  ///< messages read from the input so far
  PreparedInput input;     ///< of a result
  bool warm_up = false;    ///< true: the result is not output, but later results may start from it

  bool resumed = false;        ///< true: the message is already in the output
  std::uint64_t result = 0;    ///< number of the result in the output
  std::uint32_t sequence = 0;  ///< number of the result among those of its wheelset

  ContactOutput output;  ///< the result
  std::string data;      ///< bytes of the message
  std::string csv;       ///< rows of the table
};

/// Forms from the messages of a bag the same inputs as the live node. It matches messages by their stamps and
/// transforms them to the track frame with the transforms in the bag. Inputs wait for a transform as long as in the
/// live node, in recording time. Forces of neighbouring wheelsets are taken from their results in the bag.
class ReplaySource
{
 public:
  /// @param inputs wheelsets and their topics
  /// @param keep true: all messages are also delivered for copying, except earlier results of the same wheelsets
  /// @param span inputs that become complete in this span are delivered
  /// @param warm_up recording time at which reading begins, at or before the span [ns]; see warmUpStart()
  /// @param most_expanded see BagFile
  /// @throw BagError if the bag cannot be read, or if a topic is missing or has the wrong type.
  /// @throw std::invalid_argument if a neighbour is one of the wheelsets of this run, or if a topic is named that the
  /// configuration does not require.
  ReplaySource(const std::string& bag, const NodeConfig& config, const BagInputs& inputs, bool keep,
               const BagSpan& span = {}, std::uint64_t warm_up = 0, std::uint64_t most_expanded = 0);

  /// The next input to evaluate, or message to copy; empty at the end.
  std::optional<ReplayItem> next();

  /// Reads the topic /tf_static of another bag.
  /// @throw BagError if it has none.
  void readStaticTransforms(const std::string& bag);
  /// Number of messages to read.
  std::uint64_t messages() const;
  /// Size of the bag [B].
  std::uint64_t fileSize() const { return stream_.fileSize(); }
  /// Numbers of messages of a wheelset; those dropped are counted in the span.
  PairingCounts pairing(std::size_t wheelset) const;
  /// Number of poses of all wheelsets that were dropped in the span.
  std::uint64_t droppedPoses() const;
  /// Transforms of the bag.
  const TransformStore& transforms() const { return transforms_; }
  /// True if an input in the span is at another place of the line than 0.
  bool hasMoved() const { return has_moved_; }
  /// Number of inputs in the span that are evaluated without the forces of a neighbour.
  std::uint64_t lackingNeighbour(std::size_t wheelset) const { return wheelsets_[wheelset].lacking_neighbour; }
  /// True once the next result of every wheelset is the same as if the bag had been read from its beginning. For each
  /// wheelset, three things must have happened in this order:
  /// 1. All messages read so far were matched.
  /// 2. A warm-start reset, at which the results of each neighbour were known for the time in which they are used.
  /// 3. As many results as HoldLast requires.
  /// Valid only with a slop of 0 and for bags without transforms.
  bool isWarmedUp() const;
  /// Parts of the bag that could not be read so far, as text.
  std::vector<std::string> faults() const;

 private:
  enum class Role
  {
    input,
    neighbour,
    transform,
    static_transform
  };
  struct Use
  {
    Role role;
    std::size_t wheelset = 0;
    InputTopic topic = InputTopic::pose;  ///< of an input
    std::size_t neighbour = 0;            ///< index in NodeConfig::neighbours
  };
  using Uses = std::multimap<std::string, Use>;  ///< by topic with a leading slash
  struct Waiting
  {
    ContactInput input;
    std::uint64_t deadline;  ///< recording time up to which it waits [ns]
  };
  struct Wheelset
  {
    Wheelset(const NodeConfig& config, const TransformStore& transforms)
        : pairing(config), neighbours(config), preparation(config, transforms, neighbours)
    {
    }

    InputPairing pairing;
    NeighbourForces neighbours;
    InputPreparation preparation;
    std::deque<Waiting> waiting;                                         ///< inputs that wait for their transforms
    std::array<std::uint64_t, PairingCounts::reasons> dropped_before{};  ///< dropped before the span
    std::uint64_t poses_dropped_before = 0;                              ///< the same of the poses
    std::uint64_t lacking_neighbour = 0;                                 ///< see lackingNeighbour()
    std::optional<ros::Time> last_stamp;
    bool all_matched = false;  ///< at some time no message was waiting for a match
    bool warmed_up = false;    ///< a reset after which the results are those of the whole bag has occurred
    int results = 0;           ///< number of results since then, at most HoldLast::memory
  };

  Uses usesOf(const NodeConfig& config, const BagInputs& inputs) const;
  static std::pair<std::string, std::string> typeAndSumOf(const Use& use);
  bool isRead(const std::string& topic) const;
  void requireTopics() const;
  void requireTypes() const;
  void requireFromEarlierRun(const std::string& topic) const;
  std::string reasonOfMissing(const std::string& topic, const Use& use) const;
  void take(const BagMessage& message);
  void use(const Use& use, const BagMessage& message);
  void release(bool only_overdue);
  void emit(std::size_t wheelset);
  void finish();
  void beginSpan();
  static void observe(Wheelset& wheelset, const ros::Time& stamp);

  BagSpan span_;
  bool in_span_ = false;
  std::set<std::string> results_;  ///< topics of the results of this run
  Uses uses_;
  bool keep_;
  TransformStore transforms_;
  std::deque<Wheelset> wheelsets_;
  BagStream stream_;
  std::deque<ReplayItem> items_;
  std::uint64_t now_ = 0;   ///< recording time of the last message [ns]
  std::uint64_t read_ = 0;  ///< number of messages read
  std::uint64_t damaged_ = 0;
  bool finished_ = false;
  bool has_moved_ = false;  ///< see hasMoved()
};

/// Topic of the results of a wheelset.
std::string resultTopic(const std::string& wheelset);
}  // namespace wheel_rail_contact
