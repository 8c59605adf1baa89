// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/QR>
#include <algorithm>

namespace wheel_rail_contact::core
{
/// Anderson mixing for a fixed point x = g(x) of N unknowns (Anderson 1965; Walker & Ni 2011, type II), with full
/// steps. For a single unknown it is the secant method.
template <int N>
class FixedPoint
{
 public:
  /// The unknowns.
  using Vector = Eigen::Matrix<double, N, 1>;

  /// Discards the previous steps.
  void reset() { known_ = 0; }

  /// Next x to try after g(x) was found to be `image`.
  Vector next(const Vector& x, const Vector& image)
  {
    const Vector residual = image - x;
    Vector step = residual;
    if (known_ > 0)
    {
      const int at = (known_ - 1) % depth;
      residual_change_.col(at) = residual - last_residual_;
      image_change_.col(at) = image - last_image_;
      const int used = std::min(known_, depth);
      const auto changes = residual_change_.leftCols(used);
      const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, depth, 1> weight =
          changes.colPivHouseholderQr().solve(residual);
      step -= image_change_.leftCols(used) * weight;
    }
    last_residual_ = residual;
    last_image_ = image;
    ++known_;
    return x + step;
  }

 private:
  static constexpr int depth = 2;  ///< number of stored steps
  Eigen::Matrix<double, N, depth> residual_change_ = Eigen::Matrix<double, N, depth>::Zero();
  Eigen::Matrix<double, N, depth> image_change_ = Eigen::Matrix<double, N, depth>::Zero();
  Vector last_residual_ = Vector::Zero();
  Vector last_image_ = Vector::Zero();
  int known_ = 0;  ///< steps since the last reset
};
}  // namespace wheel_rail_contact::core
