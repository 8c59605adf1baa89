// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace wheel_rail_contact::core
{
/// One-hidden-layer ReLU network plus a linear function, without constant terms. The output is homogeneous: scaling the
/// inputs by a positive factor scales the output by the same factor.
template <int Inputs, int Units>
struct ReluNetwork
{
  using Sums = Eigen::Array<float, Units, 1>;
  static constexpr int numbers = Units * (Inputs + 1) + Inputs;

  /// Weights of the hidden units by input, output weights of the units, weights of the linear function.
  Eigen::Array<float, numbers, 1> all;

  explicit ReluNetwork(const double* weights)
      : all(Eigen::Map<const Eigen::Array<double, numbers, 1>>(weights).template cast<float>())
  {
  }

  auto slopes() const { return Eigen::Map<const Eigen::Array<float, Units, Inputs>>(all.data()); }
  auto heights() const { return all.template segment<Units>(Units * Inputs); }
  auto linear() const { return all.template tail<Inputs>(); }

  /// Sums of the hidden units over the first inputs.
  template <int Count>
  Sums hidden(const Eigen::Array<float, Count, 1>& first) const
  {
    Sums sums = slopes().col(0) * first[0];
    for (int k = 1; k < Count; ++k)
    {
      sums += slopes().col(k) * first[k];
    }
    return sums;
  }

  float operator()(const Eigen::Array<float, Inputs, 1>& input) const
  {
    return (linear() * input).sum() + (heights() * hidden(input).max(0.0F)).sum();
  }
};

/// Crossing of the contact edge with a line of cell centres, between a loaded and an empty cell.
struct EdgeCrossing
{
  const double* loaded;     ///< pressure of the loaded cell; readable from one cell outward to two inward, also on the
                            ///< lines next to it
  std::ptrdiff_t outward;   ///< step to the empty cell
  std::ptrdiff_t sideways;  ///< step to the next line
  bool along;               ///< the line runs along x
};

/// Inputs of the edge network at a crossing. Pressures are relative to the largest of the loaded cell, the next one
/// inward and the neighbours of these two:
/// * three cells of the line, from the loaded one inward;
/// * for the empty cell and these three: mean of the pressures on the two neighbouring lines, then half of their
///   difference;
/// * half the logarithm of the cell extent along the line over that across it;
/// * one.
/// Empty cells count as 0, as does the third cell of a line behind an empty second one. Pressures are limited to 1.5,
/// the logarithm of the cell aspect to ±3.5.
constexpr int edge_inputs = 13;
using EdgeInputs = Eigen::Array<float, edge_inputs, 1>;

/// @param longer  logarithm of the cell length along x over the cell width
EdgeInputs edgeInputs(const EdgeCrossing& crossing, double longer);

/// Bias of the area of a polygon through the edge crossings (EdgePolygon). A one-hidden-layer ReLU network evaluated at
/// each crossing, and a constant for each island of the contact.
struct EdgeBias
{
  static constexpr int units = 16;
  using Crossing = ReluNetwork<edge_inputs, units>;
  static constexpr int numbers = Crossing::numbers + 2;  ///< all weights below

  Crossing crossing;    ///< for every crossing [cells]
  float island = 0;     ///< for every island [cells]
  float few_cells = 0;  ///< for every island, times its area [cells²]

  /// Bias of a contact of `polygon` cells on several islands, assumed equal, without the part of the crossings [cells].
  double of(double polygon, int islands) const;
};

/// Weights in use. Fitted by test/calibration/fit_edge_bias.cpp in revision e6707df.
const EdgeBias& edgeBias();
}  // namespace wheel_rail_contact::core
