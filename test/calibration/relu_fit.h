// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>
#include <vector>

#include "chart/quantile.h"
#include "core/normal/measures/relu_network.h"

/// Fits of one-hidden-layer ReLU networks (core/normal/measures/relu_network.h) in small batches.
namespace wheel_rail_contact::core::fits
{
/// Steps of Adam's method (Kingma and Ba 2015).
template <int Size>
class Adam
{
 public:
  using Values = Eigen::Array<float, Size, 1>;

  /// @param slope  gradient of the mean error
  void step(const Values& slope, double rate, Values& values)
  {
    constexpr float kept = 0.9F, kept_square = 0.999F;
    mean_ = kept * mean_ + (1 - kept) * slope;
    square_ = kept_square * square_ + (1 - kept_square) * slope.square();
    weight_ *= static_cast<double>(kept);
    weight_square_ *= static_cast<double>(kept_square);
    const auto scale = static_cast<float>(rate / (1 - weight_)),
               of_square = static_cast<float>(1 / (1 - weight_square_));
    values -= scale * mean_ / ((of_square * square_).sqrt() + 1e-9F);
  }

 private:
  Values mean_ = Values::Zero(), square_ = Values::Zero();
  double weight_ = 1, weight_square_ = 1;
};

template <int Inputs, int Units>
class ReluFit
{
 public:
  using Sum = ReluNetwork<Inputs, Units>;

  /// @param height  scale of the first output weights
  ReluFit(std::mt19937_64& random, double height)
  {
    std::normal_distribution<float> normal;
    const auto fill = [&](auto&& block, double scale)
    { block = block.unaryExpr([&](float) { return static_cast<float>(scale) * normal(random); }); };
    sum_.all.setZero();
    fill(sum_.all.template head<Units * Inputs>(), std::sqrt(2.0 / Inputs));
    fill(sum_.all.template segment<Units>(Units * Inputs), height / std::sqrt(Units));
  }

  const Sum& sum() const { return sum_; }

  /// One output value for each column of inputs.
  Eigen::RowVectorXf values(const Eigen::MatrixXf& inputs)
  {
    units_ = (sum_.slopes().matrix() * inputs).cwiseMax(0);
    return sum_.heights().matrix().transpose() * units_ + sum_.linear().matrix().transpose() * inputs;
  }

  /// @param inputs  those of the last values()
  /// @param pull    derivative of the mean error by each value
  void step(const Eigen::MatrixXf& inputs, const Eigen::RowVectorXf& pull, double rate)
  {
    const Eigen::MatrixXf rising =
        ((sum_.heights().matrix() * pull).array() * (units_.array() > 0).template cast<float>()).matrix();
    typename Adam<Sum::numbers>::Values slope;
    Eigen::Map<Eigen::Matrix<float, Units, Inputs>>(slope.data()) = rising * inputs.transpose();
    slope.template segment<Units>(Units * Inputs) = units_ * pull.transpose();
    slope.template tail<Inputs>() = inputs * pull.transpose();
    adam_.step(slope, rate, sum_.all);
  }

 private:
  Sum sum_;
  Adam<Sum::numbers> adam_;
  Eigen::MatrixXf units_;
};

/// Derivative of the mean of (error² + blunt²)^1/2 by each error.
inline Eigen::ArrayXf pullOf(const Eigen::ArrayXf& errors, float blunt)
{
  return errors / (errors.square() + blunt * blunt).sqrt() / static_cast<float>(errors.size());
}

/// 0 … count - 1.
inline std::vector<std::size_t> upTo(std::size_t count)
{
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

/// Calls `step(indices, rate)`, which returns the remaining errors, for batches of 0 … count - 1 in random order.
/// Repeats this for several passes, with rates that decrease as a cosine.
template <typename Step>
void inBatches(std::size_t count, int passes, std::mt19937_64& random, Step step)
{
  constexpr std::size_t batch_size = 256;
  constexpr double first_rate = 4e-3, last_rate = 1e-5;
  std::vector<std::size_t> order = upTo(count);
  for (int pass = 0; pass < passes; ++pass)
  {
    const double rate = last_rate + first_rate * 0.5 * (1 + std::cos(std::acos(-1.0) * pass / passes));
    std::shuffle(order.begin(), order.end(), random);
    double sum = 0;
    for (std::size_t begin = 0; begin < count; begin += batch_size)
    {
      const std::vector<std::size_t> batch(order.data() + begin, order.data() + std::min(begin + batch_size, count));
      sum += static_cast<double>(step(batch, rate).abs().sum());
    }
    std::fprintf(stderr, "\rpass %d of %d: mean remaining error %.4f", pass + 1, passes,
                 sum / static_cast<double>(count));
  }
  std::fprintf(stderr, "\n");
}

inline void printSizes(const char* name, const Eigen::ArrayXf& errors)
{
  std::vector<double> sizes;
  for (Eigen::Index i = 0; i < errors.size(); ++i)
  {
    sizes.push_back(std::abs(static_cast<double>(errors[i])));
  }
  const double mean = std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
  std::printf("  %-16s mean %.3f, median %.3f, 90 %% %.3f, 98 %% %.3f\n", name, mean, chart::quantile(sizes, 0.5),
              chart::quantile(sizes, 0.9), chart::quantile(sizes, 0.98));
}

/// Prints the weights in the format of the sources.
inline void print(const Eigen::ArrayXf& numbers)
{
  constexpr Eigen::Index per_line = 12;
  for (Eigen::Index i = 0; i < numbers.size(); ++i)
  {
    const bool ends = (i + 1) % per_line == 0 || i + 1 == numbers.size();
    std::printf("%s%.4g,%s", i % per_line == 0 ? "    " : " ", static_cast<double>(numbers[i]), ends ? "\n" : "");
  }
}
}  // namespace wheel_rail_contact::core::fits
