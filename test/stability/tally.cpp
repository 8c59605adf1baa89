// SPDX-License-Identifier: BSD-3-Clause
#include "tally.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
constexpr std::size_t most_examples = 5;

/// A result violates the contact conditions if the violation is larger than this number of tolerances. Penetration,
/// roll and rail deflection each contribute up to about one tolerance.
constexpr double violation_limit = 3;
/// Allowed share of such results. The short campaign (states 4000 1) finds 0.06 %.
constexpr double most_violating = 0.005;

/// Allowed share of small steps that change the highest pressure by more than the error estimates explain. The
/// estimates hold in at least 97 % of the patches. The short campaign finds 1 in 1090 steps.
constexpr double most_discontinuous = 0.004;

std::string region(const Scene& scene, const WheelsetState& state)
{
  const double beyond = beyondClearance(scene.config, state);
  std::string where = beyond < 0.0005 ? "tread" : beyond < 0.0035 ? "near the flange" : "climbing or beside the rail";
  if (!scene.config.wheelset.solve_height_and_roll)
  {
    return where + ", height given";
  }
  const double load = -0.5 * state.force_z;
  return where + (load < 1e3 ? ", below 1 kN" : load > 2e5 ? ", above 200 kN" : "");
}

std::string placeOf(const Tally::Entry& entry)
{
  return entry.scene_name + ", state " + std::to_string(entry.index);
}

std::string methodOf(const Tally::Entry& entry)
{
  return toString(entry.scene.config.contact.method);
}
}  // namespace

std::string where(const Tally::Entry& entry)
{
  return placeOf(entry) + ": " + describe(entry.scene) + "; " + describe(entry.state);
}

void Tally::add(const Entry& entry)
{
  ++states_;
  ++methods_[methodOf(entry)].states;
  ++rails_[railModel(entry.scene)].states;
  addTime(entry);
  if (isUsable(entry.result.status))
  {
    addUsable(entry);
  }
  else
  {
    addRefusal(entry);
  }
  addFaults(entry);
}

void Tally::addTime(const Entry& entry)
{
  seconds_ += entry.seconds;
  if (entry.seconds > slowest_)
  {
    slowest_ = entry.seconds;
    slowest_where_ = where(entry);
  }
}

void Tally::addUsable(const Entry& entry)
{
  ++usable_;
  above_tolerance_ += entry.result.above_tolerance ? 1 : 0;
  if (entry.violation > 0)
  {
    violations_.push_back(entry.violation / entry.scene.config.contact.tolerance);
    if (violations_.back() > worst_violation_)
    {
      worst_violation_ = violations_.back();
      worst_where_ = where(entry);
    }
  }
}

void Tally::addRefusal(const Entry& entry)
{
  const std::string method = methodOf(entry), rail = railModel(entry.scene);
  ++methods_[method].refused;
  ++rails_[rail].refused;
  Refusals& refusals = refusals_[entry.result.reason][region(entry.scene, entry.state)];
  if (refusals.count++ == 0)
  {
    refusals.first = placeOf(entry) + ", " + method + ", rails: " + rail;
  }
}

void Tally::addFaults(const Entry& entry)
{
  for (const std::string& fault : entry.faults)
  {
    Faults& faults = faults_[fault.substr(0, fault.find(" ("))];
    ++faults.count;
    if (faults.examples.size() < most_examples)
    {
      faults.examples.push_back(fault + " in " + where(entry));
    }
  }
}

void Tally::add(Pair pair, const std::string& where)
{
  ++pairs_[pair];
  if (pair == Pair::discontinuous && discontinuous_.size() < most_examples)
  {
    discontinuous_.push_back(where);
  }
}

void Tally::printRefusals() const
{
  std::printf("refusals by reason and region, with the first state of each\n");
  for (const auto& [reason, regions] : refusals_)
  {
    std::printf("  %s\n", reason.c_str());
    for (const auto& [name, refusals] : regions)
    {
      std::printf("    %-42s %8ld  %s\n", name.c_str(), refusals.count, refusals.first.c_str());
    }
  }
  printShares("by method", methods_);
  printShares("by rail model", rails_);
}

void Tally::printShares(const char* title, const Shares& shares)
{
  std::printf("%s\n", title);
  for (const auto& [name, share] : shares)
  {
    std::printf("  %-28s %8ld states, %7ld refused (%.2f %%)\n", name.c_str(), share.states, share.refused,
                100.0 * static_cast<double>(share.refused) / static_cast<double>(share.states));
  }
}

void Tally::printViolations() const
{
  std::vector<double> sorted = violations_;
  std::sort(sorted.begin(), sorted.end());
  std::printf("violation of the contact conditions, in tolerances:");
  for (const double share : {0.5, 0.9, 0.99, 0.999, 1.0})
  {
    const auto last = static_cast<double>(sorted.size()) - 1;
    std::printf(" %.1f %% of the results up to %.3g;", 100 * share,
                sorted.empty() ? 0 : sorted[static_cast<std::size_t>(share * last)]);
  }
  std::printf(" largest:\n  %s\n", worst_where_.c_str());
  std::printf("%.2f %% of the results violate them by more than %g tolerances\n", 100 * violatingShare(),
              violation_limit);
}

long Tally::count(Pair pair) const
{
  const auto found = pairs_.find(pair);
  return found == pairs_.end() ? 0 : found->second;
}

double Tally::violatingShare() const
{
  const auto violating =
      std::count_if(violations_.begin(), violations_.end(), [](double v) { return v > violation_limit; });
  return violations_.empty() ? 0 : static_cast<double>(violating) / static_cast<double>(violations_.size());
}

double Tally::discontinuousShare() const
{
  const long all = count(Pair::continuous) + count(Pair::discontinuous);
  return all == 0 ? 0 : static_cast<double>(count(Pair::discontinuous)) / static_cast<double>(all);
}

bool Tally::isGood() const
{
  return !hasFaults() && violatingShare() <= most_violating && discontinuousShare() <= most_discontinuous;
}

void Tally::print() const
{
  std::printf("%ld states: %ld usable (%ld of them with an error estimate above the tolerance), %ld refused\n", states_,
              usable_, above_tolerance_, states_ - usable_);
  std::printf("%.3f ms of processor time per state; slowest %.1f ms:\n  %s\n",
              1e3 * seconds_ / static_cast<double>(states_), 1e3 * slowest_, slowest_where_.c_str());
  printRefusals();
  std::printf(
      "steps of 1 um: %ld continuous, %ld with a jump of a contact, %ld discontinuous without a jump, %ld with one "
      "result refused, %ld with both refused\n",
      count(Pair::continuous), count(Pair::jumped), count(Pair::discontinuous), count(Pair::one_refused),
      count(Pair::both_refused));
  for (const std::string& example : discontinuous_)
  {
    std::printf("  discontinuous: %s\n", example.c_str());
  }
  printViolations();
  for (const auto& [kind, faults] : faults_)
  {
    std::printf("FAULT %s: %ld\n", kind.c_str(), faults.count);
    for (const std::string& example : faults.examples)
    {
      std::printf("  %s\n", example.c_str());
    }
  }
}
}  // namespace wheel_rail_contact::core::stability
