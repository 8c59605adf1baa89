// SPDX-License-Identifier: BSD-3-Clause
// Fits what a polygon through the crossings of the contact's edge is too large by (normal/edge_excess.h).
//
//   fit_edge_excess [wheelset scenes, default 1000] [Hertz contacts, default 12000] [seed, default 1] [passes, default
//                   450]
//
// Samples: wheelsets, each on every grid below against 192 × 512 cells, whose area by the present weights counts as
// true; Hertz contacts of B/A from 0.1 to 20, a quarter turned by up to 0.3 rad, a quarter of a handful of cells, on
// one of the grids. The weights are those with the least mean of (error² + 0.05²)^1/2, errors in cells, found by Adam's
// method (Kingma and Ba 2015) in batches of 256 contacts with steps falling as a cosine. Prints how much of the error
// is left on samples of the next seed (a quarter as many), and the weights as they stand in edge_excess_weights.cpp.
// Takes about ten minutes; not part of the test run.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <vector>

#include "../normal/error_samples.h"
#include "chart/quantile.h"
#include "normal/contact_edge.h"
#include "normal/edge_excess.h"
#include "wheel_rail_contact/normal/hertz.h"

namespace
{
using namespace wheel_rail_contact;

constexpr std::array<GridSize, 20> grids{{{4, 16},  {6, 16},  {6, 24},  {8, 16},  {8, 24},  {10, 24}, {12, 24},
                                          {12, 32}, {16, 32}, {16, 48}, {12, 64}, {20, 48}, {16, 64}, {24, 56},
                                          {16, 80}, {16, 96}, {24, 80}, {32, 64}, {32, 96}, {48, 96}}};
constexpr GridSize true_size{192, 512};

/// Contacts with their crossings.
struct Samples
{
  std::vector<EdgeInputs> crossings;  ///< of all contacts
  std::vector<std::size_t> ends;      ///< of each contact's crossings
  std::vector<float> images;          ///< of each contact's crossings: 2 if half of it is stored
  std::vector<float> polygon;         ///< of the whole [cells]
  std::vector<float> excess;          ///< of the polygon [cells]
  std::vector<float> off;             ///< the area that the present weights give less the true one [cells]

  std::size_t count() const { return ends.size(); }
  std::size_t begin(std::size_t contact) const { return contact > 0 ? ends[contact - 1] : 0; }
};

void add(const PatchPressure& patch, double true_area, Samples& samples)
{
  const double images = patch.grid.symmetric ? 2 : 1;
  const double aspect = patch.grid.dx / patch.grid.dy, cells = true_area / (patch.grid.dx * patch.grid.dy);
  EdgePolygon polygon;
  polygon.frame(patch.pressure, patch.grid.symmetric);
  samples.off.push_back(static_cast<float>(images * polygon.cells(aspect) - cells));
  const double chords = images * polygon.chords();
  samples.polygon.push_back(static_cast<float>(chords));
  samples.excess.push_back(static_cast<float>(chords - cells));
  samples.images.push_back(static_cast<float>(images));
  for (const EdgeCrossing& crossing : polygon.crossings())
  {
    samples.crossings.push_back(edgeInputs(crossing, std::log(aspect)));
  }
  samples.ends.push_back(samples.crossings.size());
}

/// On a grid that holds the contact, by parts of a cell off its middle.
void addHertz(scenes::Random& random, ConjugateGradients& solver, Samples& samples)
{
  constexpr double modulus = 1.14e11, load = 1e4;
  const GridSize size = grids[random() % grids.size()];
  const bool symmetric = scenes::oneIn(random, 2), few = scenes::oneIn(random, 4);
  const double angle = symmetric || scenes::oneIn(random, 2) ? 0 : scenes::uniform(random, 0, 0.3);
  const double ratio = std::exp(scenes::uniform(random, std::log(0.1), std::log(20)));
  const HertzContact hertz = hertzForForce({1, ratio}, modulus, load);
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const double along = std::hypot(hertz.semi_axis_x * cosine, hertz.semi_axis_y * sine);
  const double across = std::hypot(hertz.semi_axis_y * cosine, hertz.semi_axis_x * sine);
  const double margin_along =
      few ? scenes::uniform(random, 1.1, size.along / 2.5) : scenes::uniform(random, 1.03, 1.35);
  const double margin_across =
      few ? scenes::uniform(random, 1.1, size.across / 3.0) : scenes::uniform(random, 1.03, 1.35);
  const aspect_ladder::Cell cell =
      aspect_ladder::coveringCell(2 * margin_along * along, 2 * margin_across * across, size.along, size.across);
  const double x0 = symmetric ? 0 : scenes::uniform(random, -0.5, 0.5) * cell.dx;
  const double y0 = scenes::uniform(random, -0.5, 0.5) * cell.dy;
  const auto gap = [=](double x, double y)
  {
    const double u = (x - x0) * cosine + (y - y0) * sine, v = (y - y0) * cosine - (x - x0) * sine;
    return u * u + ratio * v * v;
  };
  NormalProblem problem;
  problem.modulus = modulus;
  problem.value = load;
  problem.patches.resize(1);
  problem.patches[0].grid = {size.along, size.across, cell.dx, cell.dy, -0.5 * (size.across - 1) * cell.dy, symmetric};
  scenes::sample(gap, problem.patches[0]);
  NormalSolution solution;
  solver.solve(problem, false, solution);
  if (solution.status == SolveStatus::converged && !solution.patches[0].touches_border)
  {
    add(solution.patches[0], hertz.area, samples);
  }
}

/// Wheels with a single patch.
class Wheelsets
{
 public:
  void add(const scenes::WheelsetScene& scene, Samples& samples)
  {
    ContactModelConfig settled = scene.config;
    settled.contact.tolerance = 1e-4;
    WheelsetBalance truth(settled, sampler_.ladderFor(scenes::Method::grid, true_size));
    if (truth.solve(scene.state) != ContactStatus::ok)
    {
      return;
    }
    for (const GridSize& size : grids)
    {
      WheelsetBalance balance(settled, sampler_.ladderFor(scenes::Method::grid, size));
      if (balance.solve(scene.state) != ContactStatus::ok)
      {
        continue;
      }
      for (const Side side : {Side::left, Side::right})
      {
        const auto& found = balance.wheel(side).solution().patches;
        const auto& exact = truth.wheel(side).solution().patches;
        if (balance.wheel(side).patches().size() == 1 && truth.wheel(side).patches().size() == 1)
        {
          ::add(found[0], exact[0].area, samples);
        }
      }
    }
  }

 private:
  scenes::WheelsetSampler sampler_{scenes::Method::grid};
};

Samples collect(int wheelset_scenes, int hertz_contacts, unsigned long seed)
{
  Samples samples;
  scenes::Random seeds(seed);
  ConjugateGradients strict(scenes::strictOptions());
  for (int i = 0; i < hertz_contacts; ++i)
  {
    addHertz(seeds, strict, samples);
  }
  Wheelsets wheelsets;
  for (int i = 0; i < wheelset_scenes; ++i)
  {
    scenes::Random random(seeds());
    wheelsets.add(scenes::randomWheelsetScene(random), samples);
    std::fprintf(stderr, "\rseed %lu: %d of %d wheelsets", seed, i + 1, wheelset_scenes);
  }
  std::fprintf(stderr, "\n");
  return samples;
}

/// Several contacts side by side.
struct Batch
{
  Eigen::MatrixXf inputs;    ///< edge_inputs × crossings
  std::vector<int> contact;  ///< of each crossing
  Eigen::ArrayXf images;     ///< of each contact
  Eigen::ArrayXf few;        ///< 1 / polygon
  Eigen::ArrayXf excess;     ///< true

  Batch(const Samples& samples, const std::size_t* contacts, Eigen::Index count)
      : images(count), few(count), excess(count)
  {
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const std::size_t k = contacts[i];
      images[i] = samples.images[k];
      few[i] = 1 / std::max(samples.polygon[k], 1.0F);
      excess[i] = samples.excess[k];
      contact.insert(contact.end(), samples.ends[k] - samples.begin(k), static_cast<int>(i));
    }
    inputs.resize(edge_inputs, static_cast<Eigen::Index>(contact.size()));
    Eigen::Index column = 0;
    for (Eigen::Index i = 0; i < count; ++i)
    {
      for (std::size_t c = samples.begin(contacts[i]); c < samples.ends[contacts[i]]; ++c)
      {
        inputs.col(column++) = samples.crossings[c].matrix();
      }
    }
  }
};

/// An EdgeExcess as one row of numbers, and the steps of Adam's method on it.
class Fit
{
  static constexpr int ramp_count = EdgeExcess::ramps;
  static constexpr float blunt = 0.05F;  ///< errors below that count by their square [cells]
  using Values = Eigen::Matrix<float, EdgeExcess::numbers, 1>;

  static Eigen::Map<Eigen::Matrix<float, ramp_count, edge_inputs>> slopes(Values& v)
  {
    return Eigen::Map<Eigen::Matrix<float, ramp_count, edge_inputs>>(v.data());
  }
  static auto offsets(Values& v) { return v.segment<ramp_count>(ramp_count * edge_inputs); }
  static auto heights(Values& v) { return v.segment<ramp_count>(ramp_count * (edge_inputs + 1)); }
  static auto linear(Values& v) { return v.segment<edge_inputs>(ramp_count * (edge_inputs + 2)); }
  static auto rest(Values& v) { return v.tail<3>(); }

 public:
  explicit Fit(unsigned long seed)
  {
    std::mt19937_64 random(seed);
    std::normal_distribution<float> normal;
    const auto fill = [&](auto&& block, double scale)
    { block = block.unaryExpr([&](float) { return static_cast<float>(scale) * normal(random); }); };
    values_.setZero();
    fill(slopes(values_), std::sqrt(2.0 / edge_inputs));
    fill(offsets(values_), 0.3);
    fill(heights(values_), 0.1 / std::sqrt(EdgeExcess::ramps));
  }

  /// What is left of the errors [cells].
  Eigen::ArrayXf step(const Batch& batch, double rate)
  {
    const auto count = batch.excess.size();
    const Eigen::MatrixXf ramp = ramps(batch);
    Eigen::ArrayXf left = predicted(batch, ramp) - batch.excess;
    const Eigen::ArrayXf pull = left / (left.square() + blunt * blunt).sqrt() / static_cast<float>(count);
    Eigen::RowVectorXf at(batch.inputs.cols());
    for (Eigen::Index c = 0; c < at.size(); ++c)
    {
      const int k = batch.contact[static_cast<std::size_t>(c)];
      at[c] = pull[k] * batch.images[k];
    }
    Values slope;
    const Eigen::MatrixXf rising = ((heights(values_) * at).array() * (ramp.array() > 0).cast<float>()).matrix();
    slopes(slope) = rising * batch.inputs.transpose();
    offsets(slope) = rising.rowwise().sum();
    heights(slope) = ramp * at.transpose();
    linear(slope) = batch.inputs * at.transpose();
    rest(slope) << at.sum(), pull.sum(), (pull * batch.few).sum();
    adam(slope, rate);
    return left;
  }

  Eigen::ArrayXf left(const Batch& batch) { return predicted(batch, ramps(batch)) - batch.excess; }

  void print() const
  {
    constexpr Eigen::Index per_line = 12;
    for (Eigen::Index i = 0; i < values_.size(); ++i)
    {
      const bool ends = (i + 1) % per_line == 0 || i + 1 == values_.size();
      std::printf("%s%.4g,%s", i % per_line == 0 ? "    " : " ", static_cast<double>(values_[i]), ends ? "\n" : "");
    }
  }

 private:
  Eigen::MatrixXf ramps(const Batch& batch)
  {
    return ((slopes(values_) * batch.inputs).colwise() + Eigen::VectorXf(offsets(values_))).cwiseMax(0);
  }

  Eigen::ArrayXf predicted(const Batch& batch, const Eigen::MatrixXf& ramp)
  {
    const Eigen::RowVectorXf at = heights(values_).transpose() * ramp + linear(values_).transpose() * batch.inputs;
    const auto others = rest(values_);
    Eigen::ArrayXf sum = others[1] + others[2] * batch.few;
    for (Eigen::Index c = 0; c < at.size(); ++c)
    {
      const int k = batch.contact[static_cast<std::size_t>(c)];
      sum[k] += batch.images[k] * (at[c] + others[0]);
    }
    return sum;
  }

  void adam(const Values& slope, double rate)
  {
    constexpr float kept = 0.9F, kept_square = 0.999F;
    mean_ = kept * mean_ + (1 - kept) * slope;
    square_ = kept_square * square_ + (1 - kept_square) * slope.cwiseAbs2();
    weight_ *= static_cast<double>(kept);
    weight_square_ *= static_cast<double>(kept_square);
    const auto scale = static_cast<float>(rate / (1 - weight_)),
               of_square = static_cast<float>(1 / (1 - weight_square_));
    values_ -= (scale * mean_.array() / ((of_square * square_.array()).sqrt() + 1e-9F)).matrix();
  }

  Values values_, mean_ = Values::Zero(), square_ = Values::Zero();
  double weight_ = 1, weight_square_ = 1;
};

Fit fit(const Samples& samples, int passes, unsigned long seed)
{
  constexpr std::size_t batch_size = 256;
  constexpr double first_rate = 4e-3, last_rate = 1e-5;
  std::vector<std::size_t> order(samples.count());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(seed);
  Fit fit(seed);
  for (int pass = 0; pass < passes; ++pass)
  {
    const double rate = last_rate + first_rate * 0.5 * (1 + std::cos(std::acos(-1.0) * pass / passes));
    std::shuffle(order.begin(), order.end(), random);
    double sum = 0;
    for (std::size_t begin = 0; begin < order.size(); begin += batch_size)
    {
      const auto count = static_cast<Eigen::Index>(std::min(batch_size, order.size() - begin));
      sum += static_cast<double>(fit.step(Batch(samples, order.data() + begin, count), rate).abs().sum());
    }
    std::fprintf(stderr, "\rpass %d of %d: %.4f cells left", pass + 1, passes, sum / static_cast<double>(order.size()));
  }
  std::fprintf(stderr, "\n");
  return fit;
}

void printErrors(const char* name, const Eigen::ArrayXf& errors)
{
  std::vector<double> sizes;
  for (const float error : errors)
  {
    sizes.push_back(std::abs(static_cast<double>(error)));
  }
  const double mean = std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
  std::printf("  %-16s mean %.3f, median %.3f, 90 %% %.3f, 98 %% %.3f cells\n", name, mean, chart::quantile(sizes, 0.5),
              chart::quantile(sizes, 0.9), chart::quantile(sizes, 0.98));
}

void printErrors(const char* name, const Samples& samples, Fit& fit)
{
  std::vector<std::size_t> all(samples.count());
  std::iota(all.begin(), all.end(), 0);
  const Batch batch(samples, all.data(), static_cast<Eigen::Index>(all.size()));
  std::printf("%s: %zu contacts, %zu crossings\n", name, samples.count(), samples.crossings.size());
  printErrors("the polygon", batch.excess);
  printErrors("present weights", Eigen::Map<const Eigen::ArrayXf>(samples.off.data(), batch.excess.size()));
  printErrors("these", fit.left(batch));
}
}  // namespace

int main(int argc, char** argv)
{
  const auto argument = [&](int index, long otherwise)
  { return argc > index ? std::strtol(argv[index], nullptr, 10) : otherwise; };
  const int wheelsets = static_cast<int>(argument(1, 1000)), hertz = static_cast<int>(argument(2, 12000));
  const auto seed = static_cast<unsigned long>(argument(3, 1));
  const Samples samples = collect(wheelsets, hertz, seed);
  Fit found = fit(samples, static_cast<int>(argument(4, 450)), seed);
  printErrors("these samples", samples, found);
  printErrors("wheelsets of the next seed", collect(wheelsets / 4, 0, seed + 1), found);
  printErrors("Hertz contacts of the next seed", collect(0, hertz / 4, seed + 1), found);
  found.print();
  return 0;
}
