// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace wheel_rail_contact::core
{
/// A linear function of a few inputs and a sum of ramps, max(0, another linear function) (a network with one layer of
/// rectified units): with its inputs it grows in proportion.
template <int Inputs, int Units>
struct ReluNetwork
{
  using Input = Eigen::Array<float, Inputs, 1>;
  static constexpr int numbers = Units * (Inputs + 1) + Inputs;

  /// The ramps' slopes by input, their heights, the linear function.
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
