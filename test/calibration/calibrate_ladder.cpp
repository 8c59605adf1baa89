// SPDX-License-Identifier: BSD-3-Clause
// Finds what src/balance/method_ladder.cpp says of each grid of `method: auto`: its ordinary error and its typical
// estimates.
//
//   calibrate_ladder [scenes, default 300] [seed, default 3]
//
// Random wheelsets (S1002 on 60E1 and UIC60, y up to 7 mm) are solved by conjugate gradients on every grid of the
// ladder; truth is 128 × 320 cells. Prints for each grid the true error that 98 % of the patches stay below, the
// medians of the estimates over those of the same patch on 24 × 56 cells (of finer grids only where that is above 0.3
// %: the others are not for them), and for the largest of the three between what the middle 80 % of the patches lie.
// Takes some minutes; not part of the test run.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

#include "../normal/error_samples.h"
#include "chart/quantile.h"

namespace
{
using namespace wheel_rail_contact;
using scenes::ErrorSample;

constexpr GridSize truth{128, 320}, unit{24, 56};
/// Finer grids than the unit are for patches whose estimate on it is above this [-].
constexpr double finest_tolerance = 0.003;

/// Grids of the ladder, coarse to fine.
std::vector<GridSize> ladderGrids()
{
  const MethodLadder ladder{ContactModelConfig()};
  std::vector<GridSize> sizes;
  for (std::size_t k = 0; k < ladder.count(); ++k)
  {
    sizes.push_back(ladder.at(k).size);
  }
  return sizes;
}

/// Patches of every scene that all grids tell alike; in the same order for each grid.
class LadderSamples
{
 public:
  explicit LadderSamples(std::vector<GridSize> sizes) : sizes_(std::move(sizes)), samples_(sizes_.size()) {}

  /// @return false if a grid has no answer, or other patches
  bool add(const scenes::WheelsetScene& scene)
  {
    std::vector<std::vector<ErrorSample>> found(sizes_.size());
    for (std::size_t k = 0; k < sizes_.size(); ++k)
    {
      if (!sampler_.sample(scene, sizes_[k], truth, found[k]) || found[k].size() != found[0].size())
      {
        return false;
      }
    }
    for (std::size_t k = 0; k < sizes_.size(); ++k)
    {
      samples_[k].insert(samples_[k].end(), found[k].begin(), found[k].end());
    }
    return true;
  }

  std::size_t patches() const { return samples_[0].size(); }

  void print() const
  {
    for (std::size_t k = 0; k < sizes_.size(); ++k)
    {
      const auto [low, high] = middleOfLargest(k);
      std::printf("{{%d, %d}, %.4f, {%.3g, %.3g, %.3g}}   largest: %.2f to %.2f\n", sizes_[k].along, sizes_[k].across,
                  ordinaryError(k), typical(k, &ErrorEstimate::max_pressure), typical(k, &ErrorEstimate::area),
                  typical(k, &ErrorEstimate::approach), low, high);
    }
  }

 private:
  double ordinaryError(std::size_t grid) const
  {
    std::vector<double> errors;
    std::transform(samples_[grid].begin(), samples_[grid].end(), std::back_inserter(errors),
                   [](const ErrorSample& sample) { return sample.error.largest(); });
    return chart::quantile(errors, 0.98);
  }

  /// Of every patch, what `of` makes of its estimate, over the same on the unit grid.
  template <typename Of>
  std::vector<double> ratios(std::size_t grid, Of of) const
  {
    const auto unit_grid = std::find(sizes_.begin(), sizes_.end(), unit);
    const std::vector<ErrorSample>& units = samples_[static_cast<std::size_t>(unit_grid - sizes_.begin())];
    const bool finer = std::distance(sizes_.begin(), unit_grid) < static_cast<std::ptrdiff_t>(grid);
    std::vector<double> list;
    for (std::size_t k = 0; k < units.size(); ++k)
    {
      if (!finer || units[k].estimate.largest() > finest_tolerance)
      {
        list.push_back(of(samples_[grid][k].estimate) / of(units[k].estimate));
      }
    }
    return list;
  }

  double typical(std::size_t grid, double ErrorEstimate::*quantity) const
  {
    return chart::quantile(ratios(grid, [&](const ErrorEstimate& estimate) { return estimate.*quantity; }), 0.5);
  }

  std::pair<double, double> middleOfLargest(std::size_t grid) const
  {
    const std::vector<double> list = ratios(grid, [](const ErrorEstimate& estimate) { return estimate.largest(); });
    return {chart::quantile(list, 0.1), chart::quantile(list, 0.9)};
  }

  std::vector<GridSize> sizes_;
  std::vector<std::vector<ErrorSample>> samples_;  ///< by grid
  scenes::WheelsetSampler sampler_{scenes::Method::grid};
};
}  // namespace

int main(int argc, char** argv)
{
  const int count = argc > 1 ? std::atoi(argv[1]) : 300;
  const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 3;
  if (count < 1 || argc > 3)
  {
    std::fprintf(stderr, "usage: calibrate_ladder [SCENES [SEED]]\n");
    return 2;
  }
  LadderSamples samples(ladderGrids());
  scenes::Random seeds(seed);
  int left_out = 0;
  for (int i = 0; i < count; ++i)
  {
    scenes::Random random(seeds());
    left_out += samples.add(scenes::randomWheelsetScene(random)) ? 0 : 1;
    std::fprintf(stderr, "\rscene %d of %d", i + 1, count);
  }
  std::fprintf(stderr, "\n");
  std::printf("seed %lu: %d scenes, %d of them left out, %zu patches\n", seed, count, left_out, samples.patches());
  samples.print();
  return 0;
}
