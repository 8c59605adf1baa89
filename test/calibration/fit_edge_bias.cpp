// SPDX-License-Identifier: BSD-3-Clause
// Fits the bias correction of the area of the edge polygon (core/normal/measures/edge_bias.h).
//
//   fit_edge_bias [wheelset scenes, default 1000] [Hertz contacts, default 12000] [seed, default 1]
//                 [passes, default 450]
//
// Minimises the mean of (error² + 0.05²)^1/2, with errors in cells, on settled_contacts.h. Prints the remaining errors
// on samples of the next seed (a quarter as many) and the weights in the format of edge_bias_weights.cpp. Takes about
// ten minutes; not part of the test run.
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "core/normal/measures/contact_edge.h"
#include "core/normal/measures/edge_bias.h"
#include "relu_fit.h"
#include "settled_contacts.h"

namespace
{
using namespace wheel_rail_contact::core;

/// Contacts with their crossings.
struct Samples
{
  std::vector<EdgeInputs> crossings;  ///< of all contacts
  std::vector<std::size_t> ends;      ///< end index of the crossings of each contact
  std::vector<float> images;          ///< of each contact: 2 if half of it is stored, otherwise 1
  std::vector<float> polygon;         ///< area of the polygon of the whole contact [cells]
  std::vector<int> islands;
  std::vector<float> bias;  ///< of the polygon [cells]
  std::vector<float> off;   ///< area by the present weights minus the true area [cells]

  std::size_t count() const { return ends.size(); }
  std::size_t begin(std::size_t contact) const { return contact > 0 ? ends[contact - 1] : 0; }
};

void add(const fits::Contact& contact, Samples& samples)
{
  const PatchPressure& patch = contact.found;
  const double images = patch.grid.symmetric ? 2 : 1;
  const double aspect = patch.grid.dx / patch.grid.dy, cells = contact.true_area / (patch.grid.dx * patch.grid.dy);
  EdgePolygon polygon;
  polygon.frame(patch.pressure, patch.grid.symmetric);
  samples.off.push_back(static_cast<float>(images * polygon.cells(aspect) - cells));
  const double chords = images * polygon.chords();
  samples.polygon.push_back(static_cast<float>(chords));
  samples.islands.push_back(polygon.islands());
  samples.bias.push_back(static_cast<float>(chords - cells));
  samples.images.push_back(static_cast<float>(images));
  for (const EdgeCrossing& crossing : polygon.crossings())
  {
    samples.crossings.push_back(edgeInputs(crossing, std::log(aspect)));
  }
  samples.ends.push_back(samples.crossings.size());
}

/// Several contacts together.
struct Batch
{
  Eigen::MatrixXf inputs;    ///< edge_inputs × crossings
  std::vector<int> contact;  ///< of each crossing
  Eigen::ArrayXf images;     ///< of each contact
  Eigen::ArrayXf islands;    ///< of each contact
  Eigen::ArrayXf few;        ///< islands over the cells of each island
  Eigen::ArrayXf bias;       ///< true bias

  Batch(const Samples& samples, const std::vector<std::size_t>& contacts)
      : images(static_cast<Eigen::Index>(contacts.size())),
        islands(images.size()),
        few(images.size()),
        bias(images.size())
  {
    EdgeBias of_few;
    of_few.few_cells = 1;
    for (Eigen::Index i = 0; i < images.size(); ++i)
    {
      const std::size_t k = contacts[static_cast<std::size_t>(i)];
      images[i] = samples.images[k];
      islands[i] = static_cast<float>(samples.islands[k]);
      few[i] = static_cast<float>(of_few.of(static_cast<double>(samples.polygon[k]), samples.islands[k]));
      bias[i] = samples.bias[k];
      contact.insert(contact.end(), samples.ends[k] - samples.begin(k), static_cast<int>(i));
    }
    inputs.resize(edge_inputs, static_cast<Eigen::Index>(contact.size()));
    Eigen::Index column = 0;
    for (const std::size_t k : contacts)
    {
      for (std::size_t c = samples.begin(k); c < samples.ends[k]; ++c)
      {
        inputs.col(column++) = samples.crossings[c].matrix();
      }
    }
  }
};

class Fit
{
  static constexpr float blunt = 0.05F;  ///< smaller errors count by their square [cells]

 public:
  explicit Fit(std::mt19937_64& random) : crossing_(random, 0.1) {}

  /// Remaining errors [cells].
  Eigen::ArrayXf left(const Batch& batch)
  {
    const Eigen::RowVectorXf at = crossing_.values(batch.inputs);
    Eigen::ArrayXf sum = contact_[0] * batch.islands + contact_[1] * batch.few - batch.bias;
    for (Eigen::Index c = 0; c < at.size(); ++c)
    {
      const int k = batch.contact[static_cast<std::size_t>(c)];
      sum[k] += batch.images[k] * at[c];
    }
    return sum;
  }

  /// Makes a step. Returns the errors before it [cells].
  Eigen::ArrayXf step(const Batch& batch, double rate)
  {
    const Eigen::ArrayXf errors = left(batch), pull = fits::pullOf(errors, blunt);
    Eigen::RowVectorXf at(batch.inputs.cols());
    for (Eigen::Index c = 0; c < at.size(); ++c)
    {
      const int k = batch.contact[static_cast<std::size_t>(c)];
      at[c] = pull[k] * batch.images[k];
    }
    crossing_.step(batch.inputs, at, rate);
    adam_.step({(pull * batch.islands).sum(), (pull * batch.few).sum()}, rate, contact_);
    return errors;
  }

  void print() const
  {
    Eigen::ArrayXf numbers(EdgeBias::numbers);
    numbers << crossing_.sum().all, contact_;
    fits::print(numbers);
  }

 private:
  fits::ReluFit<edge_inputs, EdgeBias::units> crossing_;
  Eigen::Array2f contact_ = Eigen::Array2f::Zero();  ///< island, few_cells
  fits::Adam<2> adam_;
};

void printErrors(const char* name, const Samples& samples, Fit& fit)
{
  const std::vector<std::size_t> all = fits::upTo(samples.count());
  const Batch batch(samples, all);
  std::printf("%s: %zu contacts, %zu crossings; errors in cells\n", name, samples.count(), samples.crossings.size());
  fits::printSizes("no correction", batch.bias);
  fits::printSizes("present weights", Eigen::Map<const Eigen::ArrayXf>(samples.off.data(), batch.bias.size()));
  fits::printSizes("new weights", fit.left(batch));
}
}  // namespace

int main(int argc, char** argv)
{
  const auto argument = [&](int index, long otherwise)
  { return argc > index ? std::strtol(argv[index], nullptr, 10) : otherwise; };
  const int wheelsets = static_cast<int>(argument(1, 1000)), hertz = static_cast<int>(argument(2, 12000));
  const auto seed = static_cast<unsigned long>(argument(3, 1));
  const Samples samples = fits::collect<Samples>({wheelsets, hertz, 0}, seed);
  std::mt19937_64 random(seed);
  Fit fit(random);
  fits::inBatches(samples.count(), static_cast<int>(argument(4, 450)), random,
                  [&](const std::vector<std::size_t>& batch, double rate)
                  { return fit.step(Batch(samples, batch), rate); });
  printErrors("samples of the fit", samples, fit);
  printErrors("wheelsets of the next seed", fits::collect<Samples>({wheelsets / 4, 0, 0}, seed + 1), fit);
  printErrors("Hertz contacts of the next seed", fits::collect<Samples>({0, hertz / 4, 0}, seed + 1), fit);
  fit.print();
  return 0;
}
