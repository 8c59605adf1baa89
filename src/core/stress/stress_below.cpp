// SPDX-License-Identifier: BSD-3-Clause
// Stress below the pressure on a grid.
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <string>

#include "core/constants.h"
#include "core/option_check.h"
#include "wheel_rail_contact/core/stress.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double half_over_pi = 0.5 / pi;
constexpr std::array<int, 2> parities{0, 1};

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

/// Stress below one corner of a quadrant of unit pressure, as a function of the offset from the corner [-].
///
/// The stress by a unit pressure on the rectangle x1 < x < x2, y1 < y < y2 is the sum over its corners, with the signs
/// of a double difference:
///
///     f(X - x1, Y - y1) - f(X - x2, Y - y1) - f(X - x1, Y - y2) + f(X - x2, Y - y2)
///
/// The functions are the second derivatives of Boussinesq's potentials V (Newtonian) and chi (logarithmic) over a
/// rectangle (Love 1929, sec. 3 and 5; Johnson 1985, eq. 3.1 to 3.3):
///
///     2 pi xx = 2 nu V_z - (1 - 2 nu) chi_xx - z V_xx,   2 pi zz = V_z - z V_zz,   2 pi xz = -z V_xz,
///     2 pi xy = -(1 - 2 nu) chi_xy - z V_xy
///
/// @param x, y  offset of the point from the corner [m]
/// @param z     depth [m], >= 0; not all three may be zero
Stress cornerStress(double x, double y, double z, double poisson)
{
  const double xx = x * x, yy = y * y, zz = z * z;
  const double r = std::sqrt(xx + yy + zz);
  // At the surface the limits z -> 0 of the terms with z are zero, also above the axes through the corner.
  const double z_xz = zz > 0 ? z / (xx + zz) : 0, z_yz = zz > 0 ? z / (yy + zz) : 0;  // z over (x² + z²) and (y² + z²)
  const double product = x * y / r;
  const double v_z = -std::atan2(x * y, z * r);
  const double chi_xx = std::atan2(x * y * (r - z), xx * r + z * yy);
  const double chi_yy = -v_z - chi_xx;
  const double bulk = 1 - 2 * poisson;
  Stress s;
  s.xx = half_over_pi * (2 * poisson * v_z - bulk * chi_xx + product * z_xz);
  s.yy = half_over_pi * (2 * poisson * v_z - bulk * chi_yy + product * z_yz);
  s.zz = half_over_pi * (v_z - product * (z_xz + z_yz));
  s.xz = half_over_pi * y * z * z_xz / r;
  s.yz = half_over_pi * x * z * z_yz / r;
  s.xy = -half_over_pi * (bulk * std::log(r + z) + z / r);
  return s;
}

void requireStressInput(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson)
{
  refuseIf(pressure.rows() != grid.nx || pressure.cols() != grid.ny,
           "pressure has " + std::to_string(pressure.rows()) + " x " + std::to_string(pressure.cols()) +
               " values, the grid has " + std::to_string(grid.nx) + " x " + std::to_string(grid.ny) +
               " cells: both must be equal");
  refuseIf(!pressure.allFinite(), "pressure has values that are not finite: all must be finite");
  requirePositive("dx", grid.dx);
  requirePositive("dy", grid.dy);
  require(poisson > -1 && poisson <= 0.5, "poisson", poisson, "must be above -1 and at most 0.5");
}

void requireDepth(double depth)
{
  require(std::isfinite(depth) && depth >= 0, "depth", depth, "must be finite and at least 0");
}

void add(double factor, const Stress& part, Stress& sum)
{
  sum.xx += factor * part.xx;
  sum.yy += factor * part.yy;
  sum.zz += factor * part.zz;
  sum.yz += factor * part.yz;
  sum.xz += factor * part.xz;
  sum.xy += factor * part.xy;
}

/// Components of a stress in the order of StressLayer, and their parities along x and y.
constexpr std::array<double Stress::*, 6> components{&Stress::xx, &Stress::yy, &Stress::zz,
                                                     &Stress::yz, &Stress::xz, &Stress::xy};
constexpr std::array<LayerProducts::Parity, 6> component_parities{{{0, 0}, {0, 0}, {0, 0}, {0, 1}, {1, 0}, {1, 1}}};

using Kernels = std::array<Eigen::ArrayXXd, 6>;

/// Stress by a unit pressure on a cell, at the distances 0 … nx - 1 and 0 … ny - 1 from its centre [-].
Kernels kernelsAt(const PatchGrid& grid, double poisson, double depth)
{
  Kernels corners, kernels;
  corners.fill(Eigen::ArrayXXd(grid.nx + 1, grid.ny + 1));
  for (int j = 0; j <= grid.ny; ++j)
  {
    for (int i = 0; i <= grid.nx; ++i)
    {
      const Stress stress = cornerStress((i - 0.5) * grid.dx, (j - 0.5) * grid.dy, depth, poisson);
      for (std::size_t c = 0; c < components.size(); ++c)
      {
        corners[c](i, j) = stress.*components[c];
      }
    }
  }
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const Eigen::ArrayXXd along = corners[c].bottomRows(grid.nx) - corners[c].topRows(grid.nx);
    kernels[c] = along.rightCols(grid.ny) - along.leftCols(grid.ny);
  }
  return kernels;
}
}  // namespace

Stress stressAt(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson, const Eigen::Vector3d& point)
{
  requireStressInput(grid, pressure, poisson);
  requireDepth(point.z());
  require(std::isfinite(point.x()), "x", point.x(), "must be finite");
  require(std::isfinite(point.y()), "y", point.y(), "must be finite");
  const auto at = [&](int row, int column)
  { return row >= 0 && row < grid.nx && column >= 0 && column < grid.ny ? pressure(row, column) : 0.0; };
  Stress sum;
  for (int j = 0; j <= grid.ny; ++j)
  {
    for (int i = 0; i <= grid.nx; ++i)
    {
      // Each corner belongs to up to four cells. Most differences are zero outside of the contact.
      const double jump = at(i, j) - at(i - 1, j) - at(i, j - 1) + at(i - 1, j - 1);
      if (jump != 0)
      {
        const Eigen::Vector3d corner(grid.x(i) - 0.5 * grid.dx, grid.y(j) - 0.5 * grid.dy, 0), offset = point - corner;
        refuseIf(offset.squaredNorm() == 0, "depth = 0: must be above 0 at a corner of a cell, where xy is infinite");
        add(jump, cornerStress(offset.x(), offset.y(), offset.z(), poisson), sum);
      }
    }
  }
  return sum;
}

std::vector<StressLayer> stressLayers(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson,
                                      const std::vector<double>& depths)
{
  requireStressInput(grid, pressure, poisson);
  const LayerProducts products(pressure);
  std::vector<StressLayer> layers;
  layers.reserve(depths.size());
  for (const double depth : depths)
  {
    requireDepth(depth);
    const Kernels kernels = kernelsAt(grid, poisson, depth);
    StressLayer& layer = layers.emplace_back();
    layer.depth = depth;
    for (std::size_t c = 0; c < components.size(); ++c)
    {
      layer.components[c] = products.product(kernels[c], component_parities[c]);
    }
  }
  return layers;
}
}  // namespace wheel_rail_contact::core
