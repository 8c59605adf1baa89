// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

namespace wheel_rail_contact::core
{
/// Cosine and sine sums along one direction of a grid, on the modes of a grid of twice the length (zero padding).
///
/// The n = 2 h cells (the last one is empty if their number is odd) have their centres at ±(k + 1/2), k < h. The even
/// part of a field has the modes cos(pi m (k + 1/2) / n), the odd part sin(pi m (k + 1/2) / n), m = 0 … n.
class ParitySums
{
 public:
  explicit ParitySums(int cells);

  int cells() const { return cells_; }
  int half() const { return half_; }
  /// Values of the modes of a parity (0 even, 1 odd): half × modes.
  const Eigen::MatrixXd& modes(int parity) const { return modes_[static_cast<std::size_t>(parity)]; }
  /// Factors that transform a kernel of a parity, given at the distances 0 … cells - 1: cells × modes. They include the
  /// weights of the inverse transform.
  const Eigen::MatrixXd& kernelSums(int parity) const { return kernel_sums_[static_cast<std::size_t>(parity)]; }

 private:
  int cells_, half_;
  std::array<Eigen::MatrixXd, 2> modes_, kernel_sums_;
};

/// Products of a field on a grid with kernels that depend on the distances of the cells along x and y, and are even or
/// odd in each of them: the discrete convolution, exact.
class LayerProducts
{
 public:
  /// Parity of a kernel along x and y: 0 even, 1 odd.
  struct Parity
  {
    int x = 0, y = 0;
  };

  explicit LayerProducts(const Eigen::ArrayXXd& field);

  /// Sum over all cells of kernel(distance of the result's cell from the field's cell) * field.
  /// @param kernel  at the distances 0 … nx - 1 and 0 … ny - 1, same shape as the field
  Eigen::ArrayXXd product(const Eigen::ArrayXXd& kernel, Parity parity) const;

 private:
  ParitySums x_, y_;
  std::array<std::array<Eigen::MatrixXd, 2>, 2> field_modes_;
};
}  // namespace wheel_rail_contact::core
