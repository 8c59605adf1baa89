// SPDX-License-Identifier: BSD-3-Clause
// Fits the bias correction of the pressure peak (core/normal/measures/peak_bias.h).
//
//   fit_peak_bias [wheelset scenes, default 1000] [Hertz contacts, default 12000] [gaps, default 6000]
//                 [seed, default 1] [passes, default 300]
//
// Minimises the mean of (error² + 0.05²)^1/2 on settled_contacts.h. Errors are divided by the expected bias, an
// eightieth of the bend plus 0.01 %: about the error of the parabolas in smooth contacts. The reference of the
// wheelsets uses the present weights, on cells where they hardly matter. Prints the remaining errors on samples of the
// next seed (a quarter as many; for the new weights without the limit of peakPressure()) and the weights in the format
// of peak_bias_weights.cpp. Takes about ten minutes; not part of the test run.
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "chart/quantile.h"
#include "core/normal/measures/peak_bias.h"
#include "core/normal/measures/peak_pressure.h"
#include "relu_fit.h"
#include "settled_contacts.h"

namespace
{
using namespace wheel_rail_contact::core;

struct Samples
{
  std::vector<PeakInputs> peaks;
  std::vector<float> bias;      ///< of the parabolas [-]
  std::vector<float> off;       ///< error with the present weights [-]
  std::vector<float> expected;  ///< expected bias, which divides the errors [-]
};

/// Adds the highest peak, unless another peak is higher by the present weights or no bias is subtracted there.
void add(const fits::Contact& contact, Samples& samples)
{
  const PatchPressure& patch = contact.found;
  Eigen::Index row = 0, column = 0;
  patch.pressure.maxCoeff(&row, &column);
  const CellsAround peak(patch.grid, patch.pressure, row, column);
  const double present = peakPressure(contact.gap, contact.modulus, peak);
  const GapSteps steps = gapSteps(peak, contact.gap, contact.modulus);
  if (present < patch.max_pressure || !showsBias(peak, steps))
  {
    return;
  }
  samples.peaks.emplace_back(peak, steps, std::log(patch.grid.dx / patch.grid.dy));
  samples.bias.push_back(static_cast<float>(peak.parabolas() / contact.true_pressure - 1));
  samples.off.push_back(static_cast<float>(present / contact.true_pressure - 1));
  samples.expected.push_back(static_cast<float>(peak.bend() / 80 + 1e-4));
}

/// Several peaks together, divided by the expected bias. The first half of the columns contains the first tips and
/// sides, the second half the second ones.
struct Batch
{
  Eigen::MatrixXf tips, sides;
  Eigen::RowVectorXf along;  ///< bend, for each tip
  Eigen::ArrayXf bias;

  Batch(const Samples& samples, const std::vector<std::size_t>& peaks, const PeakInputs::Side& units)
  {
    const auto count = static_cast<Eigen::Index>(peaks.size());
    tips.resize(edge_inputs, 2 * count);
    sides.resize(peak_inputs, 2 * count);
    along.resize(2 * count);
    bias.resize(count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const std::size_t k = peaks[static_cast<std::size_t>(i)];
      const PeakInputs& peak = samples.peaks[k];
      const float expected = samples.expected[k];
      for (Eigen::Index side = 0; side < 2; ++side)
      {
        const auto half = static_cast<std::size_t>(side);
        tips.col(side * count + i) = peak.tips[half].matrix();
        sides.col(side * count + i) = (peak.sides[half] / (units * expected)).matrix();
        along[side * count + i] = static_cast<float>(peak.along) / expected;
      }
      bias[i] = samples.bias[k] / expected;
    }
  }
};

class Fit
{
  static constexpr float blunt = 0.05F;  ///< smaller errors count by their square, over the expected bias

 public:
  Fit(std::mt19937_64& random, const PeakInputs::Side& units) : tip_(random, 0.01), side_(random, 0.1), units_(units) {}

  const PeakInputs::Side& units() const { return units_; }

  /// Remaining errors over the expected bias.
  Eigen::ArrayXf left(const Batch& batch)
  {
    const Eigen::RowVectorXf both =
        (batch.along.array() * tip_.values(batch.tips).array()).matrix() + side_.values(batch.sides);
    const Eigen::Index count = batch.bias.size();
    return (both.head(count) + both.tail(count)).transpose().array() - batch.bias;
  }

  /// Makes a step. Returns the errors before it.
  Eigen::ArrayXf step(const Batch& batch, double rate)
  {
    const Eigen::ArrayXf errors = left(batch);
    const Eigen::RowVectorXf pull = fits::pullOf(errors, blunt).matrix().transpose();
    Eigen::RowVectorXf both(2 * pull.size());
    both << pull, pull;
    tip_.step(batch.tips, (both.array() * batch.along.array()).matrix(), rate);
    side_.step(batch.sides, both, rate);
    return errors;
  }

  void print() const
  {
    PeakBias found{tip_.sum(), side_.sum()};
    for (Eigen::Index k = 0; k < peak_inputs; ++k)
    {
      constexpr int units = PeakBias::side_units;
      found.side.all.segment<units>(k * units) /= units_[k];
    }
    found.side.all.tail<peak_inputs>() /= units_;
    Eigen::ArrayXf numbers(PeakBias::numbers);
    numbers << found.tip.all, found.side.all;
    fits::print(numbers);
  }

 private:
  fits::ReluFit<edge_inputs, PeakBias::tip_units> tip_;
  fits::ReluFit<peak_inputs, PeakBias::side_units> side_;
  PeakInputs::Side units_;
};

/// For each input of a side: the 90 % quantile of its absolute value over the expected bias.
PeakInputs::Side unitsOf(const Samples& samples)
{
  PeakInputs::Side units;
  for (Eigen::Index k = 0; k < peak_inputs; ++k)
  {
    std::vector<double> sizes;
    for (std::size_t i = 0; i < samples.peaks.size(); ++i)
    {
      sizes.push_back(static_cast<double>(std::abs(samples.peaks[i].sides[0][k]) / samples.expected[i]));
    }
    units[k] = static_cast<float>(std::max(chart::quantile(sizes, 0.9), 1e-6));
  }
  return units;
}

void printErrors(const char* name, const Samples& samples, Fit& fit)
{
  const std::vector<std::size_t> all = fits::upTo(samples.peaks.size());
  const Batch batch(samples, all, fit.units());
  const auto count = batch.bias.size();
  std::printf("%s: %td peaks; errors over the expected bias\n", name, count);
  fits::printSizes("no correction", batch.bias);
  fits::printSizes("present weights", Eigen::Map<const Eigen::ArrayXf>(samples.off.data(), count) /
                                          Eigen::Map<const Eigen::ArrayXf>(samples.expected.data(), count));
  fits::printSizes("new weights", fit.left(batch));
}
}  // namespace

int main(int argc, char** argv)
{
  const auto argument = [&](int index, long otherwise)
  { return argc > index ? std::strtol(argv[index], nullptr, 10) : otherwise; };
  const int wheelsets = static_cast<int>(argument(1, 1000)), hertz = static_cast<int>(argument(2, 12000)),
            gaps = static_cast<int>(argument(3, 6000));
  const auto seed = static_cast<unsigned long>(argument(4, 1));
  const Samples samples = fits::collect<Samples>({wheelsets, hertz, gaps}, seed);
  std::mt19937_64 random(seed);
  Fit fit(random, unitsOf(samples));
  fits::inBatches(samples.peaks.size(), static_cast<int>(argument(5, 300)), random,
                  [&](const std::vector<std::size_t>& batch, double rate)
                  { return fit.step(Batch(samples, batch, fit.units()), rate); });
  printErrors("samples of the fit", samples, fit);
  printErrors("wheelsets of the next seed", fits::collect<Samples>({wheelsets / 4, 0, 0}, seed + 1), fit);
  printErrors("Hertz contacts of the next seed", fits::collect<Samples>({0, hertz / 4, 0}, seed + 1), fit);
  printErrors("gaps of the next seed", fits::collect<Samples>({0, 0, gaps / 4}, seed + 1), fit);
  fit.print();
  return 0;
}
