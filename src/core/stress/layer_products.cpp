// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/layer_products.h"

#include <cmath>

#include "core/pi.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::array<int, 2> parities{0, 1};

/// Even (0) or odd (1) part of the lines of a field: column k is line half + k plus or minus line half - 1 - k.
Eigen::MatrixXd fold(const Eigen::MatrixXd& field, int half, int parity)
{
  const double sign = parity == 0 ? 1 : -1;
  Eigen::MatrixXd part = Eigen::MatrixXd::Zero(half, field.cols());
  part.topRows(field.rows() - half) = field.bottomRows(field.rows() - half);
  part += sign * field.topRows(half).colwise().reverse();
  return part;
}

/// Lines of a field from its even and odd parts.
Eigen::MatrixXd unfold(const Eigen::MatrixXd& even, const Eigen::MatrixXd& odd, Eigen::Index lines)
{
  const Eigen::Index half = even.rows();
  Eigen::MatrixXd field(lines, even.cols());
  field.topRows(half) = (even - odd).colwise().reverse();
  field.bottomRows(lines - half) = (even + odd).topRows(lines - half);
  return field;
}
}  // namespace

ParitySums::ParitySums(int cells) : cells_(cells), half_((cells + 1) / 2)
{
  const int length = 2 * half_;
  for (const int parity : parities)
  {
    const auto wave = [parity](double phase) { return parity == 0 ? std::cos(phase) : std::sin(phase); };
    Eigen::MatrixXd &modes = modes_[static_cast<std::size_t>(parity)],
                    &sums = kernel_sums_[static_cast<std::size_t>(parity)];
    modes.resize(half_, length + 1);
    sums.resize(cells_, length + 1);
    for (int m = 0; m <= length; ++m)
    {
      const double weight = (m == 0 || m == length ? 1.0 : 2.0) / (2 * length);
      for (int k = 0; k < half_; ++k)
      {
        modes(k, m) = wave(pi * m * (k + 0.5) / length);
      }
      for (int distance = 0; distance < cells_; ++distance)
      {
        sums(distance, m) = (distance == 0 ? 1 : 2) * weight * wave(pi * m * distance / length);
      }
    }
  }
}

LayerProducts::LayerProducts(const Eigen::ArrayXXd& field)
    : x_(static_cast<int>(field.rows())), y_(static_cast<int>(field.cols()))
{
  for (const int px : parities)
  {
    const Eigen::MatrixXd along = x_.modes(px).transpose() * fold(field.matrix(), x_.half(), px);
    for (const int py : parities)
    {
      field_modes_[static_cast<std::size_t>(px)][static_cast<std::size_t>(py)] =
          (y_.modes(py).transpose() * fold(along.transpose(), y_.half(), py)).transpose();
    }
  }
}

Eigen::ArrayXXd LayerProducts::product(const Eigen::ArrayXXd& kernel, Parity parity) const
{
  const Eigen::MatrixXd factors = x_.kernelSums(parity.x).transpose() * kernel.matrix() * y_.kernelSums(parity.y);
  std::array<Eigen::MatrixXd, 2> along;
  for (const int px : parities)
  {
    std::array<Eigen::MatrixXd, 2> across;
    for (const int py : parities)
    {
      // An odd kernel turns the cosine into the sine, and the sine into minus the cosine.
      const int from_x = px ^ parity.x, from_y = py ^ parity.y;
      const double sign = (parity.x == 1 && from_x == 1 ? -1 : 1) * (parity.y == 1 && from_y == 1 ? -1 : 1);
      const Eigen::MatrixXd modes =
          sign * factors.cwiseProduct(field_modes_[static_cast<std::size_t>(from_x)][static_cast<std::size_t>(from_y)]);
      across[static_cast<std::size_t>(py)] = y_.modes(py) * modes.transpose();
    }
    along[static_cast<std::size_t>(px)] = x_.modes(px) * unfold(across[0], across[1], y_.cells()).transpose();
  }
  return unfold(along[0], along[1], x_.cells()).array();
}
}  // namespace wheel_rail_contact::core
