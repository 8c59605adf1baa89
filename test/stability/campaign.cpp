// SPDX-License-Identifier: BSD-3-Clause
// Evaluates wheelsets in many states, and checks that each result is valid or refused with a reason.
//
//   stability_campaign states N [SEED]      random scenes with N states in total
//   stability_campaign minutes M [SEED]     random scenes for M minutes
//   stability_campaign write SCENE FILE     writes the random scene with the number SCENE to a scene file
//   stability_campaign run FILE             evaluates a scene file, and prints each state
//
// A random scene has random profiles, track, method, tolerance, grid and rails, and thirty states (random_scene.h). The
// default SEED is 1. Each result is checked independently of the solver (result_check.h). Where y changes by only 1 um
// from one state to the next, both results are compared. The program prints the refusals by reason and
// region, the slowest state, and all faults with the number of the scene. It exits with 1 if there is a fault, or if
// too many results of random scenes are inaccurate (tally.cpp), and with 2 for wrong arguments or files.
//
// To add a scene as a regression test, write it to test/stability/scenes/NAME.yaml and describe the fault in the file.
// CONTRIBUTING.md gives the commands of long campaigns.
#include <cctype>
#include <chrono>

#include "../core/balance/wheelset_scene.h"
#include "../thread_time.h"
#include "random_scene.h"
#include "result_check.h"
#include "scene_file.h"
#include "tally.h"

namespace
{
using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::stability;
using wheel_rail_contact::threadTime;

/// hertz depends on the curvatures at one point and jumps where they jump.
bool isContinuous(NormalMethod method)
{
  return method != NormalMethod::hertz;
}

/// Difference between the results of two neighbouring states.
struct Change
{
  bool jumped = false;  ///< the number of patches of a wheel differs, or one of its patches moved by more than `far`
  double pressure = 0;  ///< relative change of the highest pressure of a wheel [-], for the wheel nearest to its bound
  double bound = 0;     ///< largest change of that wheel that is explained without a jump [-]
};

/// Displacement of a patch beyond which it is another place of contact [m].
constexpr double far = 2.5e-4;

/// Bound of the relative change of the highest pressure of a wheel [-], without a jump, between two states that are
/// `distance` [m] apart in y: the sum of
///  - both error estimates,
///  - 3 * distance / approach, for the change of the approach. The relative displacement of the bodies along the normal
///    is at most three times the lateral displacement (flange at 70 degrees that lifts the tread). The pressure is
///    proportional to the root of the approach (Hertz), which gives half of 3 * distance / approach. A rail that is
///    deflected by its compliance table adds the same amount.
double boundOf(const PatchResult& before, const PatchResult& after, double distance)
{
  return before.error_estimate + after.error_estimate + 3 * distance / std::min(before.approach, after.approach);
}

/// @param distance  difference of the two states in y [m]
Change changeBetween(const WheelsetResult& before, const WheelsetResult& after, double distance)
{
  Change change;
  for (const Side side : {Side::left, Side::right})
  {
    const auto first = patchesOf(before, side), second = patchesOf(after, side);
    change.jumped = change.jumped || first.size() != second.size();
    for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k)
    {
      const double moved = std::hypot(first[k]->pose.y - second[k]->pose.y, first[k]->pose.z - second[k]->pose.z);
      change.jumped = change.jumped || moved > far;
    }
    if (first.empty() || second.empty())
    {
      continue;
    }
    const PatchResult &p = highestOf(first), &q = highestOf(second);
    const double pressure = std::abs(q.max_pressure / p.max_pressure - 1), bound = boundOf(p, q, distance);
    if (pressure * change.bound >= change.pressure * bound)
    {
      change.pressure = pressure;
      change.bound = bound;
    }
  }
  return change;
}

class Campaign
{
 public:
  /// @param print  print each state and result
  void evaluate(const Scene& scene, const std::string& name, bool print);
  const Tally& tally() const { return tally_; }

 private:
  void compare(const std::string& where, const WheelsetResult& before, const WheelsetResult& after);

  Tally tally_;
};

void printResult(int index, const WheelsetState& state, const WheelsetResult& result,
                 const std::vector<std::string>& faults)
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

void Campaign::evaluate(const Scene& scene, const std::string& name, bool print)
{
  WheelsetContact contact(scene.config);
  ResultCheck check(contact.config());
  WheelsetResult last;
  for (std::size_t k = 0; k < scene.states.size(); ++k)
  {
    const int index = static_cast<int>(k);
    const WheelsetState& state = scene.states[k];
    const double begin = threadTime();
    const WheelsetResult& result = contact.evaluate(state);
    const double seconds = threadTime() - begin;
    const std::vector<std::string>& faults = check.faults(state, result);
    const Tally::Entry entry{scene, name, index, state, result, seconds, check.violation(), faults};
    tally_.add(entry);
    if (k > 0 && areNeighbours(scene.states[k - 1], state) && isContinuous(scene.config.contact.method))
    {
      compare(where(entry), last, result);
    }
    if (print)
    {
      printResult(index, state, result, faults);
      std::printf("   %.2f ms, violation %.3g\n", 1e3 * seconds, check.violation());
    }
    last = result;
  }
}

void Campaign::compare(const std::string& where, const WheelsetResult& before, const WheelsetResult& after)
{
  const bool usable_before = isUsable(before.status), usable_after = isUsable(after.status);
  if (!usable_before || !usable_after)
  {
    tally_.add(usable_before || usable_after ? Tally::Pair::one_refused : Tally::Pair::both_refused, where);
    return;
  }
  const Change change = changeBetween(before, after, small_step);
  char text[100];
  std::snprintf(text, sizeof text, "pmax changes by %.3g, bound %.3g: ", change.pressure, change.bound);
  tally_.add(change.jumped                    ? Tally::Pair::jumped
             : change.pressure > change.bound ? Tally::Pair::discontinuous
                                              : Tally::Pair::continuous,
             text + where);
}

int finish(const Tally& tally, bool good)
{
  tally.print();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

int runRandomScenes(bool by_time, double amount, unsigned long seed)
{
  std::printf("seed %lu\n", seed);
  Campaign campaign;
  const ScenePool pool = readScenePool();
  const auto begin = std::chrono::steady_clock::now();
  const auto is_over = [&]()
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    return by_time ? elapsed.count() >= 60 * amount : static_cast<double>(campaign.tally().states()) >= amount;
  };
  std::mt19937_64 numbers(seed);
  while (!is_over())
  {
    const unsigned long number = numbers();
    campaign.evaluate(randomScene(pool, number), "scene " + std::to_string(number), false);
  }
  return finish(campaign.tally(), campaign.tally().isGood());
}

int runFile(const std::string& file)
{
  Campaign campaign;
  campaign.evaluate(readScene(file), file, true);
  return finish(campaign.tally(), !campaign.tally().hasFaults());
}

int writeRandomScene(unsigned long number, const std::string& file)
{
  std::ofstream out(file);
  writeScene(out, randomScene(readScenePool(), number));
  out.close();
  if (!out)
  {
    throw std::runtime_error(file + ": cannot be written");
  }
  return EXIT_SUCCESS;
}

/// @throw std::invalid_argument if the text is not a number > 0.
double toAmount(const std::string& text)
{
  std::size_t end = 0;
  const double amount = std::isdigit(static_cast<unsigned char>(text[0])) != 0 ? std::stod(text, &end) : 0;
  if (end != text.size() || !(amount > 0))
  {
    throw std::invalid_argument("'" + text + "' is not a number > 0");
  }
  return amount;
}

/// @throw std::invalid_argument if the text is not the number of a scene or a seed.
unsigned long toNumber(const std::string& text)
{
  if (text.empty() || text.size() > 20 || text.find_first_not_of("0123456789") != std::string::npos)
  {
    throw std::invalid_argument("'" + text + "' is not a whole number of at most 20 digits");
  }
  return std::stoul(text);
}

int run(const std::vector<std::string>& arguments)
{
  const std::string mode = arguments.empty() ? "" : arguments[0];
  const std::size_t count = arguments.size();
  if ((mode == "states" || mode == "minutes") && (count == 2 || count == 3))
  {
    return runRandomScenes(mode == "minutes", toAmount(arguments[1]), count == 3 ? toNumber(arguments[2]) : 1);
  }
  if (mode == "write" && count == 3)
  {
    return writeRandomScene(toNumber(arguments[1]), arguments[2]);
  }
  if (mode == "run" && count == 2)
  {
    return runFile(arguments[1]);
  }
  std::fprintf(stderr,
               "usage: stability_campaign states N [SEED]   random scenes with N states in total\n"
               "       stability_campaign minutes M [SEED]  random scenes for M minutes\n"
               "       stability_campaign write SCENE FILE  write the random scene with the number SCENE to a file\n"
               "       stability_campaign run FILE          evaluate a scene file, and print each state\n");
  return 2;
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    return run({argv + 1, argv + argc});
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "stability_campaign: %s\n", error.what());
    return 2;
  }
}
