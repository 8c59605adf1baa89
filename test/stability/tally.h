// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "random_scene.h"

namespace wheel_rail_contact::core::stability
{
/// What a campaign has seen.
class Tally
{
 public:
  /// A state, its answer, the processor time it took [s], and what is wrong with it.
  struct Entry
  {
    const Scene& scene;
    unsigned long scene_seed;
    int index;  ///< of the state in its scene's walk
    const WheelsetState& state;
    const WheelsetResult& result;
    double seconds;
    double violation;
    const std::vector<std::string>& faults;
  };
  void add(const Entry& entry);

  /// Two close neighbours.
  enum class Pair
  {
    continuous,
    jumped,
    torn,  ///< no jump, but a change beyond the bound
    one_refused,
    both_refused
  };
  void add(Pair pair, const std::string& where);

  long states() const { return states_; }
  /// No fault, and no more rough answers than are known to come.
  bool isGood() const;
  /// Something was wrong with an answer.
  bool hasFaults() const { return !faults_.empty(); }
  void print() const;

 private:
  /// States of one method or rail.
  struct Share
  {
    long states = 0, refused = 0;
  };
  using Shares = std::map<std::string, Share>;
  /// Refusals of one reason in one region.
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
  double tornShare() const;
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
  std::vector<std::string> torn_;
  std::vector<double> violations_;  ///< over the tolerance
  double worst_violation_ = 0;
  std::string worst_where_;
};
/// An entry's scene and state in words.
std::string where(const Tally::Entry& entry);
}  // namespace wheel_rail_contact::core::stability
