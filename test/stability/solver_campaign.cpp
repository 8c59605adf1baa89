// SPDX-License-Identifier: BSD-3-Clause
// Measures the search of the equilibrium of a wheelset: states without a result, and the work for a state.
//
//   solver_campaign random N [SEED]            N cold random states; prints each refused one as arguments of `state`
//   solver_campaign sweep [NAME=VALUE|WORD...] warm sweeps whose names have all words. Values: states=10001,
//                                              tolerance=0.01, begin=-0.008, end=0.008 (lateral displacement), runs=2
//   solver_campaign state WHEEL RAIL TABLE|rigid wheel_loads|moments TOLERANCE Y YAW Q_LEFT Q_RIGHT
//                   [WHEEL_RIGHT RAIL_RIGHT]   one state: cold, after 200 steps from y = 0, and from 1 mm beyond
//
// Units: m, rad, N. The wheel loads Q give force and torque as with `wheel_loads`, also with `moments`. States of a
// wheel that cannot touch its rail, even without a load, are not refused but beside the rail.
//
// The unit of work is one product with the influence matrix on a symmetric grid of 12 x 24 cells. All normal solutions
// of both wheels and all stiffnesses count. "effort" is the work with six more products for each solution, for all else
// that belongs to it; it is nearly proportional to the time. Time is processor time of the search without the results
// of the patches; in sweeps the smallest of all runs. Ratios are to the median of the sweep with rigid rails,
// wheel_loads and no yaw, for the same rail and load. "solver": share of the normal solutions in the time.
//
// Exit status: 1 if a state is refused, 2 for wrong arguments.
#include "../core/normal/gap_scenes.h"
#include "../manchester_scene.h"
#include "config/compliance_table_file.h"
#include "core/text/formatted.h"
#include "measured_balance.h"
#include "random_scene.h"

namespace
{
using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::stability;

/// A wheelset and its state in words: the arguments of `state`.
using Words = std::vector<std::string>;
constexpr std::size_t wheel = 0, rail = 1, table = 2, balance = 3, tolerance = 4, y = 5, yaw = 6, load_left = 7,
                      load_right = 8, wheel_right = 9, rail_right = 10, words_of_state = 11;

/// Standard profiles, and those of measured points.
std::vector<SceneProfile> profilesOf(ProfileKind kind)
{
  std::vector<SceneProfile> profiles = kind == ProfileKind::wheel ? wheelProfiles() : railProfiles();
  const auto is_other = [](const SceneProfile& profile) { return !(profile.noise.value_or(0) > 0); };
  profiles.erase(std::remove_if(profiles.begin(), profiles.end(), is_other), profiles.end());
  for (const std::string& name : standardProfileNames(kind))
  {
    profiles.push_back(loadSceneProfile(name, kind));
  }
  return profiles;
}

std::shared_ptr<const Profile> named(const std::string& name, const std::vector<SceneProfile>& profiles)
{
  const auto found =
      std::find_if(profiles.begin(), profiles.end(), [&](const SceneProfile& one) { return one.name == name; });
  return found != profiles.end() ? found->profile : throw std::invalid_argument("no profile '" + name + "'");
}

ContactModelConfig configOf(const Words& words, const ScenePool& pool)
{
  ContactModelConfig config;
  config.wheel_profile = {named(words[wheel], pool.wheels), named(words[wheel_right], pool.wheels)};
  config.rail_profile = {named(words[rail], pool.rails), named(words[rail_right], pool.rails)};
  config.contact.tolerance = std::stod(words[tolerance]);
  if (words[balance] == "moments")
  {
    config.wheelset.balance = WheelsetConfig::Balance::moments;
  }
  if (words[table] != "rigid")
  {
    bend(config, wheel_rail_contact::readComplianceTable(RAIL_TABLES "/" + words[table] + ".yaml").table);
  }
  return config;
}

WheelsetState stateOf(const Words& words)
{
  const double left = std::stod(words[load_left]), right = std::stod(words[load_right]);
  WheelsetState state;
  state.y = std::stod(words[y]);
  state.yaw = std::stod(words[yaw]);
  state.force_z = -(left + right);
  state.torque_x = (right - left) * WheelsetConfig{}.halfBase();
  return state;
}

std::string joined(const Words& words)
{
  std::string text;
  std::for_each(words.begin(), words.end(), [&](const std::string& word) { text += " " + word; });
  return text + " ";
}

/// A cold state. If it is refused, it is solved without loads, to see whether both wheels touch their rails.
Measurement solveCold(MeasuredBalance& measured, const Words& words)
{
  WheelsetState state = stateOf(words);
  measured.balance().reset();
  Measurement found = measured.solve(state);
  if (found.refused > 0)
  {
    const std::string reason(measured.balance().reason());
    measured.balance().reset();
    state.force_z = state.torque_x = 0;
    found.beside = measured.solve(state).refused;
    found.refused = 1 - found.beside;
    std::printf("%s (%s):%s\n", found.beside > 0 ? "beside" : "refused", reason.c_str(), joined(words).c_str());
    std::fflush(stdout);
  }
  return found;
}

double runRandom(const ScenePool& pool, std::size_t states, unsigned long seed)
{
  constexpr int states_per_setup = 50;
  std::printf("seed %lu\n", seed);
  scenes::Random random(seed);
  const auto profile = [&](const std::vector<SceneProfile>& from) { return from[random() % from.size()].name; };
  const auto number = [&](double least, double most)
  { return formatted("%.17g", scenes::uniform(random, least, most)); };
  std::map<std::string, Measurements> classes;
  Words worst;
  double most = 0;
  for (Measurements& all = classes["~ all"]; all.size() < states;)
  {
    Words words(words_of_state);
    words[wheel] = words[wheel_right] = profile(pool.wheels);
    words[rail] = words[rail_right] = profile(pool.rails);
    const bool unequal = scenes::oneIn(random, 4);
    if (unequal)
    {
      words[wheel_right] = profile(pool.wheels);
      words[rail_right] = profile(pool.rails);
    }
    words[table] = pool.tables[random() % pool.tables.size()].file;
    words[balance] = scenes::oneIn(random, 2) ? "moments" : "wheel_loads";
    words[tolerance] = scenes::oneIn(random, 2) ? "0.1" : "0.01";
    const char* kind = unequal                                                          ? " unequal"
                       : (words[wheel] + words[rail]).find(".csv") != std::string::npos ? " measured"
                                                                                        : " standard";
    Measurements& counted = classes[words[balance] + " " + words[table] + " " + words[tolerance] + kind];
    MeasuredBalance search(configOf(words, pool));
    for (int k = 0; k < states_per_setup; ++k)
    {
      words[y] = number(-9e-3, 9e-3);
      words[yaw] = scenes::oneIn(random, 2) ? "0" : number(-0.02, 0.02);
      words[load_left] = number(5e3, 1.5e5);
      words[load_right] = number(5e3, 1.5e5);
      counted.push_back(solveCold(search, words));
      all.push_back(counted.back());
      if (all.back().work > most)
      {
        most = all.back().work;
        worst = words;
      }
    }
  }
  std::printf("most work:%s\n", joined(worst).c_str());
  std::printf("%-36s %8s %7s %7s  %8s %8s %8s  %9s %7s\n", "", "states", "refused", "beside", "work", "99.9 %",
              "largest", "solutions", "largest");
  for (const auto& [name, all] : classes)
  {
    std::printf("%-36s %8zu %7.0f %7.0f  %8.1f %8.0f %8.0f  %9.0f %7.0f\n", name.c_str(), all.size(),
                all.sum(&Measurement::refused), all.sum(&Measurement::beside), all.quantile(&Measurement::work),
                all.quantile(&Measurement::work, 0.999), all.quantile(&Measurement::work, 1),
                all.quantile(&Measurement::solutions, 0.999), all.quantile(&Measurement::solutions, 1));
  }
  return classes["~ all"].sum(&Measurement::refused);
}

/// Solves a path of `steps` from the lateral displacement `from` [m] to a state. @return number of refused states
double runPath(const char* name, const ContactModelConfig& config, WheelsetState state, double from, int steps)
{
  MeasuredBalance measured(config);
  const double to = state.y;
  Measurements all;
  for (int k = steps; k >= 0; --k)
  {
    state.y = k == 0 ? to : to + (from - to) * k / steps;
    all.push_back(measured.solve(state));
  }
  WheelsetBalance& balance = measured.balance();
  const RailResult left = balance.wheel(Side::left).rail(), right = balance.wheel(Side::right).rail();
  const Measurement& last = all.back();
  std::printf("%-7s %3.0f solutions, work %.1f, %.3f ms, ", name, last.solutions, last.work, 1e3 * last.seconds);
  std::printf("y %.9g m, Q %.8g, %.8g N, Y %.8g, %.8g N, z %.9g m, roll %.9g rad; %s; %.0f of %d refused\n", to,
              left.vertical_force, right.vertical_force, left.lateral_force, right.lateral_force, balance.height(),
              balance.roll(), last.refused > 0 ? std::string(balance.reason()).c_str() : "ok",
              all.sum(&Measurement::refused), steps + 1);
  return all.sum(&Measurement::refused);
}

double runState(const ScenePool& pool, Words words)
{
  if (words.size() == wheel_right)
  {
    words.insert(words.end(), {words[wheel], words[rail]});
  }
  const ContactModelConfig config = configOf(words, pool);
  const WheelsetState state = stateOf(words);
  const double beyond = state.y + std::copysign(1e-3, state.y);
  double refused = runPath("cold", config, state, 0, 0);
  refused += runPath("outward", config, state, 0, 200);
  return refused + runPath("inward", config, state, beyond, 200);
}

using Values = std::map<std::string, double>;

Measurements sweep(const ContactModelConfig& config, WheelsetState state, const Values& values)
{
  const double begin = values.at("begin"), range = values.at("end") - begin;
  Measurements best;
  best.resize(static_cast<std::size_t>(values.at("states")));
  for (int run = 0; run < values.at("runs"); ++run)
  {
    MeasuredBalance measured(config);
    state.y = begin;
    measured.solve(state);  // cold, not counted
    for (std::size_t k = 0; k < best.size(); ++k)
    {
      state.y = begin + range * static_cast<double>(k) / static_cast<double>(best.size() - 1);
      const Measurement found = measured.solve(state);
      best[k] = run == 0 || found.seconds < best[k].seconds ? found : best[k];
    }
  }
  return best;
}

void printSweep(const std::string& name, const Measurements& all, const Measurements& reference)
{
  const auto worst = std::max_element(all.begin(), all.end(),
                                      [](const Measurement& a, const Measurement& b) { return a.work < b.work; });
  const auto print = [&](Measurements::Number number, double unit)
  {
    for (const double share : {0.5, 0.99, 0.999, 1.0})
    {
      std::printf(" %8.4g", unit * all.quantile(number, share));
    }
    std::printf(" %6.1f ", all.quantile(number, 1) / reference.quantile(number));
  };
  std::printf("%-52s", name.c_str());
  print(&Measurement::work, 1);
  std::printf("%7.4f %4.0f ", 1e3 * worst->y, worst->solutions);
  print(&Measurement::effort, 1);
  print(&Measurement::seconds, 1e3);
  std::printf("%4.0f %% %6.2f %% %5.0f\n", 100 * all.sum(&Measurement::in_solver) / all.sum(&Measurement::seconds),
              100 * all.sum(&Measurement::above) / static_cast<double>(all.size()), all.sum(&Measurement::refused));
  std::fflush(stdout);
}

double runSweeps(const ScenePool& pool, const Words& arguments)
{
  Values values{{"states", 10001}, {"tolerance", 0.01}, {"begin", -8e-3}, {"end", 8e-3}, {"runs", 2}};
  Words chosen;
  for (const std::string& argument : arguments)
  {
    const std::size_t equals = argument.find('=');
    const auto value = values.find(argument.substr(0, equals));
    if (value != values.end())
    {
      value->second = std::stod(argument.substr(equals + 1));
    }
    else
    {
      chosen.push_back(" " + argument + " ");
    }
  }
  std::puts(
      "                                                         work     99 %   99.9 %  largest  ratio  y ["
      "mm] sol.   effort     99 %   99.9 %  largest  ratio        ms     99 %   99.9 %  largest  ratio  sol"
      "ver   above refused");
  std::map<std::string, Measurements> references;  // by rail and load
  double refused = 0;
  const std::size_t count = 16 * pool.tables.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    Words words(words_of_state);
    words[wheel] = words[wheel_right] = "S1002";
    words[rail] = words[rail_right] = k < count / 2 ? "60E1" : "UIC60_manchester";
    words[load_left] = words[load_right] = k % 2 == 0 ? "20e3" : "100e3";
    words[balance] = k / 2 % 2 == 0 ? "wheel_loads" : "moments";
    words[yaw] = k / 4 % 2 == 0 ? "0" : "0.01";
    words[table] = pool.tables[k / 8 % pool.tables.size()].file;
    words[y] = "0";
    words[tolerance] = std::to_string(values.at("tolerance"));
    const std::string name = joined({words[rail], words[table], words[balance], "yaw=" + words[yaw], words[load_left]});
    const bool is_chosen = std::all_of(chosen.begin(), chosen.end(),
                                       [&](const std::string& word) { return name.find(word) != std::string::npos; });
    Measurements& reference = references[words[rail] + words[load_left]];
    if (!is_chosen && !reference.empty())
    {
      continue;
    }
    const Measurements all = sweep(configOf(words, pool), stateOf(words), values);
    reference = reference.empty() ? all : reference;
    if (is_chosen)
    {
      printSweep(name, all, reference);
      refused += all.sum(&Measurement::refused);
    }
  }
  return refused;
}

/// Number of refused states.
double run(const Words& arguments)
{
  const std::string mode = arguments.empty() ? "" : arguments[0];
  ScenePool pool{profilesOf(ProfileKind::wheel), profilesOf(ProfileKind::rail), readScenePool().tables};
  pool.tables.insert(pool.tables.begin(), {"", "rigid", {}});
  const Words others(arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
  if (mode == "random" && (others.size() == 1 || others.size() == 2))
  {
    return runRandom(pool, std::stoul(others[0]), others.size() == 2 ? std::stoul(others[1]) : 1);
  }
  if (mode == "state" && (others.size() == wheel_right || others.size() == words_of_state))
  {
    return runState(pool, others);
  }
  if (mode == "sweep")
  {
    return runSweeps(pool, others);
  }
  throw std::invalid_argument("usage: random N [SEED] | sweep [NAME=VALUE|WORD...] | state WHEEL RAIL TABLE|rigid ...");
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    return run({argv + 1, argv + argc}) > 0 ? 1 : 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "solver_campaign: %s\n", error.what());
    return 2;
  }
}
