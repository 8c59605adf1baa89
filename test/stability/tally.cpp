// SPDX-License-Identifier: BSD-3-Clause
#include "tally.h"

#include <algorithm>
#include <cstdio>

namespace wheel_rail_contact::core::stability
{
namespace
{
constexpr std::size_t most_examples = 5;

/// Answers that violate the contact conditions by more than this many tolerances, and the share of them that passes:
/// descent, plane, roll and the rail's way may each be open by about one of them, descent and plane by more where
/// passes do not settle early, which tells at conformal flanges. The short campaign (states 4000 1) finds 0.03 %.
constexpr double grave_violation = 3;
constexpr double most_violating = 0.005;

/// Share of the steps of 1 um that may change the highest pressure by more than the estimated errors explain; estimates
/// are made to hold in 97 % of the patches or more. The short campaign finds none in 1079.
constexpr double most_torn = 0.004;

std::string region(const Scene& scene, const WheelsetState& state)
{
  const double beyond = beyondPlay(scene.config, state);
  std::string where = beyond < 0.0005 ? "tread" : beyond < 0.0035 ? "near the flange" : "climbing or beside the rail";
  if (!scene.config.wheelset.solve_height_and_roll)
  {
    return where + ", height given";
  }
  const double load = -0.5 * state.force_z;
  return where + (load < 1e3 ? ", below 1 kN" : load > 2e5 ? ", above 200 kN" : "");
}

std::string firstWord(const std::string& text)
{
  return text.substr(0, text.find(','));
}

std::string placeOf(const Tally::Entry& entry)
{
  return "scene " + std::to_string(entry.scene_seed) + ", state " + std::to_string(entry.index);
}
}  // namespace

std::string where(const Tally::Entry& entry)
{
  return placeOf(entry) + ": " + describe(entry.scene) + "; " + describe(entry.state);
}

void Tally::add(const Entry& entry)
{
  ++states_;
  ++methods_[firstWord(entry.scene.method)].states;
  ++rails_[entry.scene.rail].states;
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
  const std::string method = firstWord(entry.scene.method), &rail = entry.scene.rail;
  ++methods_[method].refused;
  ++rails_[rail].refused;
  Refusals& refusals = refusals_[entry.result.reason][region(entry.scene, entry.state)];
  if (refusals.count++ == 0)
  {
    refusals.first = placeOf(entry) + ", " + method + ", rail " + rail;
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
  if (pair == Pair::torn && torn_.size() < most_examples)
  {
    torn_.push_back(where);
  }
}

void Tally::printRefusals() const
{
  std::printf("refusals by reason and region, and the first of each\n");
  for (const auto& [reason, regions] : refusals_)
  {
    std::printf("  %s\n", reason.c_str());
    for (const auto& [name, refusals] : regions)
    {
      std::printf("    %-42s %8ld  %s\n", name.c_str(), refusals.count, refusals.first.c_str());
    }
  }
  printShares("by method", methods_);
  printShares("by rail", rails_);
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
  std::printf("violation of the contact conditions over the tolerance:");
  for (const double share : {0.5, 0.9, 0.99, 0.999, 1.0})
  {
    const auto last = static_cast<double>(sorted.size()) - 1;
    std::printf(" %.1f %% below %.3g;", 100 * share,
                sorted.empty() ? 0 : sorted[static_cast<std::size_t>(share * last)]);
  }
  std::printf(" the worst:\n  %s\n", worst_where_.c_str());
  std::printf("%.2f %% of the answers are above %g tolerances\n", 100 * violatingShare(), grave_violation);
}

long Tally::count(Pair pair) const
{
  const auto found = pairs_.find(pair);
  return found == pairs_.end() ? 0 : found->second;
}

double Tally::violatingShare() const
{
  const auto grave =
      std::count_if(violations_.begin(), violations_.end(), [](double v) { return v > grave_violation; });
  return violations_.empty() ? 0 : static_cast<double>(grave) / static_cast<double>(violations_.size());
}

double Tally::tornShare() const
{
  const long all = count(Pair::continuous) + count(Pair::torn);
  return all == 0 ? 0 : static_cast<double>(count(Pair::torn)) / static_cast<double>(all);
}

bool Tally::isGood() const
{
  return !hasFaults() && violatingShare() <= most_violating && tornShare() <= most_torn;
}

void Tally::print() const
{
  std::printf("%ld states: %ld usable (%ld of them with an error estimate above the tolerance), %ld refused\n", states_,
              usable_, above_tolerance_, states_ - usable_);
  std::printf("%.3f ms of processor time a state; slowest %.1f ms:\n  %s\n",
              1e3 * seconds_ / static_cast<double>(states_), 1e3 * slowest_, slowest_where_.c_str());
  printRefusals();
  std::printf(
      "steps of 1 um: %ld continuous, %ld contact jumps, %ld beyond the bound without a jump, %ld to or from a "
      "refusal, %ld between refusals\n",
      count(Pair::continuous), count(Pair::jumped), count(Pair::torn), count(Pair::one_refused),
      count(Pair::both_refused));
  for (const std::string& example : torn_)
  {
    std::printf("  beyond the bound: %s\n", example.c_str());
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
