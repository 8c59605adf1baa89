// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace wheel_rail_contact::core::stability
{
/// Statistics of the results of a campaign.
class Tally
{
 public:
  /// A state and its result.
  struct Entry
  {
    const Scene& scene;
    const std::string& scene_name;
    int index;  ///< of the state in its scene
    const WheelsetState& state;
    const WheelsetResult& result;
    double seconds;    ///< processor time of the evaluation [s]
    double violation;  ///< of the contact conditions, over the depth of overlap [-]
    const std::vector<std::string>& faults;
  };
  void add(const Entry& entry);

  /// The results of two neighbouring states.
  enum class Pair
  {
    continuous,
    jumped,         ///< a contact appears, disappears or moves to another place
    discontinuous,  ///< no jump, but a change beyond the bound
    one_refused,
    both_refused
  };
  void add(Pair pair, const std::string& where);

  long states() const { return states_; }
  /// No faults, and at most the allowed shares of violations and discontinuities.
  bool isGood() const;
  bool hasFaults() const { return !faults_.empty(); }
  void print() const;

 private:
  /// States of one method or rail model.
  struct Share
  {
    long states = 0, refused = 0;
  };
  using Shares = std::map<std::string, Share>;
  /// Refusals for one reason in one region.
  struct Refusals
  {
    long count = 0;
    std::string first;
  };
  struct Faults
  {
    long count = 0;
    std::vector<std::string> examples;
  };

  void addTime(const Entry& entry);
  void addUsable(const Entry& entry);
  void addRefusal(const Entry& entry);
  void addFaults(const Entry& entry);
  long count(Pair pair) const;
  double violatingShare() const;
  double discontinuousShare() const;
  void printRefusals() const;
  void printViolations() const;
  static void printShares(const char* title, const Shares& shares);

  long states_ = 0, usable_ = 0, above_tolerance_ = 0;
  double slowest_ = 0, seconds_ = 0;
  std::string slowest_where_;
  std::map<std::string, std::map<std::string, Refusals>> refusals_;  ///< by reason and region
  Shares methods_, rails_;
  std::map<std::string, Faults> faults_;  ///< by kind
  std::map<Pair, long> pairs_;
  std::vector<std::string> discontinuous_;
  std::vector<double> violations_;  ///< over the tolerance
  double worst_violation_ = 0;
  std::string worst_where_;
};
/// Scene and state of an entry in words.
std::string where(const Tally::Entry& entry);
}  // namespace wheel_rail_contact::core::stability
