// SPDX-License-Identifier: BSD-3-Clause
// Fits the bias correction of the area near curvature discontinuities (core/normal/measures/discontinuity_bias.h).
//
//   fit_discontinuity_bias [wheelset scenes, default 2000] [gaps, default 12000] [seed, default 1] [passes, default 60]
//
// Minimises the mean of (error² + 0.05²)^1/2, with errors in cells, on wheelsets and gaps with discontinuities
// (settled_contacts.h). The weights of EdgeBias are kept. Prints the remaining errors on samples of the next seed (a
// quarter as many) and the weights in the format of discontinuity_bias_weights.cpp. Takes about twelve minutes; not
// part of the test run.
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "core/normal/measures/discontinuity_bias.h"
#include "relu_fit.h"
#include "settled_contacts.h"

namespace
{
using namespace wheel_rail_contact::core;

/// Crossings of one kind of line with steps, of all contacts.
struct Discontinuities
{
  std::vector<EdgeInputs> inputs;
  std::vector<EdgeSteps> steps;
  std::vector<std::size_t> ends;  ///< end index of the crossings of each contact

  std::size_t begin(std::size_t contact) const { return contact > 0 ? ends[contact - 1] : 0; }
};

/// Contacts with such crossings.
struct Samples
{
  Discontinuities along, across;
  std::vector<float> images;  ///< of each contact: 2 if half of it is stored, otherwise 1
  std::vector<float> bias;    ///< of the area without this correction [cells]
  std::vector<float> off;     ///< area by the present weights minus the true area [cells]

  std::size_t count() const { return images.size(); }
};

void add(const fits::Contact& contact, Samples& samples)
{
  const PatchPressure& patch = contact.found;
  const double aspect = patch.grid.dx / patch.grid.dy, cell = patch.grid.dx * patch.grid.dy;
  EdgePolygon polygon;
  polygon.frame(patch.pressure, patch.grid.symmetric);
  const double images = patch.grid.symmetric ? 2 : 1, area = images * polygon.cells(aspect);
  const EdgeOf edge{polygon, contact.gap, contact.modulus, patch.max_pressure};
  bool any = false;
  visitEdgeDiscontinuities(edge,
                           [&](const EdgeCrossing& crossing, const EdgeInputs& inputs, const EdgeSteps& steps)
                           {
                             Discontinuities& discontinuities = crossing.along ? samples.along : samples.across;
                             discontinuities.inputs.push_back(inputs);
                             discontinuities.steps.push_back(steps);
                             any = true;
                           });
  if (any)
  {
    samples.along.ends.push_back(samples.along.inputs.size());
    samples.across.ends.push_back(samples.across.inputs.size());
    samples.images.push_back(static_cast<float>(images));
    samples.bias.push_back(static_cast<float>(area - contact.true_area / cell));
    samples.off.push_back(static_cast<float>((patch.area - contact.true_area) / cell));
  }
}

/// Crossings of several contacts: first with their steps, then without.
struct Crossings
{
  Eigen::MatrixXf inputs;    ///< DiscontinuityBias::inputs × twice the crossings
  std::vector<int> contact;  ///< of each crossing

  Crossings(const Discontinuities& discontinuities, const std::vector<std::size_t>& contacts)
  {
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
      contact.insert(contact.end(), discontinuities.ends[contacts[i]] - discontinuities.begin(contacts[i]),
                     static_cast<int>(i));
    }
    const auto count = static_cast<Eigen::Index>(contact.size());
    inputs.setZero(DiscontinuityBias::inputs, 2 * count);
    Eigen::Index column = 0;
    for (const std::size_t k : contacts)
    {
      for (std::size_t c = discontinuities.begin(k); c < discontinuities.ends[k]; ++c, ++column)
      {
        inputs.col(column).head<edge_inputs>() = discontinuities.inputs[c].matrix();
        inputs.col(column).tail<edge_steps>() = discontinuities.steps[c].matrix();
        inputs.col(count + column).head<edge_inputs>() = discontinuities.inputs[c].matrix();
      }
    }
  }
};

class Fit
{
  static constexpr float blunt = 0.05F;  ///< smaller errors count by their square [cells]
  using Units = fits::ReluFit<DiscontinuityBias::inputs, DiscontinuityBias::units>;

 public:
  explicit Fit(std::mt19937_64& random) : along_(random, 0.1), across_(random, 0.1) {}

  /// Remaining errors [cells].
  Eigen::ArrayXf left(const Samples& samples, const std::vector<std::size_t>& contacts)
  {
    return leftOf(samples, contacts, Crossings(samples.along, contacts), Crossings(samples.across, contacts));
  }

  /// Makes a step. Returns the errors before it [cells].
  Eigen::ArrayXf step(const Samples& samples, const std::vector<std::size_t>& contacts, double rate)
  {
    const Crossings along(samples.along, contacts), across(samples.across, contacts);
    Eigen::ArrayXf errors = leftOf(samples, contacts, along, across);
    Eigen::ArrayXf pull = fits::pullOf(errors, blunt);
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
      pull[static_cast<Eigen::Index>(i)] *= samples.images[contacts[i]];
    }
    step(along, pull, rate, along_);
    step(across, pull, rate, across_);
    return errors;
  }

  void print() const
  {
    Eigen::ArrayXf numbers(DiscontinuityBias::numbers);
    numbers << along_.sum().all, across_.sum().all;
    fits::print(numbers);
  }

 private:
  Eigen::ArrayXf leftOf(const Samples& samples, const std::vector<std::size_t>& contacts, const Crossings& along,
                        const Crossings& across)
  {
    Eigen::ArrayXf sums = Eigen::ArrayXf::Zero(static_cast<Eigen::Index>(contacts.size()));
    addTo(sums, along, along_);
    addTo(sums, across, across_);
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
      float& sum = sums[static_cast<Eigen::Index>(i)];
      sum = samples.images[contacts[i]] * sum - samples.bias[contacts[i]];
    }
    return sums;
  }

  static void addTo(Eigen::ArrayXf& sums, const Crossings& crossings, Units& units)
  {
    const Eigen::RowVectorXf values = units.values(crossings.inputs);
    const auto count = static_cast<Eigen::Index>(crossings.contact.size());
    for (Eigen::Index c = 0; c < count; ++c)
    {
      sums[crossings.contact[static_cast<std::size_t>(c)]] += values[c] - values[count + c];
    }
  }

  static void step(const Crossings& crossings, const Eigen::ArrayXf& pull, double rate, Units& units)
  {
    const auto count = static_cast<Eigen::Index>(crossings.contact.size());
    Eigen::RowVectorXf at(2 * count);
    for (Eigen::Index c = 0; c < count; ++c)
    {
      at[c] = pull[crossings.contact[static_cast<std::size_t>(c)]];
    }
    at.tail(count) = -at.head(count);
    units.step(crossings.inputs, at, rate);
  }

  Units along_, across_;
};

void printErrors(const char* name, const Samples& samples, Fit& fit)
{
  const std::vector<std::size_t> all = fits::upTo(samples.count());
  const auto count = static_cast<Eigen::Index>(all.size());
  std::printf("%s: %td contacts, %zu crossings; errors in cells\n", name, count,
              samples.along.inputs.size() + samples.across.inputs.size());
  fits::printSizes("no correction", Eigen::Map<const Eigen::ArrayXf>(samples.bias.data(), count));
  fits::printSizes("present weights", Eigen::Map<const Eigen::ArrayXf>(samples.off.data(), count));
  fits::printSizes("new weights", fit.left(samples, all));
}
}  // namespace

int main(int argc, char** argv)
{
  const auto argument = [&](int index, long otherwise)
  { return argc > index ? std::strtol(argv[index], nullptr, 10) : otherwise; };
  const int wheelsets = static_cast<int>(argument(1, 2000)), gaps = static_cast<int>(argument(2, 12000));
  const auto seed = static_cast<unsigned long>(argument(3, 1));
  const Samples samples = fits::collect<Samples>({wheelsets, 0, 0, gaps}, seed);
  std::mt19937_64 random(seed);
  Fit fit(random);
  fits::inBatches(samples.count(), static_cast<int>(argument(4, 60)), random,
                  [&](const std::vector<std::size_t>& batch, double rate) { return fit.step(samples, batch, rate); });
  printErrors("samples of the fit", samples, fit);
  printErrors("wheelsets of the next seed", fits::collect<Samples>({wheelsets / 4, 0, 0, 0}, seed + 1), fit);
  printErrors("gaps of the next seed", fits::collect<Samples>({0, 0, 0, gaps / 4}, seed + 1), fit);
  fit.print();
  return 0;
}
