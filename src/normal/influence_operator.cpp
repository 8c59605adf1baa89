// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/normal/influence_operator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "cosine_modes.h"
#include "lanes.h"

namespace wheel_rail_contact
{
namespace
{
const double kPi = std::acos(-1.0);

void check(const OperatorShape& shape)
{
  if (shape.nx < 2 || shape.ny < 2)
  {
    throw std::invalid_argument("grid = " + std::to_string(shape.nx) + " x " + std::to_string(shape.ny) +
                                ": must have at least 2 cells each way");
  }
  if (shape.symmetric && shape.nx % 2 != 0)
  {
    throw std::invalid_argument("nx = " + std::to_string(shape.nx) + ": must be even on a symmetric grid");
  }
  if (!(shape.aspect > 0) || !std::isfinite(shape.aspect))
  {
    throw std::invalid_argument("aspect = " + std::to_string(shape.aspect) + ": must be positive and finite");
  }
}

/// Cosine transform of a kernel given at 0 … length on the period 2 length, both ways: [mode_y][mode_x].
class Spectrum
{
 public:
  Spectrum(const std::vector<double>& kernel, int kernel_stride, int length_x, int length_y)
      : length_x_(length_x), values_(static_cast<std::size_t>((length_x + 1) * (length_y + 1)))
  {
    const std::vector<double> cosines_x = cosines(length_x), cosines_y = cosines(length_y);
    std::vector<double> half(values_.size());
    for (int n = 0; n <= length_y; ++n)
    {
      for (int a = 0; a <= length_x; ++a)
      {
        double sum = 0;
        for (int m = 0; m <= length_x; ++m)
        {
          sum += cosines_x[at(m, a)] * kernel[static_cast<std::size_t>(n * kernel_stride + m)];
        }
        half[at(a, n)] = sum;
      }
    }
    for (int b = 0; b <= length_y; ++b)
    {
      for (int n = 0; n <= length_y; ++n)
      {
        const double cosine = cosines_y[static_cast<std::size_t>(b * (length_y + 1) + n)];
        for (int a = 0; a <= length_x; ++a)
        {
          values_[at(a, b)] += cosine * half[at(a, n)];
        }
      }
    }
  }

  double operator()(int a, int b) const { return values_[at(a, b)]; }

 private:
  /// cos(pi a m / length) times 2, or 1 for m = 0 and m = length, which the period holds once: [a][m].
  static std::vector<double> cosines(int length)
  {
    std::vector<double> table;
    table.reserve(static_cast<std::size_t>((length + 1) * (length + 1)));
    for (int a = 0; a <= length; ++a)
    {
      for (int m = 0; m <= length; ++m)
      {
        const double times = m == 0 || m == length ? 1 : 2;
        table.push_back(times * std::cos(kPi * (a * m % (2 * length)) / length));
      }
    }
    return table;
  }

  std::size_t at(int a, int b) const { return static_cast<std::size_t>(b * (length_x_ + 1) + a); }

  int length_x_;
  std::vector<double> values_;
};

/// Share of a mode in the inverse transform over a period of 2 length.
double modeWeight(int mode, int length)
{
  return (mode == 0 || mode == length ? 1.0 : 2.0) / (2 * length);
}
}  // namespace

struct InfluenceOperator::Workspace::Buffers
{
  LaneBuffer folded, across, both;
  int folded_size = 0, across_size = 0, both_size = 0;
};

InfluenceOperator::Workspace::Workspace() : buffers_(std::make_unique<Buffers>()) {}
InfluenceOperator::Workspace::~Workspace() = default;
InfluenceOperator::Workspace::Workspace(Workspace&&) noexcept = default;
InfluenceOperator::Workspace& InfluenceOperator::Workspace::operator=(Workspace&&) noexcept = default;

struct InfluenceOperator::Tables
{
  /// Modes kept of both directions and their factors: [parity x][mode x][parity y][mode y, padded].
  struct Diagonal
  {
    int modes_x = 0, modes_y = 0;
    int line = 0;  ///< doubles of one row's modes across, both parities
    LaneBuffer factors;
  };

  explicit Tables(const OperatorShape& wanted);

  std::vector<double> coefficients() const;
  void fill(Diagonal& diagonal, const Spectrum& spectrum, bool inverted) const;
  void apply(const Diagonal& diagonal, const double* in, double* out, Workspace::Buffers& buffers) const;
  void toModesAcross(const Diagonal& diagonal, const double* folded, double* out) const;
  void scaleModesAlong(const Diagonal& diagonal, int parity, double* across, double* scratch) const;
  void fromModesAcross(const Diagonal& diagonal, const double* in, double* folded) const;

  int rows() const { return x_parts * x.half; }
  int fieldSize() const { return rows() * 2 * y.value_stride; }

  OperatorShape shape;
  int x_parts;  ///< stored halves along: 1 on a symmetric grid, else 2
  CosineModes x, y;
  LaneBuffer sign_along;  ///< (-1)^row over half the field
  Diagonal product, inverse;
  LaneBuffer probe,
      probe_product;  ///< uneven weights of the cells, and the product with them
};

InfluenceOperator::Tables::Tables(const OperatorShape& wanted)
    : shape(wanted), x_parts(wanted.symmetric ? 1 : 2), x((wanted.nx + 1) / 2), y((wanted.ny + 1) / 2)
{
  sign_along.resize(x.half * 2 * y.value_stride);
  for (int i = 0; i < x.half; ++i)
  {
    std::fill_n(sign_along.data() + i * 2 * y.value_stride, 2 * y.value_stride, x.sign[i]);
  }
  const std::vector<double> kernel = coefficients();
  product.modes_x = x.count;
  product.modes_y = y.count;
  fill(product, Spectrum(kernel, x.count + 1, x.count, y.count), false);
  inverse.modes_x = x.half;
  inverse.modes_y = y.half;
  fill(inverse, Spectrum(kernel, x.count + 1, x.half, y.half), true);
}

std::vector<double> InfluenceOperator::Tables::coefficients() const
{
  std::vector<double> kernel;
  kernel.reserve(static_cast<std::size_t>((x.count + 1) * (y.count + 1)));
  for (int n = 0; n <= y.count; ++n)
  {
    for (int m = 0; m <= x.count; ++m)
    {
      kernel.push_back(influence(shape.kernel, m * shape.aspect, n, shape.aspect, 1));
    }
  }
  return kernel;
}

void InfluenceOperator::Tables::fill(Diagonal& diagonal, const Spectrum& spectrum, bool inverted) const
{
  const int step = x.count / diagonal.modes_x;  // of the doubled period's modes: 1, or 2 for
                                                // the grid's own period
  const int stride = roundUpToLanes(diagonal.modes_y);
  diagonal.line = 2 * stride;
  diagonal.factors.resize(x_parts * diagonal.modes_x * diagonal.line);
  double* factor = diagonal.factors.data();
  for (int px = 0; px < x_parts; ++px)
  {
    for (int a = 0; a < diagonal.modes_x; ++a)
    {
      for (int py = 0; py < 2; ++py, factor += stride)
      {
        for (int b = 0; b < diagonal.modes_y; ++b)
        {
          const int mode_x = x.number(px, a) / step, mode_y = y.number(py, b) / step;
          const double weight = modeWeight(mode_x, diagonal.modes_x) * modeWeight(mode_y, diagonal.modes_y);
          const double value = spectrum(mode_x, mode_y);
          factor[b] = (shape.symmetric ? 2 : 1) * weight * (inverted ? 1 / value : value);
        }
      }
    }
  }
}

void InfluenceOperator::Tables::apply(const Diagonal& diagonal, const double* in, double* out,
                                      Workspace::Buffers& buffers) const
{
  const LaneKernels& kernels = laneKernels();
  double* folded = buffers.folded.data();
  kernels.fold(rows(), y.value_stride, y.sign.data(), in, folded);
  if (x_parts == 2)
  {
    kernels.fold(1, fieldSize() / 2, sign_along.data(), folded, folded);
  }
  toModesAcross(diagonal, folded, buffers.across.data());
  for (int px = 0; px < x_parts; ++px)
  {
    scaleModesAlong(diagonal, px, buffers.across.data(), buffers.both.data());
  }
  fromModesAcross(diagonal, buffers.across.data(), folded);
  if (x_parts == 2)
  {
    kernels.unfold(1, fieldSize() / 2, sign_along.data(), folded, folded);
  }
  kernels.unfold(rows(), y.value_stride, y.sign.data(), folded, out);
}

void InfluenceOperator::Tables::toModesAcross(const Diagonal& diagonal, const double* folded, double* out) const
{
  LaneProduct sums;
  sums.lanes = diagonal.line / 2;
  sums.inner = y.half;
  sums.columns = 2 * rows();
  sums.a = y.by_mode.data();
  sums.a_stride = y.mode_stride;
  sums.b = folded;
  sums.b_inner = 1;
  sums.b_column = y.value_stride;
  sums.out = out;
  sums.out_stride = diagonal.line / 2;
  laneKernels().multiply(sums);
}

void InfluenceOperator::Tables::scaleModesAlong(const Diagonal& diagonal, int parity, double* across,
                                                double* scratch) const
{
  LaneProduct there;
  there.lanes = diagonal.line;
  there.inner = x.half;
  there.columns = diagonal.modes_x;
  there.a = across + parity * x.half * diagonal.line;
  there.a_stride = diagonal.line;
  there.b = x.by_mode.data();
  there.b_inner = x.mode_stride;
  there.b_column = 1;
  there.out = scratch;
  there.out_stride = diagonal.line;
  there.scale = diagonal.factors.data() + parity * diagonal.modes_x * diagonal.line;
  laneKernels().multiply(there);

  LaneProduct back;
  back.lanes = diagonal.line;
  back.inner = diagonal.modes_x;
  back.columns = x.half;
  back.a = scratch;
  back.a_stride = diagonal.line;
  back.b = x.by_value.data();
  back.b_inner = x.value_stride;
  back.b_column = 1;
  back.out = across + parity * x.half * diagonal.line;
  back.out_stride = diagonal.line;
  laneKernels().multiply(back);
}

void InfluenceOperator::Tables::fromModesAcross(const Diagonal& diagonal, const double* in, double* folded) const
{
  LaneProduct sums;
  sums.lanes = y.value_stride;
  sums.inner = diagonal.modes_y;
  sums.columns = 2 * rows();
  sums.a = y.by_value.data();
  sums.a_stride = y.value_stride;
  sums.b = in;
  sums.b_inner = 1;
  sums.b_column = diagonal.line / 2;
  sums.out = folded;
  sums.out_stride = y.value_stride;
  laneKernels().multiply(sums);
}

void InfluenceOperator::Workspace::reserve(const InfluenceOperator& shape)
{
  const auto grow = [](LaneBuffer& buffer, int& size, int wanted)
  {
    if (wanted > size)
    {
      buffer.resize(wanted);
      size = wanted;
    }
  };
  const Tables& tables = *shape.tables_;
  grow(buffers_->folded, buffers_->folded_size, tables.fieldSize());
  grow(buffers_->across, buffers_->across_size, tables.rows() * tables.product.line);
  grow(buffers_->both, buffers_->both_size, tables.product.modes_x * tables.product.line);
}

InfluenceOperator::InfluenceOperator(const OperatorShape& shape)
{
  check(shape);
  tables_ = std::make_unique<Tables>(shape);
  symmetric_ = shape.symmetric;
  half_rows_ = tables_->x.half;
  middle_row_ = shape.symmetric ? 0 : half_rows_;
  half_columns_ = tables_->y.half;
  line_ = 2 * tables_->y.value_stride;
  fillProbe();
}
InfluenceOperator::~InfluenceOperator() = default;
InfluenceOperator::InfluenceOperator(InfluenceOperator&&) noexcept = default;
InfluenceOperator& InfluenceOperator::operator=(InfluenceOperator&&) noexcept = default;

const OperatorShape& InfluenceOperator::shape() const
{
  return tables_->shape;
}

int InfluenceOperator::fieldSize() const
{
  return tables_->fieldSize();
}

void InfluenceOperator::multiply(const double* pressure, double* displacement, Workspace& workspace) const
{
  tables_->apply(tables_->product, pressure, displacement, *workspace.buffers_);
}

void InfluenceOperator::fillProbe()
{
  constexpr double kGoldenRatio = 0.6180339887498949;
  Tables& tables = *tables_;
  tables.probe.resize(tables.fieldSize());
  tables.probe_product.resize(tables.fieldSize());
  int cell = 0;
  for (int row = 0; row < (symmetric_ ? tables.shape.nx / 2 : tables.shape.nx); ++row)
  {
    for (int column = 0; column < tables.shape.ny; ++column, ++cell)
    {
      tables.probe[rowOffset(row) + columnOffset(column)] = 0.5 + std::fmod(cell * kGoldenRatio, 1.0);
    }
  }
  Workspace workspace;
  workspace.reserve(*this);
  multiply(tables.probe.data(), tables.probe_product.data(), workspace);
}

bool InfluenceOperator::isProduct(const double* pressure, const double* displacement) const
{
  constexpr double kTolerance = 1e-9;
  const int size = fieldSize();
  const double found = laneKernels().dot(size, tables_->probe.data(), displacement);
  const double expected = laneKernels().dot(size, tables_->probe_product.data(), pressure);
  return std::abs(found - expected) <= kTolerance * expected;
}

void InfluenceOperator::precondition(const double* residual, double* direction, Workspace& workspace) const
{
  tables_->apply(tables_->inverse, residual, direction, *workspace.buffers_);
}
}  // namespace wheel_rail_contact
