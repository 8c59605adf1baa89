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
// wheel_loads and no yaw, for the same rail and load. "solver": share of solutions and error estimates in the time.
//
// Exit status: 1 if a state is refused, 2 for wrong arguments.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>

#include "../core/normal/gap_scenes.h"
#include "../thread_time.h"
#include "config/compliance_table_file.h"
#include "core/balance/wheelset_balance.h"
#include "core/text/formatted.h"
#include "random_scene.h"

namespace
{
using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::stability;
using wheel_rail_contact::threadTime;

/// A wheelset and its state in words: the arguments of `state`.
using Words = std::vector<std::string>;
constexpr std::size_t wheel = 0, rail = 1, table = 2, balance = 3, tolerance = 4, y = 5, yaw = 6, load_left = 7,
                      load_right = 8, wheel_right = 9, rail_right = 10, words_of_state = 11;

/// Cells of a grid, and time of a product on it over that on 12 x 24 cells, both symmetric. Measured on 8 x 16, 12 x
/// 24, 16 x 32, 16 x 48, 24 x 64, 32 x 96, 48 x 128 and 64 x 192 cells, smallest of 40 runs. Without symmetry it is
/// twice as much, within 8 %.
constexpr std::array<std::array<double, 2>, 8> product_costs{
    {{128, 0.42}, {288, 1}, {512, 1.54}, {768, 2.66}, {1536, 6.6}, {3072, 17.5}, {6144, 36}, {12288, 91}}};

/// The rest of a solution - placing the wheel, grids, gap, pressure and area - takes as long as about this number of
/// its products: 8 on 12 x 24 cells, 4 to 7 on 24 x 64, by least squares over the times of 20 000 states.
constexpr double products_per_solution = 6;

/// Work of one product on all patches of a problem. Normals that are turned take two.
double workOfProduct(const CurvedProblem& problem)
{
  double work = 0;
  for (const PatchGap& patch : problem.patches)
  {
    const double cells = static_cast<double>(patch.grid.nx) * patch.grid.ny;
    const auto size = std::find_if(product_costs.begin(), product_costs.end() - 1,
                                   [&](const std::array<double, 2>& cost) { return cells <= cost[0]; });
    work += (patch.grid.symmetric ? 1 : 2) * (*size)[1] * cells / (*size)[0];
  }
  const bool turned = std::any_of(problem.normals.begin(), problem.normals.end(),
                                  [](const ColumnNormals& normals) { return normals.areTurned(); });
  return (turned ? 2 : 1) * work;
}

/// Numbers of one search.
struct Measurement
{
  double y = 0;                                ///< [m]
  double refused = 0, beside = 0, above = 0;   ///< 1 if it is so; `above`: error estimate above the tolerance
  double solutions = 0, work = 0, effort = 0;  ///< of both wheels
  double seconds = 0, in_solver = 0;           ///< time [s]
};

/// Measurements of several states.
struct Measurements : std::vector<Measurement>
{
  using Number = double Measurement::*;

  double sum(Number number) const
  {
    double sum = 0;
    std::for_each(begin(), end(), [&](const Measurement& one) { sum += one.*number; });
    return sum;
  }
  double quantile(Number number, double share = 0.5) const
  {
    std::vector<double> numbers;
    std::transform(begin(), end(), std::back_inserter(numbers), [&](const Measurement& one) { return one.*number; });
    std::sort(numbers.begin(), numbers.end());
    return numbers[static_cast<std::size_t>(share * static_cast<double>(size() - 1))];
  }
};

/// A balance whose work is measured.
class MeasuredBalance
{
 public:
  explicit MeasuredBalance(const ContactModelConfig& config);

  Measurement solve(const WheelsetState& state);
  WheelsetBalance& balance() { return balance_; }

 private:
  /// The solver, with a count of its solutions.
  struct Counter : ConjugateGradients
  {
    Counter(NormalSolver& solver, MeasuredBalance& balance)
        : ConjugateGradients(std::move(dynamic_cast<ConjugateGradients&>(solver))), owner(balance)
    {
    }
    void solveCurved(const CurvedProblem& problem, bool warm, NormalSolution& solution) override;
    void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                        std::vector<ErrorEstimate>& errors) const override;
    MeasuredBalance& owner;
  };
  void addStiffness();

  ContactModelConfig config_;
  GridLevels levels_;
  WheelsetBalance balance_;
  Measurement now_;
  Sides<int> products_{};            ///< for stiffnesses, that are counted
  Sides<double> work_of_product_{};  ///< in the last problem of a wheel
};

MeasuredBalance::MeasuredBalance(const ContactModelConfig& config)
    : config_(config),
      levels_(config_,
              [this](std::unique_ptr<NormalSolver> solver) { return std::make_unique<Counter>(*solver, *this); }),
      balance_(config_, levels_)
{
}

void MeasuredBalance::Counter::solveCurved(const CurvedProblem& problem, bool warm, NormalSolution& solution)
{
  owner.addStiffness();
  const double begin = threadTime();
  ConjugateGradients::solveCurved(problem, warm, solution);
  owner.now_.in_solver += threadTime() - begin;
  const bool is_left = &problem == &owner.balance_.wheel(Side::left).contact().problem();
  const double work = owner.work_of_product_[is_left ? Side::left : Side::right] = workOfProduct(problem);
  owner.now_.work += solution.iterations * work;
  owner.now_.effort += products_per_solution * work;
  owner.now_.solutions += 1;
}

void MeasuredBalance::Counter::estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                                              std::vector<ErrorEstimate>& errors) const
{
  const double begin = threadTime();
  ConjugateGradients::estimateErrors(problem, solution, errors);
  owner.now_.in_solver += threadTime() - begin;
}

/// Adds the stiffnesses since the last call, which are those of the last problem of each wheel.
void MeasuredBalance::addStiffness()
{
  for (const Side side : sides)
  {
    const int products = balance_.wheel(side).contact().stiffnessProducts();
    now_.work += (products - products_[side]) * work_of_product_[side];
    products_[side] = products;
  }
}

Measurement MeasuredBalance::solve(const WheelsetState& state)
{
  now_ = {state.y};
  const double begin = threadTime();
  const bool usable = isUsable(balance_.solve(state));
  now_.seconds = threadTime() - begin;
  addStiffness();
  now_.effort += now_.work;
  const double error = std::max(balance_.wheelError(Side::left), balance_.wheelError(Side::right));
  now_.refused = usable ? 0 : 1;
  now_.above = usable && error > config_.contact.tolerance ? 1 : 0;
  return now_;
}

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

/// Profiles and names of tables.
struct Pool
{
  std::vector<SceneProfile> wheels = profilesOf(ProfileKind::wheel), rails = profilesOf(ProfileKind::rail);
  Words tables{"rigid"};

  Pool()
  {
    for (const NamedTable& table : readScenePool().tables)
    {
      tables.push_back(table.file);
    }
  }
};

std::shared_ptr<const Profile> named(const std::string& name, const std::vector<SceneProfile>& profiles)
{
  const auto found =
      std::find_if(profiles.begin(), profiles.end(), [&](const SceneProfile& one) { return one.name == name; });
  return found != profiles.end() ? found->profile : throw std::invalid_argument("no profile '" + name + "'");
}

ContactModelConfig configOf(const Words& words, const Pool& pool)
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
    config.rail_bending.model = RailBendingConfig::Model::compliance;
    config.rail_bending.table = wheel_rail_contact::readComplianceTable(RAIL_TABLES "/" + words[table] + ".yaml").table;
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

int runRandom(const Pool& pool, std::size_t states, unsigned long seed)
{
  constexpr int states_per_setup = 50;
  std::printf("seed %lu\n", seed);
  scenes::Random random(seed);
  const auto profile = [&](const std::vector<SceneProfile>& from) { return from[random() % from.size()].name; };
  const auto number = [&](double least, double most)
  { return formatted("%.17g", scenes::uniform(random, least, most)); };
  std::map<std::string, Measurements> classes;
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
    words[table] = pool.tables[random() % pool.tables.size()];
    words[balance] = scenes::oneIn(random, 2) ? "moments" : "wheel_loads";
    words[tolerance] = scenes::oneIn(random, 2) ? "0.1" : "0.01";
    const bool measured = (words[wheel] + words[rail]).find(".csv") != std::string::npos;
    Measurements& counted = classes[words[balance] + " " + words[table] + " " + words[tolerance] +
                                    (unequal    ? " unequal"
                                     : measured ? " measured"
                                                : " standard")];
    MeasuredBalance search(configOf(words, pool));
    for (int k = 0; k < states_per_setup; ++k)
    {
      words[y] = number(-9e-3, 9e-3);
      words[yaw] = scenes::oneIn(random, 2) ? "0" : number(-0.02, 0.02);
      words[load_left] = number(5e3, 1.5e5);
      words[load_right] = number(5e3, 1.5e5);
      counted.push_back(solveCold(search, words));
      all.push_back(counted.back());
    }
  }
  std::printf("%-36s %8s %7s %7s  %8s %8s %8s  %9s %7s\n", "", "states", "refused", "beside", "work", "99.9 %",
              "largest", "solutions", "largest");
  for (const auto& [name, all] : classes)
  {
    std::printf("%-36s %8zu %7.0f %7.0f  %8.1f %8.0f %8.0f  %9.0f %7.0f\n", name.c_str(), all.size(),
                all.sum(&Measurement::refused), all.sum(&Measurement::beside), all.quantile(&Measurement::work),
                all.quantile(&Measurement::work, 0.999), all.quantile(&Measurement::work, 1),
                all.quantile(&Measurement::solutions, 0.999), all.quantile(&Measurement::solutions, 1));
  }
  return classes["~ all"].sum(&Measurement::refused) > 0 ? 1 : 0;
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
  std::printf("%-7s %3.0f solutions, work %.1f, %.3f ms, ", name, all.back().solutions, all.back().work,
              1e3 * all.back().seconds);
  std::printf("y %.9g m, Q %.8g, %.8g N, Y %.8g, %.8g N, z %.9g m, roll %.9g rad; %s; %.0f of %d refused\n", to,
              left.vertical_force, right.vertical_force, left.lateral_force, right.lateral_force, balance.height(),
              balance.roll(), all.back().refused > 0 ? std::string(balance.reason()).c_str() : "ok",
              all.sum(&Measurement::refused), steps + 1);
  return all.sum(&Measurement::refused);
}

int runState(const Pool& pool, Words words)
{
  if (words.size() == wheel_right)
  {
    words.insert(words.end(), {words[wheel], words[rail]});
  }
  const ContactModelConfig config = configOf(words, pool);
  const WheelsetState state = stateOf(words);
  const double beyond = state.y + std::copysign(1e-3, state.y);
  return runPath("cold", config, state, 0, 0) + runPath("outward", config, state, 0, 200) +
                     runPath("inward", config, state, beyond, 200) >
                 0
             ? 1
             : 0;
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

int runSweeps(const Pool& pool, const Words& arguments)
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
  std::printf("%-52s", "");
  for (const char* number : {"work", "effort", "ms"})
  {
    std::printf("%9s %8s %8s %8s %6s %s", number, "99 %", "99.9 %", "largest", "ratio",
                number[0] == 'w' ? " y [mm] sol." : "");
  }
  std::printf(" solver   above refused\n");
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
    words[table] = pool.tables[k / 8 % pool.tables.size()];
    words[y] = "0";
    words[tolerance] = std::to_string(values.at("tolerance"));
    const std::string name = joined({words[rail], words[table], words[balance], "yaw=" + words[yaw], words[load_left]});
    const bool is_chosen = std::all_of(chosen.begin(), chosen.end(),
                                       [&](const std::string& word) { return name.find(word) != std::string::npos; });
    Measurements& reference = references[words[rail] + words[load_left]];
    if (is_chosen || reference.empty())
    {
      const Measurements all = sweep(configOf(words, pool), stateOf(words), values);
      reference = reference.empty() ? all : reference;
      if (is_chosen)
      {
        printSweep(name, all, reference);
        refused += all.sum(&Measurement::refused);
      }
    }
  }
  return refused > 0 ? 1 : 0;
}

int run(const Words& arguments)
{
  const std::string mode = arguments.empty() ? "" : arguments[0];
  const Words others(arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
  if (mode == "random" && (others.size() == 1 || others.size() == 2))
  {
    return runRandom(Pool(), std::stoul(others[0]), others.size() == 2 ? std::stoul(others[1]) : 1);
  }
  if (mode == "state" && (others.size() == wheel_right || others.size() == words_of_state))
  {
    return runState(Pool(), others);
  }
  if (mode == "sweep")
  {
    return runSweeps(Pool(), others);
  }
  throw std::invalid_argument("usage: random N [SEED] | sweep [NAME=VALUE|WORD...] | state WHEEL RAIL TABLE|rigid ...");
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
    std::fprintf(stderr, "solver_campaign: %s\n", error.what());
    return 2;
  }
}
