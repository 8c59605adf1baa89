// SPDX-License-Identifier: BSD-3-Clause
// Random wheelsets in random states: does every one get an answer that holds, or a refusal that says why?
//
//   stability_campaign TABLES states N [seed, default 1]     N states
//   stability_campaign TABLES minutes M [seed, default 1]    as many as M minutes allow
//   stability_campaign TABLES scene S                        one scene, each state printed
//
// TABLES is the folder of the rails' compliance tables (config/rails). A scene is drawn from profiles, inclination,
// gauge, method, tolerance, grid and rail, and walked through in 30 states (random_scene.h); each answer is checked
// from outside (result_check.h) and, where only 1 um of y lies between, against the one before (continuity.h). Prints
// refusals by reason and region, the slowest state, and what was wrong, with the scene's seed. Ends with 1 if anything
// was wrong or, over many scenes, if more answers than usual are rough (tally.cpp). The same seed gives the same
// states.
//
// A short form runs with the tests, as do some scenes in which long ones found faults. The long one, a quarter of an
// hour, and a million states, over an hour of processor time, in two halves side by side:
//   build/devel/lib/wheel_rail_contact/stability_campaign config/rails minutes 15 2
//   build/devel/lib/wheel_rail_contact/stability_campaign config/rails states 500000 SEED
#include <ctime>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

#include "continuity.h"
#include "random_scene.h"
#include "result_check.h"
#include "ros/parameters/compliance_table_file.h"
#include "tally.h"

namespace
{
using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::stability;

constexpr int states_of_a_scene = 30;

double processorTime()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<NamedTable> readTables(const std::string& folder)
{
  std::vector<NamedTable> tables;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.path().extension() == ".yaml")
    {
      const wheel_rail_contact::ComplianceTableFile file = wheel_rail_contact::readComplianceTable(entry.path());
      tables.push_back({file.name, file.table});
    }
  }
  std::sort(tables.begin(), tables.end(), [](const NamedTable& a, const NamedTable& b) { return a.name < b.name; });
  return tables;
}

/// Hertz's answer belongs to the curvatures at one place, and jumps where they do.
bool isSmooth(NormalMethod method)
{
  return method != NormalMethod::hertz;
}

class Campaign
{
 public:
  explicit Campaign(const std::string& tables) : pool_(makePool(readTables(tables))) {}

  void runScene(unsigned long seed, bool aloud);
  const Tally& tally() const { return tally_; }

 private:
  void compare(const std::string& where, const WheelsetResult& result);

  Pool pool_;
  Tally tally_;
  WheelsetResult last_;
};

/// For people who look at one scene.
void print(int index, const WheelsetState& state, const WheelsetResult& result, const std::vector<std::string>& faults)
{
  std::printf("%2d %s\n   status %d %s\n", index, describe(state).c_str(), static_cast<int>(result.status),
              result.reason.c_str());
  for (const PatchResult& p : result.patches)
  {
    std::printf(
        "   %s: y %.5f m, angle %.4f rad, N %.6g N, approach %.4g m, area %.4g m2, pmax %.6g Pa, estimate %.3g, %d x "
        "%d\n",
        p.side == Side::left ? "left" : "right", p.pose.y, p.pose.angle, p.normal_force, p.approach, p.area,
        p.max_pressure, p.error_estimate, p.grid.nx, p.grid.ny);
  }
  for (const std::string& fault : faults)
  {
    std::printf("   FAULT %s\n", fault.c_str());
  }
}

void Campaign::runScene(unsigned long seed, bool aloud)
{
  Random random(seed);
  const Scene scene = randomScene(pool_, random);
  WheelsetContact contact(scene.config);
  ResultCheck check(contact.config());
  Walk walk(contact.config(), random);
  for (int i = 0; i < states_of_a_scene; ++i)
  {
    const WheelsetState& state = walk.next();
    const double begin = processorTime();
    const WheelsetResult& result = contact.evaluate(state);
    const double seconds = processorTime() - begin;
    const std::vector<std::string>& faults = check.faults(state, result);
    const Tally::Entry entry{scene, seed, i, state, result, seconds, check.violation(), faults};
    tally_.add(entry);
    if (walk.isClose() && isSmooth(scene.config.contact.method))
    {
      compare(where(entry), result);
    }
    if (aloud)
    {
      print(i, state, result, faults);
      std::printf("   %.2f ms, violation %.3g\n", 1e3 * seconds, check.violation());
    }
    last_ = result;
  }
}

void Campaign::compare(const std::string& where, const WheelsetResult& result)
{
  const bool before = isUsable(last_.status), after = isUsable(result.status);
  if (!before || !after)
  {
    tally_.add(before || after ? Tally::Pair::one_refused : Tally::Pair::both_refused, where);
    return;
  }
  const Change change = changeBetween(last_, result, Walk::close);
  const bool torn = change.pressure > change.bounded_by;
  char text[100];
  std::snprintf(text, sizeof text, "pmax changes by %.3g, bound %.3g: ", change.pressure, change.bounded_by);
  tally_.add(change.jumped ? Tally::Pair::jumped : torn ? Tally::Pair::torn : Tally::Pair::continuous, text + where);
}

int run(const std::string& tables, const std::string& mode, const std::string& amount, unsigned long seed)
{
  Campaign campaign(tables);
  const bool one_scene = mode == "scene";
  if (one_scene)
  {
    campaign.runScene(std::stoul(amount), true);
  }
  else
  {
    std::printf("seed %lu\n", seed);
    const auto begin = std::chrono::steady_clock::now();
    const double most = std::stod(amount);
    const auto goes_on = [&]()
    {
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
      return mode == "minutes" ? spent.count() < 60 * most : static_cast<double>(campaign.tally().states()) < most;
    };
    Random seeds(seed);
    while (goes_on())
    {
      campaign.runScene(seeds(), false);
    }
  }
  campaign.tally().print();
  const bool good = one_scene ? !campaign.tally().hasFaults() : campaign.tally().isGood();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
}  // namespace

int main(int argc, char** argv)
{
  const std::string mode = argc > 2 ? argv[2] : "";
  if (argc < 4 || (mode != "states" && mode != "minutes" && mode != "scene"))
  {
    std::fprintf(stderr, "usage: stability_campaign TABLES states|minutes|scene NUMBER [SEED]\n");
    return 2;
  }
  try
  {
    return run(argv[1], mode, argv[3], argc > 4 ? std::stoul(argv[4]) : 1);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "stability_campaign: %s\n", error.what());
    return 1;
  }
}
