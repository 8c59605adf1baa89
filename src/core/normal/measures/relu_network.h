// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace wheel_rail_contact::core
{
/// One-hidden-layer ReLU network plus a linear function, without constant terms. The output is homogeneous: scaling the
/// inputs by a positive factor scales the output by the same factor.
template <int Inputs, int Units>
struct ReluNetwork
{
  using Input = Eigen::Array<float, Inputs, 1>;
  static constexpr int numbers = Units * (Inputs + 1) + Inputs;

  /// Weights of the hidden units by input, output weights of the units, weights of the linear function.
  Eigen::Array<float, numbers, 1> all;

  auto slopes() const { return Eigen::Map<const Eigen::Array<float, Units, Inputs>>(all.data()); }
  auto heights() const { return all.template segment<Units>(Units * Inputs); }
  auto linear() const { return all.template tail<Inputs>(); }

  float operator()(const Input& input) const
  {
    Eigen::Array<float, Units, 1> unit = slopes().col(0) * input[0];
    for (int k = 1; k < Inputs; ++k)
    {
      unit += slopes().col(k) * input[k];
    }
    return (linear() * input).sum() + (heights() * unit.max(0.0F)).sum();
  }
};
}  // namespace wheel_rail_contact::core
