// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/influence_operator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/constants.h"
#include "core/normal/operator/half_transform.h"
#include "core/normal/operator/influence.h"
#include "core/normal/operator/lanes.h"
#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Number of doubles of the modes that are transformed at a time: two such arrays fill the fastest cache (32 KiB).
constexpr int part_size = 2048;

void check(const OperatorShape& shape)
{
  refuseIf(shape.nx < 2 || shape.ny < 2, "grid = " + std::to_string(shape.nx) + " x " + std::to_string(shape.ny) +
                                             ": must have at least 2 cells in each direction");
  refuseIf(shape.symmetric && shape.nx % 2 != 0,
           "nx = " + std::to_string(shape.nx) + ": must be even on a symmetric grid");
  refuseIf(!(shape.aspect > 0) || !std::isfinite(shape.aspect),
           "aspect = " + std::to_string(shape.aspect) + ": must be positive and finite");
}

/// Cosine transform, in both directions, of a kernel that is given at 0 … length and has the period 2 length:
/// [mode_y][mode_x].
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
      for (int m = 0; m <= length_x; ++m)
      {
        const double value = kernel[static_cast<std::size_t>(n * kernel_stride + m)];
        for (int a = 0; a <= length_x; ++a)
        {
          half[at(a, n)] += cosines_x[at(a, m)] * value;
        }
      }
    }
    for (int b = 0; b <= length_y; ++b)
    {
      for (int n = 0; n <= length_y; ++n)
      {
        const double cosine = cosines_y[static_cast<std::size_t>(n * (length_y + 1) + b)];
        for (int a = 0; a <= length_x; ++a)
        {
          values_[at(a, b)] += cosine * half[at(a, n)];
        }
      }
    }
  }

  double operator()(int a, int b) const { return values_[at(a, b)]; }

 private:
  /// Table [m][a] of 2 cos(pi a m / length), without the factor 2 for m = 0 and m = length, which occur once in a
  /// period.
  static std::vector<double> cosines(int length)
  {
    std::vector<double> period;
    period.reserve(2 * static_cast<std::size_t>(length));
    for (int k = 0; k < 2 * length; ++k)
    {
      period.push_back(std::cos(pi * k / length));
    }
    std::vector<double> table;
    table.reserve(static_cast<std::size_t>((length + 1) * (length + 1)));
    for (int m = 0; m <= length; ++m)
    {
      const double times = m == 0 || m == length ? 1 : 2;
      for (int a = 0; a <= length; ++a)
      {
        table.push_back(times * period[static_cast<std::size_t>(a * m % (2 * length))]);
      }
    }
    return table;
  }

  std::size_t at(int a, int b) const { return static_cast<std::size_t>(b * (length_x_ + 1) + a); }

  int length_x_;
  std::vector<double> values_;
};

/// Weight of a mode in the inverse transform over a period of 2 length.
double modeWeight(int mode, int length)
{
  return (mode == 0 || mode == length ? 1.0 : 2.0) / (2 * length);
}
}  // namespace

struct InfluenceOperator::Workspace::Buffers
{
  LaneBuffer folded;       ///< even and odd parts of a field
  LaneBuffer across;       ///< their modes across the track
  LaneBuffer modes, work;  ///< for one part of the modes
  std::array<int, 3> sizes{};
};

InfluenceOperator::Workspace::Workspace() : buffers_(std::make_unique<Buffers>()) {}
InfluenceOperator::Workspace::~Workspace() = default;
InfluenceOperator::Workspace::Workspace(Workspace&&) noexcept = default;
InfluenceOperator::Workspace& InfluenceOperator::Workspace::operator=(Workspace&&) noexcept = default;

struct InfluenceOperator::Tables
{
  /// Factors of the modes: all modes of the doubled period, or the even ones, which are those of the period of the
  /// grid. The memory is processed in parts that stay in the fastest cache.
  struct Diagonal
  {
    bool all = true;
    int modes_x = 0, modes_y = 0;
    int line = 0;   ///< doubles of the modes across of one row, both parities
    int lines = 0;  ///< lines transformed across at a time
    int lanes = 0;  ///< lanes transformed along at a time
    LaneBuffer factors;

    /// Index of a factor: [parity x][part of the lanes][mode x][lane].
    int place(int px, int mode_x, int lane) const
    {
      const int begin = lane / lanes * lanes, width = std::min(lanes, line - begin);
      return (px * line + begin) * modes_x + mode_x * width + lane - begin;
    }
  };

  Tables(const OperatorShape& wanted, const Tables* sibling);

  /// True if `other` is the whole grid of the same cells. Its modes even in x are then the modes of this symmetric
  /// grid.
  bool isHalfOf(const Tables& other) const
  {
    return shape.symmetric && !other.shape.symmetric && other.shape.aspect == shape.aspect &&
           other.shape.nx == shape.nx && other.shape.ny == shape.ny;
  }
  std::vector<double> coefficients() const;
  Diagonal diagonal(const Spectrum& spectrum, bool all) const;
  static Diagonal evenModes(const Diagonal& whole);
  void apply(const Diagonal& diagonal, const double* in, double* out, Workspace::Buffers& buffers) const;

  int rows() const { return x_parts * x->half(); }
  int fieldSize() const { return rows() * 2 * y->valueStride(); }
  HalfTransform::Lines linesFrom(const Diagonal& diagonal, int line) const
  {
    return {std::min(diagonal.lines, 2 * rows() - line), 1, 1, diagonal.all};
  }
  /// Number of doubles that the transform of one part needs.
  int partSize() const { return std::max(product.modes_x * product.lanes, product.lines * y->modeStride(true)); }

  OperatorShape shape;
  int x_parts;  ///< stored halves along the track: 1 on a symmetric grid, otherwise 2
  std::shared_ptr<const HalfTransform> x, y;
  LaneBuffer sign_along;  ///< (-1)^row over half the field
  Diagonal product, inverse;
  LaneBuffer probe;          ///< unequal weights of the cells
  LaneBuffer probe_product;  ///< product of the influence matrix with `probe`
};

InfluenceOperator::Tables::Tables(const OperatorShape& wanted, const Tables* sibling)
    : shape(wanted),
      x_parts(wanted.symmetric ? 1 : 2),
      x(sibling ? sibling->x : std::make_shared<const HalfTransform>((wanted.nx + 1) / 2)),
      y(sibling ? sibling->y : std::make_shared<const HalfTransform>((wanted.ny + 1) / 2))
{
  const int line = 2 * y->valueStride();
  sign_along.resize(x->half() * line);
  for (int i = 0; i < x->half(); ++i)
  {
    std::fill_n(sign_along.data() + i * line, line, x->sign()[i]);
  }
  if (sibling && isHalfOf(*sibling))
  {
    product = evenModes(sibling->product);
    inverse = evenModes(sibling->inverse);
    return;
  }
  const std::vector<double> kernel = coefficients();
  const int stride = 2 * x->half() + 1;
  product = diagonal(Spectrum(kernel, stride, 2 * x->half(), 2 * y->half()), true);
  inverse = diagonal(Spectrum(kernel, stride, x->half(), y->half()), false);
}

/// Factors of a symmetric grid from those of the whole grid. Each stored cell represents two cells.
InfluenceOperator::Tables::Diagonal InfluenceOperator::Tables::evenModes(const Diagonal& whole)
{
  Diagonal result;
  result.all = whole.all;
  result.modes_x = whole.modes_x;
  result.modes_y = whole.modes_y;
  result.line = whole.line;
  result.lines = whole.lines;
  result.lanes = whole.lanes;
  const int size = whole.modes_x * whole.line;
  result.factors.resize(size);
  std::transform(whole.factors.data(), whole.factors.data() + size, result.factors.data(),
                 [](double factor) { return 2 * factor; });
  return result;
}

std::vector<double> InfluenceOperator::Tables::coefficients() const
{
  std::vector<double> kernel;
  kernel.reserve(static_cast<std::size_t>((2 * x->half() + 1) * (2 * y->half() + 1)));
  for (int n = 0; n <= 2 * y->half(); ++n)
  {
    for (int m = 0; m <= 2 * x->half(); ++m)
    {
      kernel.push_back(rectangleInfluence(m * shape.aspect, n, shape.aspect, 1));
    }
  }
  return kernel;
}

/// Factors from a spectrum: of the whole doubled period (`all`), or the inverse for the period of the grid.
InfluenceOperator::Tables::Diagonal InfluenceOperator::Tables::diagonal(const Spectrum& spectrum, bool all) const
{
  Diagonal result;
  result.all = all;
  result.modes_x = all ? 2 * x->half() : x->half();
  result.modes_y = all ? 2 * y->half() : y->half();
  result.line = 2 * y->modeStride(all);
  result.lanes = std::min(result.line, std::max(2 * lane_padding, roundUpToLanes(part_size / (2 * x->half()))));
  result.lines = std::max(lane_padding, part_size / (2 * y->half()));
  result.factors.resize(x_parts * result.modes_x * result.line);
  for (int px = 0; px < x_parts; ++px)
  {
    for (int a = 0; a < result.modes_x; ++a)
    {
      for (int py = 0; py < 2; ++py)
      {
        for (int b = 0; b < result.modes_y; ++b)
        {
          const int step = all ? 1 : 2;  // step in the modes of the doubled period
          const int mode_x = x->number(px, a) / step, mode_y = y->number(py, b) / step;
          const double weight = modeWeight(mode_x, result.modes_x) * modeWeight(mode_y, result.modes_y);
          const double value = spectrum(mode_x, mode_y);
          const int at = result.place(px, a, py * y->modeStride(all) + b);
          result.factors[at] = (shape.symmetric ? 2 : 1) * weight * (all ? value : 1 / value);
        }
      }
    }
  }
  return result;
}

void InfluenceOperator::Tables::apply(const Diagonal& diagonal, const double* in, double* out,
                                      Workspace::Buffers& buffers) const
{
  const LaneKernels& kernels = laneKernels();
  double *folded = buffers.folded.data(), *across = buffers.across.data();
  double *modes = buffers.modes.data(), *work = buffers.work.data();
  kernels.fold(rows(), y->valueStride(), y->sign(), in, folded);
  if (x_parts == 2)
  {
    kernels.fold(1, fieldSize() / 2, sign_along.data(), folded, folded);
  }
  for (int line = 0; line < 2 * rows(); line += diagonal.lines)
  {
    y->forward(linesFrom(diagonal, line), folded + line * y->valueStride(), nullptr, work,
               across + line * y->modeStride(diagonal.all));
  }
  for (int px = 0; px < x_parts; ++px)
  {
    for (int lane = 0; lane < diagonal.line; lane += diagonal.lanes)
    {
      const HalfTransform::Lines lanes{1, std::min(diagonal.lanes, diagonal.line - lane), diagonal.line, diagonal.all};
      double* values = across + px * x->half() * diagonal.line + lane;
      x->forward(lanes, values, diagonal.factors.data() + diagonal.place(px, 0, lane), work, modes);
      x->backward(lanes, modes, work, values);
    }
  }
  for (int line = 0; line < 2 * rows(); line += diagonal.lines)
  {
    y->backward(linesFrom(diagonal, line), across + line * y->modeStride(diagonal.all), work,
                folded + line * y->valueStride());
  }
  if (x_parts == 2)
  {
    kernels.unfold(1, fieldSize() / 2, sign_along.data(), folded, folded);
  }
  kernels.unfold(rows(), y->valueStride(), y->sign(), folded, out);
}

void InfluenceOperator::Workspace::reserve(const InfluenceOperator& shape)
{
  const Tables& tables = *shape.tables_;
  Buffers& buffers = *buffers_;
  const std::array<int, 3> wanted = {tables.fieldSize(), tables.rows() * tables.product.line, tables.partSize()};
  for (std::size_t k = 0; k < wanted.size(); ++k)
  {
    buffers.sizes[k] = std::max(buffers.sizes[k], wanted[k]);
  }
  buffers.folded.resize(buffers.sizes[0]);
  buffers.across.resize(buffers.sizes[1]);
  buffers.modes.resize(buffers.sizes[2]);
  buffers.work.resize(buffers.sizes[2]);
}

InfluenceOperator::InfluenceOperator(const OperatorShape& shape, const InfluenceOperator* sibling)
{
  check(shape);
  const bool same_size = sibling && sibling->shape().nx == shape.nx && sibling->shape().ny == shape.ny;
  tables_ = std::make_unique<Tables>(shape, same_size ? sibling->tables_.get() : nullptr);
  fillOffsets();
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

void InfluenceOperator::fillOffsets()
{
  const OperatorShape& shape = tables_->shape;
  const HalfTransform &x = *tables_->x, &y = *tables_->y;
  const int line = 2 * y.valueStride();
  const int middle_row = shape.symmetric ? 0 : x.half();
  for (int row = 0; row < (shape.symmetric ? shape.nx / 2 : shape.nx); ++row)
  {
    const int place = row >= middle_row ? x.place(row - middle_row) : x.half() + x.place(middle_row - 1 - row);
    row_offsets_.push_back(place * line);
  }
  for (int column = 0; column < shape.ny; ++column)
  {
    const bool upper = column >= y.half();
    column_offsets_.push_back(upper ? y.place(column - y.half()) : line / 2 + y.place(y.half() - 1 - column));
  }
}

void InfluenceOperator::fillProbe()
{
  constexpr double golden_ratio = 0.6180339887498949;
  Tables& tables = *tables_;
  tables.probe.resize(tables.fieldSize());
  tables.probe_product.resize(tables.fieldSize());
  int cell = 0;
  for (int row = 0; row < static_cast<int>(row_offsets_.size()); ++row)
  {
    for (int column = 0; column < tables.shape.ny; ++column, ++cell)
    {
      tables.probe[rowOffset(row) + columnOffset(column)] = 0.5 + std::fmod(cell * golden_ratio, 1.0);
    }
  }
  Workspace workspace;
  workspace.reserve(*this);
  multiply(tables.probe.data(), tables.probe_product.data(), workspace);
}

bool InfluenceOperator::isProduct(const double* pressure, const double* displacement) const
{
  constexpr double tolerance = 1e-9;
  const int size = fieldSize();
  const double found = laneKernels().dot(size, tables_->probe.data(), displacement);
  const double expected = laneKernels().dot(size, tables_->probe_product.data(), pressure);
  return std::abs(found - expected) <= tolerance * expected;
}

void InfluenceOperator::precondition(const double* residual, double* direction, Workspace& workspace) const
{
  tables_->apply(tables_->inverse, residual, direction, *workspace.buffers_);
}
}  // namespace wheel_rail_contact::core
