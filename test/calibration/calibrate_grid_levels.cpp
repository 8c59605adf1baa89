// SPDX-License-Identifier: BSD-3-Clause
// Computes the values of each grid level of `method: auto` in src/core/balance/grid_levels.cpp: its ordinary error and
// its typical estimates.
//
//   calibrate_grid_levels [scenes, default 300] [seed, default 3]
//
// Random wheelsets (S1002 on 60E1 and UIC60, y up to 7 mm) are solved by conjugate gradients on the grid of every
// level. For `scenes` of them the reference is found on 128 × 320 cells. Twenty times as many are estimated without a
// reference.
//
// Prints for each grid the true error that 98 % of the patches do not exceed, and the typical estimates of max
// pressure, area without narrow ends, approach and narrow ends, over those of the same patch on 24 × 56 cells, with the
// range of their middle half. The typical estimate of a quantity is the median over the patches in which it is the
// largest on 24 × 56 cells (approach, which is the largest in few: over all patches). Finer grids are intended for
// patches whose estimate on 24 × 56 cells is above 0.3 %, so only these count there. Takes ten minutes; not part of the
// test run.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "../core/normal/error_samples.h"
#include "chart/quantile.h"

namespace
{
using namespace wheel_rail_contact::core;
using scenes::ErrorSample;

constexpr GridSize truth{128, 320}, unit{24, 56};
/// Finer grids than `unit` are intended for patches whose estimate on it is above this [-].
constexpr double finest_tolerance = 0.003;

/// Grids of all levels, in their order.
std::vector<GridSize> levelGrids()
{
  const GridLevels levels{ContactModelConfig()};
  std::vector<GridSize> sizes;
  for (std::size_t k = 0; k < levels.count(); ++k)
  {
    sizes.push_back(levels.at(k).size);
  }
  return sizes;
}

/// Max pressure, area without narrow ends, approach, narrow ends; all without the part of the residual.
using Parts = std::array<double, 4>;

Parts partsOf(const ErrorEstimate& error)
{
  const ErrorEstimate algebra = ofResidual(error.residual);
  return {error.max_pressure - algebra.max_pressure, error.area - error.narrow_ends - algebra.area,
          error.approach - algebra.approach, error.narrow_ends};
}

/// Samples of the patches of every scene, in the same order for each grid. Only scenes with the same number of patches
/// on all grids are kept.
template <typename Sample>
class ByGrid
{
 public:
  explicit ByGrid(std::vector<GridSize> sizes) : sizes_(std::move(sizes)), samples_(sizes_.size()) {}

  /// @param sample  called with a size and a list: adds a sample of each patch; false if the grid has no solution
  /// @return false if a grid has no solution or another number of patches
  template <typename Solve>
  bool add(Solve sample)
  {
    std::vector<std::vector<Sample>> found(sizes_.size());
    for (std::size_t k = 0; k < sizes_.size(); ++k)
    {
      if (!sample(sizes_[k], found[k]) || found[k].size() != found[0].size())
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

  const std::vector<GridSize>& sizes() const { return sizes_; }
  const std::vector<Sample>& of(std::size_t grid) const { return samples_[grid]; }

 private:
  std::vector<GridSize> sizes_;
  std::vector<std::vector<Sample>> samples_;
};

using Errors = ByGrid<ErrorSample>;
using Estimates = ByGrid<Parts>;

double ordinaryError(const Errors& errors, std::size_t grid)
{
  std::vector<double> list;
  std::transform(errors.of(grid).begin(), errors.of(grid).end(), std::back_inserter(list),
                 [](const ErrorSample& sample) { return sample.error.largest(); });
  return chart::quantile(list, 0.98);
}

/// Estimates of a quantity on a grid over those on the unit grid, of the patches that count.
std::vector<double> ratios(const Estimates& estimates, std::size_t grid, std::size_t quantity)
{
  constexpr std::size_t approach = 2;
  const auto unit_grid = static_cast<std::size_t>(std::find(estimates.sizes().begin(), estimates.sizes().end(), unit) -
                                                  estimates.sizes().begin());
  std::vector<double> list;
  for (std::size_t k = 0; k < estimates.of(unit_grid).size(); ++k)
  {
    const Parts& parts = estimates.of(unit_grid)[k];
    const auto largest = std::max_element(parts.begin(), parts.end());
    const bool decides = quantity == approach || largest == parts.begin() + static_cast<std::ptrdiff_t>(quantity);
    if (decides && (grid <= unit_grid || quantity == approach || *largest > finest_tolerance))
    {
      list.push_back(estimates.of(grid)[k][quantity] / parts[quantity]);
    }
  }
  return list;
}

void print(const Errors& errors, const Estimates& estimates)
{
  for (std::size_t grid = 0; grid < errors.sizes().size(); ++grid)
  {
    const GridSize& size = errors.sizes()[grid];
    std::printf("{{%d, %d}, %.4f, {", size.along, size.across, ordinaryError(errors, grid));
    std::string spread;
    for (std::size_t quantity = 0; quantity < Parts().size(); ++quantity)
    {
      const std::vector<double> list = ratios(estimates, grid, quantity);
      char text[80];
      std::snprintf(text, sizeof text, "  %.2f to %.2f of %zu", chart::quantile(list, 0.25),
                    chart::quantile(list, 0.75), list.size());
      spread += text;
      std::printf("%s%.3g", quantity > 0 ? ", " : "", chart::quantile(list, 0.5));
    }
    std::printf("}}  %s\n", spread.c_str());
  }
}

/// Adds the estimates of every patch of a wheelset on a grid, without a reference. Returns false if there is no
/// solution.
bool estimate(const GridLevels& levels, const scenes::WheelsetScene& scene, std::vector<Parts>& parts)
{
  constexpr double settled = 2e-3;  // tolerance for planes and roll
  ContactModelConfig config = scene.config;
  config.contact.tolerance = settled;
  WheelsetBalance balance(config, levels);
  if (balance.solve(scene.state) != ContactStatus::ok)
  {
    return false;
  }
  for (const Side side : {Side::left, Side::right})
  {
    const WheelContact& wheel = balance.wheel(side);
    const std::vector<ErrorEstimate> errors = errorsOf(levels.solver(), wheel.problem(), wheel.solution());
    for (std::size_t k = 0; k < errors.size(); ++k)
    {
      if (wheel.solution().patches[k].force > 0)
      {
        parts.push_back(partsOf(errors[k]));
      }
    }
  }
  return true;
}
}  // namespace

int main(int argc, char** argv)
{
  const int count = argc > 1 ? std::atoi(argv[1]) : 300;
  const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 3;
  if (count < 1 || argc > 3)
  {
    std::fprintf(stderr, "usage: calibrate_grid_levels [SCENES [SEED]]\n");
    return 2;
  }
  constexpr int estimates_per_error = 20;
  Errors errors(levelGrids());
  Estimates estimates(levelGrids());
  scenes::WheelsetSampler sampler{scenes::Method::grid};
  scenes::Random seeds(seed);
  int left_out = 0;
  for (int i = 0; i < estimates_per_error * count; ++i)
  {
    scenes::Random random(seeds());
    const scenes::WheelsetScene scene = scenes::randomWheelsetScene(random);
    if (i < count)
    {
      left_out += errors.add([&](const GridSize& size, auto& list) { return sampler.sample(scene, size, truth, list); })
                      ? 0
                      : 1;
    }
    estimates.add([&](const GridSize& size, auto& list)
                  { return estimate(sampler.levelsFor(scenes::Method::grid, size), scene, list); });
    std::fprintf(stderr, "\rscene %d of %d", i + 1, estimates_per_error * count);
  }
  std::fprintf(stderr, "\n");
  std::printf("seed %lu: %d scenes, %d of them left out, %zu patches; estimates of %zu patches\n", seed, count,
              left_out, errors.of(0).size(), estimates.of(0).size());
  print(errors, estimates);
  return 0;
}
