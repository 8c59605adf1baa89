// SPDX-License-Identifier: BSD-3-Clause
// Measures the search of the equilibrium of a wheelset: states without a result, and the work for a state.
//
//   solver_campaign random N [SEED]         N cold random states; prints each refused one as arguments of `state`
//   solver_campaign state WHEEL RAIL TABLE|rigid wheel_loads|moments TOLERANCE Y YAW Q_LEFT Q_RIGHT
//                         [WHEEL_RIGHT RAIL_RIGHT]   one state: cold, along a path from y = 0, and from 1 mm beyond
//   solver_campaign sweep [STATES] [WORD...]  warm sweeps over y = -8 to 8 mm, of those whose name has all words
//
// Units: m, rad, N. A wheel load Q counts as with Balance::wheel_loads: also with `moments`, the torque is that by
// which both loads differ at the running circles. The unit of work is one product with the influence matrix on a
// symmetric grid of 12 x 24 cells. It contains all normal solutions of both wheels and all stiffnesses. Time is
// processor time of the search, without the fields of the patches; in sweeps the smaller of two runs.
//
// Exit status: 1 if a state is refused, 2 for wrong arguments.
#include <ctime>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>

#include "../core/normal/gap_scenes.h"
#include "core/balance/wheelset_balance.h"
#include "random_scene.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace
{
using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::stability;
using Words = std::vector<std::string>;

/// Time of a product on a symmetric grid over that on 12 x 24 cells, by the number of cells of the whole grid. Measured
/// at 8 x 16, 12 x 24, 16 x 32, 16 x 48, 24 x 64, 32 x 96, 48 x 128 and 64 x 192 cells, smallest of 40 runs. On a grid
/// without symmetry it is twice as much, within 8 %.
constexpr std::array<std::array<double, 2>, 8> product_costs{
    {{128, 0.42}, {288, 1}, {512, 1.54}, {768, 2.66}, {1536, 6.6}, {3072, 17.5}, {6144, 36}, {12288, 91}}};

/// Work of one product on all patches of a problem. Between the sizes of the table it is a power of the cells. Normals
/// that are turned take two products.
double workOfProduct(const CurvedProblem& problem)
{
  double work = 0;
  for (const PatchGap& patch : problem.patches)
  {
    const double cells = static_cast<double>(patch.grid.nx) * patch.grid.ny;
    std::size_t k = 1;
    while (k + 1 < product_costs.size() && cells > product_costs[k][0])
    {
      ++k;
    }
    const auto [cells_before, cost_before] = product_costs[k - 1];
    const auto [cells_after, cost_after] = product_costs[k];
    const double power = std::log(cost_after / cost_before) / std::log(cells_after / cells_before);
    work += (patch.grid.symmetric ? 1 : 2) * cost_before * std::pow(cells / cells_before, power);
  }
  const bool turned = std::any_of(problem.normals.begin(), problem.normals.end(),
                                  [](const ColumnNormals& normals) { return normals.areTurned(); });
  return (turned ? 2 : 1) * work;
}

double processorTime()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A state in terms of its wheel loads.
struct LoadedState
{
  double y = 0, yaw = 0;       ///< [m], [rad]
  Sides<double> wheel_load{};  ///< [N]
};

/// Profiles, rails and method of a wheelset.
struct Setup
{
  Sides<SceneProfile> wheel, rail;
  std::string table = "rigid";  ///< file in config/rails
  bool moments = false;
  double tolerance = 0.01;

  const char* balance() const { return moments ? "moments" : "wheel_loads"; }
  bool isUnequal() const { return wheel.left.name != wheel.right.name || rail.left.name != rail.right.name; }
  bool isMeasured() const { return wheel.left.noise || wheel.right.noise || rail.left.noise || rail.right.noise; }
  ContactModelConfig config(const ScenePool& pool) const;
  std::string arguments(const LoadedState& state) const;
};

ContactModelConfig Setup::config(const ScenePool& pool) const
{
  ContactModelConfig config;
  for (const Side side : sides)
  {
    config.wheel_profile[side] = wheel[side].profile;
    config.rail_profile[side] = rail[side].profile;
  }
  config.contact.tolerance = tolerance;
  config.wheelset.balance = moments ? WheelsetConfig::Balance::moments : WheelsetConfig::Balance::wheel_loads;
  if (table != "rigid")
  {
    const auto found = std::find_if(pool.tables.begin(), pool.tables.end(),
                                    [&](const NamedTable& named) { return named.file == table; });
    if (found == pool.tables.end())
    {
      throw std::invalid_argument("no table '" + table + "' in config/rails");
    }
    config.rail_bending.model = RailBendingConfig::Model::compliance;
    config.rail_bending.table = found->table;
  }
  return config;
}

/// Arguments of the mode `state`.
std::string Setup::arguments(const LoadedState& state) const
{
  char numbers[120];
  std::snprintf(numbers, sizeof numbers, " %g %.17g %.17g %.17g %.17g", tolerance, state.y, state.yaw,
                state.wheel_load.left, state.wheel_load.right);
  return wheel.left.name + " " + rail.left.name + " " + table + " " + balance() + numbers +
         (isUnequal() ? " " + wheel.right.name + " " + rail.right.name : "");
}

/// Result of the search for one state.
struct Measurement
{
  ContactStatus status = ContactStatus::invalid_input;
  bool above_tolerance = false;
  int solutions = 0;  ///< of both wheels
  double work = 0, milliseconds = 0;
};

/// A balance whose work is measured.
class MeasuredBalance
{
 public:
  MeasuredBalance(const Setup& setup, const ScenePool& pool);

  Measurement solve(const LoadedState& state);
  void reset() { balance_.reset(); }
  /// True if both wheels touch their rails when they are put on them without a load. Resets the balance.
  bool isOverRails(const LoadedState& state);
  const WheelsetBalance& balance() const { return balance_; }

 private:
  class Counter;
  void addStiffness();
  void add(const CurvedProblem& problem, const NormalSolution& solution);

  ContactModelConfig config_;
  GridLevels levels_;
  WheelsetBalance balance_;
  Measurement now_;
  Sides<int> products_{};            ///< for stiffnesses, that are counted
  Sides<double> work_of_product_{};  ///< in the last problem of a wheel
};

/// Wrapper of the solver that counts its solutions.
class MeasuredBalance::Counter : public NormalSolver
{
 public:
  Counter(std::unique_ptr<NormalSolver> solver, MeasuredBalance& balance)
      : solver_(std::move(solver)), balance_(balance)
  {
  }

  const char* name() const override { return solver_->name(); }
  std::string_view leftOut(const CurvedProblem& problem) const override { return solver_->leftOut(problem); }
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override
  {
    solver_->solve(problem, warm, solution);
  }
  void solveCurved(const CurvedProblem& problem, bool warm, NormalSolution& solution) override
  {
    balance_.addStiffness();
    solver_->solveCurved(problem, warm, solution);
    balance_.add(problem, solution);
  }
  void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                      std::vector<ErrorEstimate>& errors) const override
  {
    solver_->estimateErrors(problem, solution, errors);
  }

 private:
  std::unique_ptr<NormalSolver> solver_;
  MeasuredBalance& balance_;
};

MeasuredBalance::MeasuredBalance(const Setup& setup, const ScenePool& pool)
    : config_(setup.config(pool)),
      levels_(config_, [this](std::unique_ptr<NormalSolver> solver)
              { return std::make_unique<Counter>(std::move(solver), *this); }),
      balance_(config_, levels_)
{
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

void MeasuredBalance::add(const CurvedProblem& problem, const NormalSolution& solution)
{
  const Side side = &problem == &balance_.wheel(Side::left).contact().problem() ? Side::left : Side::right;
  work_of_product_[side] = workOfProduct(problem);
  now_.work += solution.iterations * work_of_product_[side];
  ++now_.solutions;
}

Measurement MeasuredBalance::solve(const LoadedState& state)
{
  const Sides<double>& load = state.wheel_load;
  WheelsetState loaded;
  loaded.y = state.y;
  loaded.yaw = state.yaw;
  loaded.force_z = -(load.left + load.right);
  loaded.torque_x = (load.right - load.left) * config_.wheelset.halfBase();
  now_ = {};
  const double begin = processorTime();
  now_.status = balance_.solve(loaded);
  now_.milliseconds = 1e3 * (processorTime() - begin);
  addStiffness();
  now_.above_tolerance =
      isUsable(now_.status) &&
      std::max(balance_.wheelError(Side::left), balance_.wheelError(Side::right)) > config_.contact.tolerance;
  return now_;
}

bool MeasuredBalance::isOverRails(const LoadedState& state)
{
  reset();
  const ContactStatus status = solve({state.y, state.yaw, {}}).status;
  reset();
  return status != ContactStatus::off_profile;
}

/// The value that this share of the numbers does not exceed.
double quantile(std::vector<double>& numbers, double share)
{
  std::sort(numbers.begin(), numbers.end());
  return numbers.empty() ? 0 : numbers[static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1))];
}

/// States of one class of random states.
struct ClassCount
{
  long states = 0, refused = 0, beside = 0;
  std::vector<double> work, solutions;

  void print(const std::string& name)
  {
    std::printf("%-44s %8ld %7ld %7ld %8.0f %8.0f %6.0f %6.0f\n", name.c_str(), states, refused, beside,
                quantile(work, 0.999), quantile(work, 1), quantile(solutions, 0.999), quantile(solutions, 1));
  }
};

/// Standard profiles, and those of measured points.
std::vector<SceneProfile> profilesOf(ProfileKind kind, const std::vector<SceneProfile>& pool)
{
  std::vector<SceneProfile> profiles;
  for (const std::string& name : standardProfileNames(kind))
  {
    profiles.push_back(loadSceneProfile(name, kind));
  }
  std::copy_if(pool.begin(), pool.end(), std::back_inserter(profiles),
               [](const SceneProfile& profile) { return profile.noise.value_or(0) > 0; });
  return profiles;
}

int runRandom(const ScenePool& pool, long count, unsigned long seed)
{
  constexpr int states_per_setup = 50;
  std::printf("seed %lu\n", seed);
  scenes::Random random(seed);
  const std::vector<SceneProfile> wheels = profilesOf(ProfileKind::wheel, pool.wheels),
                                  rails = profilesOf(ProfileKind::rail, pool.rails);
  std::map<std::string, ClassCount> classes;
  ClassCount all;
  while (all.states < count)
  {
    Setup setup;
    const bool unequal = scenes::oneIn(random, 4);
    setup.wheel = wheels[random() % wheels.size()];
    setup.rail = rails[random() % rails.size()];
    if (unequal)
    {
      setup.wheel.right = wheels[random() % wheels.size()];
      setup.rail.right = rails[random() % rails.size()];
    }
    const std::size_t table = random() % (pool.tables.size() + 1);
    setup.table = table < pool.tables.size() ? pool.tables[table].file : "rigid";
    setup.moments = scenes::oneIn(random, 2);
    setup.tolerance = scenes::oneIn(random, 2) ? 0.1 : 0.01;
    char name[100];
    std::snprintf(name, sizeof name, "%s %s %g %s", setup.balance(), setup.table.c_str(), setup.tolerance,
                  setup.isUnequal()    ? "unequal"
                  : setup.isMeasured() ? "measured"
                                       : "standard");
    MeasuredBalance balance(setup, pool);
    for (int k = 0; k < states_per_setup && all.states < count; ++k)
    {
      LoadedState state;
      state.y = scenes::uniform(random, -9e-3, 9e-3);
      state.yaw = scenes::oneIn(random, 2) ? 0 : scenes::uniform(random, -0.02, 0.02);
      state.wheel_load = {scenes::uniform(random, 5e3, 1.5e5), scenes::uniform(random, 5e3, 1.5e5)};
      balance.reset();
      const Measurement result = balance.solve(state);
      const bool usable = isUsable(result.status);
      const std::string reason(balance.balance().reason());
      const bool beside = !usable && !balance.isOverRails(state);
      if (!usable)
      {
        std::printf("%s (%s, %d solutions): state %s\n", beside ? "beside" : "refused", reason.c_str(),
                    result.solutions, setup.arguments(state).c_str());
        std::fflush(stdout);
      }
      for (ClassCount* counted : {&classes[name], &all})
      {
        ++counted->states;
        counted->refused += !usable && !beside ? 1 : 0;
        counted->beside += beside ? 1 : 0;
        counted->work.push_back(result.work);
        counted->solutions.push_back(result.solutions);
      }
    }
  }
  std::printf("%-44s %8s %7s %7s %8s %8s %6s %6s\n", "class", "states", "refused", "beside", "work999", "largest",
              "sol999", "most");
  for (auto& [name, counted] : classes)
  {
    counted.print(name);
  }
  all.print("all");
  std::printf("median work %.4g, 99 %% %.4g\n", quantile(all.work, 0.5), quantile(all.work, 0.99));
  return all.refused > 0 ? 1 : 0;
}

/// A profile of a pool, or a standard one.
SceneProfile profileNamed(const std::string& name, ProfileKind kind, const std::vector<SceneProfile>& pool)
{
  const auto found =
      std::find_if(pool.begin(), pool.end(), [&](const SceneProfile& profile) { return profile.name == name; });
  return found != pool.end() ? *found : loadSceneProfile(name, kind);
}

bool printState(const char* how, const MeasuredBalance& measured, const LoadedState& state, const Measurement& result,
                int refused)
{
  std::printf("%-8s %s, y %.9g m: %d solutions, work %.1f, %.3f ms", how, nameOf(result.status), state.y,
              result.solutions, result.work, result.milliseconds);
  if (isUsable(result.status))
  {
    const RailResult left = measured.balance().wheel(Side::left).rail(),
                     right = measured.balance().wheel(Side::right).rail();
    std::printf(", Q %.8g %.8g N, Y %.8g %.8g N, z %.9g m, roll %.9g rad", left.vertical_force, right.vertical_force,
                left.lateral_force, right.lateral_force, measured.balance().height(), measured.balance().roll());
  }
  std::printf("; %d states refused\n", refused);
  return refused == 0;
}

/// Solves a path of 200 steps to the state.
bool printPath(const char* how, const Setup& setup, const ScenePool& pool, const LoadedState& state, double from)
{
  constexpr int steps = 200;
  MeasuredBalance measured(setup, pool);
  Measurement result;
  int refused = 0;
  for (int k = 0; k <= steps; ++k)
  {
    LoadedState at = state;
    at.y = k == steps ? state.y : from + (state.y - from) * k / steps;
    result = measured.solve(at);
    refused += isUsable(result.status) ? 0 : 1;
  }
  return printState(how, measured, state, result, refused);
}

int runState(const ScenePool& pool, const Words& words)
{
  Setup setup;
  setup.wheel = profileNamed(words[0], ProfileKind::wheel, pool.wheels);
  setup.rail = profileNamed(words[1], ProfileKind::rail, pool.rails);
  if (words.size() == 11)
  {
    setup.wheel.right = profileNamed(words[9], ProfileKind::wheel, pool.wheels);
    setup.rail.right = profileNamed(words[10], ProfileKind::rail, pool.rails);
  }
  setup.table = words[2];
  setup.moments = words[3] == "moments";
  setup.tolerance = std::stod(words[4]);
  const LoadedState state{std::stod(words[5]), std::stod(words[6]), {std::stod(words[7]), std::stod(words[8])}};
  MeasuredBalance measured(setup, pool);
  const Measurement cold = measured.solve(state);
  bool good = printState("cold", measured, state, cold, isUsable(cold.status) ? 0 : 1);
  good = printPath("outward", setup, pool, state, 0) && good;
  return printPath("inward", setup, pool, state, state.y + std::copysign(1e-3, state.y)) && good ? 0 : 1;
}

/// Results of a sweep.
struct SweepResult
{
  std::vector<double> work, milliseconds;
  int refused = 0, above_tolerance = 0, worst_solutions = 0;
  double worst_work = 0, worst_y = 0;
};

SweepResult sweep(const Setup& setup, const ScenePool& pool, LoadedState state, int states)
{
  constexpr double end = 8e-3;  // [m]
  SweepResult sweep;
  for (int run = 0; run < 2; ++run)
  {
    MeasuredBalance measured(setup, pool);
    for (int k = 0; k < states; ++k)
    {
      state.y = end * (2.0 * k / (states - 1) - 1);
      const Measurement result = measured.solve(state);
      if (run > 0)
      {
        double& milliseconds = sweep.milliseconds[static_cast<std::size_t>(k)];
        milliseconds = std::min(milliseconds, result.milliseconds);
        continue;
      }
      sweep.work.push_back(result.work);
      sweep.milliseconds.push_back(result.milliseconds);
      sweep.refused += isUsable(result.status) ? 0 : 1;
      sweep.above_tolerance += result.above_tolerance ? 1 : 0;
      if (result.work > sweep.worst_work)
      {
        sweep.worst_work = result.work;
        sweep.worst_solutions = result.solutions;
        sweep.worst_y = state.y;
      }
    }
  }
  return sweep;
}

/// Sweeps whose names contain all words. Ratios are to the medians of the sweep of the same rail and load with rigid
/// rails, wheel_loads and no yaw.
int runSweeps(const ScenePool& pool, int states, const Words& words)
{
  std::vector<std::string> tables{"rigid"};
  for (const NamedTable& table : pool.tables)
  {
    tables.push_back(table.file);
  }
  int refused = 0;
  std::printf("%-58s %7s %7s %7s %7s %6s %8s %4s %7s %6s %6s %7s\n", "", "median", "99 %", "99.9 %", "largest", "ratio",
              "y [mm]", "sol.", "[ms]", "ratio", "above", "refused");
  for (const char* rail : {"60E1", "UIC60_manchester"})
  {
    for (const double load : {2e4, 1e5})
    {
      double reference_work = 0, reference_time = 0;
      for (int k = 0; k < static_cast<int>(4 * tables.size()); ++k)
      {
        Setup setup;
        setup.wheel = profileNamed("S1002", ProfileKind::wheel, pool.wheels);
        setup.rail = profileNamed(rail, ProfileKind::rail, pool.rails);
        setup.table = tables[static_cast<std::size_t>(k / 4)];
        setup.moments = k % 4 >= 2;
        const LoadedState state{0, k % 2 == 0 ? 0 : 0.01, load};
        char name[100];
        std::snprintf(name, sizeof name, "%s %s %s %gmrad %gkN", rail, setup.table.c_str(), setup.balance(),
                      1e3 * state.yaw, 1e-3 * load);
        const bool chosen =
            std::all_of(words.begin(), words.end(),
                        [&](const std::string& word)
                        { return (" " + std::string(name) + " ").find(" " + word + " ") != std::string::npos; });
        if (!chosen && k > 0)
        {
          continue;
        }
        SweepResult result = sweep(setup, pool, state, states);
        const double work = quantile(result.work, 0.5), most = quantile(result.work, 1);
        const double time = quantile(result.milliseconds, 0.5), longest = quantile(result.milliseconds, 1);
        if (k == 0)
        {
          reference_work = work;
          reference_time = time;
        }
        if (chosen)
        {
          refused += result.refused;
          std::printf("%-58s %7.1f %7.1f %7.1f %7.1f %6.1f %8.4f %4d %7.3f %6.1f %5.2f%% %7d\n", name, work,
                      quantile(result.work, 0.99), quantile(result.work, 0.999), most, most / reference_work,
                      1e3 * result.worst_y, result.worst_solutions, longest, longest / reference_time,
                      100.0 * result.above_tolerance / states, result.refused);
          std::fflush(stdout);
        }
      }
      std::printf("%s %g kN: reference work %.2f, %.4f ms\n", rail, 1e-3 * load, reference_work, reference_time);
    }
  }
  return refused > 0 ? 1 : 0;
}

int run(Words words)
{
  const std::string mode = words.empty() ? "" : words[0];
  words.erase(words.begin(), words.begin() + (words.empty() ? 0 : 1));
  const ScenePool pool = readScenePool();
  if (mode == "random" && (words.size() == 1 || words.size() == 2))
  {
    return runRandom(pool, std::stol(words[0]), words.size() == 2 ? std::stoul(words[1]) : 1);
  }
  if (mode == "state" && (words.size() == 9 || words.size() == 11))
  {
    return runState(pool, words);
  }
  if (mode == "sweep")
  {
    int states = 10001;
    if (!words.empty() && words[0].find_first_not_of("0123456789") == std::string::npos)
    {
      states = std::stoi(words[0]);
      words.erase(words.begin());
    }
    return runSweeps(pool, states, words);
  }
  std::fprintf(stderr, "usage: solver_campaign random N [SEED] | state ... | sweep [STATES] [WORD...]\n");
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
    std::fprintf(stderr, "solver_campaign: %s\n", error.what());
    return 2;
  }
}
