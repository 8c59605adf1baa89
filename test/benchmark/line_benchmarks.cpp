// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <numeric>

#include "../standard_headers.h"
#include "benchmarks.h"

namespace wheel_rail_contact
{
namespace
{
constexpr double length = 100;  ///< of the line [m]
constexpr double pi = 3.14159265358979323846;

using Line = std::shared_ptr<const core::TrackLine>;

/// Random waves of 3 m to 25 m with a given standard deviation.
class Waves
{
 public:
  Waves(std::mt19937& random, double deviation)
  {
    std::uniform_real_distribution<double> phase(0, 2 * pi);
    for (Wave& wave : waves_)
    {
      wave.phase = phase(random);
      wave.number = 2 * pi / (3 + 22 * phase(random) / (2 * pi));
    }
    amplitude_ = deviation * std::sqrt(2.0 / static_cast<double>(waves_.size()));
  }
  double at(double x) const
  {
    double sum = 0;
    for (const Wave& wave : waves_)
    {
      sum += amplitude_ * std::cos(wave.number * x + wave.phase);
    }
    return sum;
  }

 private:
  struct Wave
  {
    double number, phase;  ///< [rad/m], [rad]
  };
  std::array<Wave, 30> waves_{};
  double amplitude_ = 0;
};

/// Stations every 0.25 m. The standard deviations are those of a good line for 200 to 300 km/h.
Line irregularLine()
{
  constexpr double spacing = 0.25;
  std::mt19937 random(20111U);
  const Waves alignment(random, 0.7e-3), level(random, 1e-3), cross_level(random, 0.8e-3), widening(random, 0.4e-3);
  std::vector<core::LineStation> stations;
  for (double x = 0; x <= length; x += spacing)
  {
    const double half = 0.5 * widening.at(x), middle = alignment.at(x), up = level.at(x);
    stations.push_back({x, cross_level.at(x), {core::RailDeflection{half + middle, up, 0}, {half - middle, up, 0}}});
  }
  return std::make_shared<core::TrackLine>("irregular", stations);
}

/// Time of each result of a wheelset [us], and the number of unusable results.
struct Times
{
  std::vector<double> each;
  int unusable = 0;

  void add(core::WheelsetContact& contact, const core::WheelsetState& state)
  {
    const double before = threadTime();
    unusable += isUsable(contact.evaluate(state).status) ? 0 : 1;
    each.push_back(1e6 * (threadTime() - before));
  }
  double quantile(double part)
  {
    const auto place = each.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(each.size() - 1));
    std::nth_element(each.begin(), place, each.end());
    return *place;
  }
};

/// CPU times of a hunting wheelset (Klingel motion, 3 mm, 16.5 m) that runs over a line, 0.02 m from state to state.
/// Each state is evaluated on the ideal track and on the line in alternation. Counters: `median_us` and `p99_us` on the
/// line; `median_ratio` and `mean_ratio`, the times on the line over those on the ideal track.
void run(benchmark::State& state, const Line& line)
{
  constexpr double step = 0.02, amplitude = 3e-3, wavelength = 16.5;  // [m]
  core::ContactModelConfig config = core::manchesterScene();
  core::WheelsetContact ideal(config);
  config.track.line = line;
  core::WheelsetContact on_line(config);
  Times ideal_times, line_times;
  core::WheelsetState wheelset;
  wheelset.force_z = -200e3;
  for (auto _ : state)
  {
    for (double x = 0; x <= length; x += step)
    {
      const double phase = 2 * pi * x / wavelength;
      wheelset.x = wheelset.distance = x;
      wheelset.y = amplitude * std::sin(phase);
      wheelset.yaw = amplitude * 2 * pi / wavelength * std::cos(phase);
      ideal_times.add(ideal, wheelset);
      line_times.add(on_line, wheelset);
    }
  }
  const auto sum = [](const Times& times) { return std::accumulate(times.each.begin(), times.each.end(), 0.0); };
  state.counters["median_us"] = line_times.quantile(0.5);
  state.counters["p99_us"] = line_times.quantile(0.99);
  state.counters["median_ratio"] = line_times.quantile(0.5) / ideal_times.quantile(0.5);
  state.counters["mean_ratio"] = sum(line_times) / sum(ideal_times);
  state.counters["unusable"] = line_times.unusable;
}
}  // namespace

void registerLines()
{
  const auto add = [](const std::string& name, const Line& line)
  {
    benchmark::RegisterBenchmark(("wheelset/line/" + name).c_str(),
                                 [line](benchmark::State& state) { run(state, line); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
  };
  add("none", nullptr);
  add("constant",
      std::make_shared<core::TrackLine>("constant", std::vector<core::LineStation>{{0, 0, {}}, {length, 0, {}}}));
  add("irregular", irregularLine());
}
}  // namespace wheel_rail_contact
