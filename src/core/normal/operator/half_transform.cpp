// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/half_transform.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Transforms are split as long as their halves have at least this length and fill whole registers. Measured with
/// AVX-512 and AVX2: 8 and 16 are equally fast, 32 is slower on long transforms.
constexpr int shortest_half = 16;

int depthFor(int half)
{
  int depth = 0;
  while (half % (2 * lane_padding) == 0 && half / 2 >= shortest_half)
  {
    half /= 2;
    ++depth;
  }
  return depth;
}
}  // namespace

HalfTransform::HalfTransform(int half_cells) : half_(half_cells), depth_(depthFor(half_cells))
{
  const std::vector<int> values = storageOrder(half_, depth_);
  place_.resize(values.size());
  sign_.resize(roundUpToLanes(half_));
  for (int at = 0; at < half_; ++at)
  {
    const int k = values[static_cast<std::size_t>(at)];
    place_[static_cast<std::size_t>(k)] = at;
    sign_[at] = k % 2 == 0 ? 1 : -1;
  }
  const auto append = [](std::vector<int>& modes, const std::vector<int>& order, int odd)
  { std::transform(order.begin(), order.end(), std::back_inserter(modes), [odd](int k) { return 2 * k + odd; }); };
  append(modes_, modeOrder(ii, half_, depth_), 0);
  append(modes_, modeOrder(iv, half_, depth_), 1);
  if (depth_ == 0)
  {
    matrices_.push_back(matrix(modes_, half_));
    leaves_ = {{ii, 0}};
    return;
  }
  for (const Kind kind : {ii, ii_backwards, iv, iv_backwards})
  {
    std::vector<int> modes;
    append(modes, modeOrder(kind, half_ >> depth_, 0), kind == iv || kind == iv_backwards ? 1 : 0);
    matrices_.push_back(matrix(modes, half_ >> depth_));
  }
  for (int level = 0; level < depth_; ++level)
  {
    turns_.push_back(turnTable(half_ >> level, depth_ - level));
  }
  const int quarter = half_ / 2;
  addSteps(ii, 1, 0);
  addSteps(iv, 1, quarter);
  addSteps(ii, 1, 2 * quarter);
  addSteps(ii_backwards, 1, 3 * quarter);
  after_.push_back({Step::Action::combine, half_, quarter, 0});
}

void HalfTransform::addSteps(Kind kind, int level, int at)
{
  using Action = Step::Action;
  if (level == depth_)
  {
    leaves_.push_back({kind, at});
    return;
  }
  const int count = half_ >> (level + 1);
  const bool second = kind == ii || kind == ii_backwards, backwards = kind == ii_backwards || kind == iv_backwards;
  before_.push_back({second ? Action::butterfly : Action::turn, at, count, level});
  addSteps(backwards ? ii_backwards : ii, level + 1, at);
  if (second)
  {
    addSteps(backwards ? iv_backwards : iv, level + 1, at + count);
  }
  else
  {
    addSteps(backwards ? ii : ii_backwards, level + 1, at + count);
    after_.push_back({backwards ? Action::combine_backwards : Action::combine, at, count, level});
  }
}

HalfTransform::Matrix HalfTransform::matrix(const std::vector<int>& modes, int values)
{
  Matrix result;
  result.mode_stride = roundUpToLanes(static_cast<int>(modes.size()));
  result.value_stride = roundUpToLanes(values);
  result.by_mode.resize(values * result.mode_stride);
  result.by_value.resize(static_cast<int>(modes.size()) * result.value_stride);
  for (int k = 0; k < values; ++k)
  {
    for (int place = 0; place < static_cast<int>(modes.size()); ++place)
    {
      const double value = std::cos(pi * modes[static_cast<std::size_t>(place)] * (k + 0.5) / (2 * values));
      result.by_mode[k * result.mode_stride + place] = value;
      result.by_value[place * result.value_stride + k] = value;
    }
  }
  return result;
}

int HalfTransform::number(int parity, int place) const
{
  const int a = modes_[static_cast<std::size_t>(place)];
  return parity == 0 ? a : 2 * half_ - a;
}

std::vector<int> HalfTransform::storageOrder(int size, int depth)
{
  std::vector<int> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), 0);
  if (depth > 0)
  {
    const std::vector<int> lower = storageOrder(size / 2, depth - 1);
    std::copy(lower.begin(), lower.end(), order.begin());
    std::transform(lower.begin(), lower.end(), order.begin() + size / 2, [size](int k) { return size - 1 - k; });
  }
  return order;
}

/// Mode numbers of a transform of one kind, in their order in memory.
std::vector<int> HalfTransform::modeOrder(Kind kind, int size, int depth)
{
  std::vector<int> order(static_cast<std::size_t>(size));
  if (kind == ii_backwards)
  {
    order = modeOrder(ii, size, depth);
    std::for_each(order.begin(), order.end(), [size](int& k) { k = (size - k) % size; });
  }
  else if (kind == iv_backwards)
  {
    order = modeOrder(iv, size, depth);
    std::for_each(order.begin(), order.end(), [size](int& k) { k = size - 1 - k; });
  }
  else if (depth == 0)
  {
    std::iota(order.begin(), order.end(), 0);
  }
  else
  {
    const std::vector<int> even = modeOrder(ii, size / 2, depth - 1);
    const std::vector<int> odd = kind == ii ? modeOrder(iv, size / 2, depth - 1) : even;
    const auto place_odd = [kind, size](int k) { return kind == ii ? 2 * k + 1 : (2 * k - 1 + size) % size; };
    std::transform(even.begin(), even.end(), order.begin(), [](int k) { return 2 * k; });
    std::transform(odd.begin(), odd.end(), order.begin() + size / 2, place_odd);
  }
  return order;
}

/// Cosines and sines for the rotation of the pairs of a DCT-IV, in the order of the values in memory: c, s, and both
/// multiplied by (-1)^k.
LaneBuffer HalfTransform::turnTable(int size, int depth)
{
  const std::vector<int> order = storageOrder(size / 2, depth - 1);
  const int stride = roundUpToLanes(size / 2);
  LaneBuffer table;
  table.resize(4 * stride);
  for (int at = 0; at < size / 2; ++at)
  {
    const int k = order[static_cast<std::size_t>(at)];
    const double angle = (2 * k + 1) * pi / (4 * size), sign = k % 2 == 0 ? 1 : -1;
    table[at] = std::cos(angle);
    table[stride + at] = std::sin(angle);
    table[2 * stride + at] = sign * std::cos(angle);
    table[3 * stride + at] = sign * std::sin(angle);
  }
  return table;
}

/// Number of doubles of the modes of one line.
int HalfTransform::modesSize(const Lines& lines) const
{
  return lines.unit == 1 ? modeStride(lines.all) : (lines.all ? 2 : 1) * half_ * lines.unit;
}

/// Describes all pairs of blocks of a step.
BlockLines HalfTransform::blocks(const Lines& lines, int count) const
{
  BlockLines blocks;
  blocks.lines = lines.count;
  blocks.stride = modesSize(lines);
  blocks.count = count;
  blocks.unit = lines.unit;
  return blocks;
}

void HalfTransform::forward(const Lines& lines, const double* values, const double* scale, double* work,
                            double* modes) const
{
  if (depth_ == 0)
  {
    products(lines, values, modes, scale, false);
    return;
  }
  const LaneKernels& kernels = laneKernels();
  const double* turns = lines.all ? turns_.front().data() : nullptr;
  kernels.split(blocks(lines, half_ / 2), turns, {valueStride(), lines.pitch}, values, work);
  for (const Step& step : before_)
  {
    apply(lines, step, false, work);
  }
  products(lines, work, modes, nullptr, false);
  for (const Step& step : after_)
  {
    apply(lines, step, false, modes);
  }
  if (scale)
  {
    kernels.multiply_by(lines.count * modesSize(lines), scale, modes);
  }
}

void HalfTransform::backward(const Lines& lines, double* modes, double* work, double* values) const
{
  if (depth_ == 0)
  {
    products(lines, modes, values, nullptr, true);
    return;
  }
  std::for_each(after_.rbegin(), after_.rend(), [&](const Step& step) { apply(lines, step, true, modes); });
  products(lines, modes, work, nullptr, true);
  std::for_each(before_.rbegin(), before_.rend(), [&](const Step& step) { apply(lines, step, true, work); });
  const double* turns = lines.all ? turns_.front().data() : nullptr;
  laneKernels().join(blocks(lines, half_ / 2), turns, {valueStride(), lines.pitch}, work, values);
}

/// Runs a step or its transpose, unless the step belongs to modes that are not requested.
void HalfTransform::apply(const Lines& lines, const Step& step, bool back, double* data) const
{
  if (!lines.all && step.at >= half_)
  {
    return;
  }
  const LaneKernels& kernels = laneKernels();
  const BlockLines pair = blocks(lines, step.count);
  double* first = data + step.at * lines.unit;
  switch (step.action)
  {
    case Step::Action::butterfly:
      kernels.butterfly(pair, first);
      break;
    case Step::Action::turn:
      (back ? kernels.turn_back : kernels.turn)(pair, turns_[static_cast<std::size_t>(step.level)].data(), first);
      break;
    case Step::Action::combine:
      kernels.combine(pair, Combination::forwards, first);
      break;
    case Step::Action::combine_backwards:
      kernels.combine(pair, back ? Combination::backwards_transposed : Combination::backwards, first);
      break;
  }
}

/// Matrix products of all leaves that belong to requested modes.
void HalfTransform::products(const Lines& lines, const double* in, double* out, const double* scale, bool back) const
{
  for (const Leaf& leaf : leaves_)
  {
    if (!lines.all && leaf.at >= half_)
    {
      continue;
    }
    LaneProduct sums = product(lines, leaf, back);
    const int at = leaf.at * lines.unit;
    (lines.unit == 1 ? sums.b : sums.a) = in + at;
    sums.out = out + at;
    sums.scale = scale ? scale + at : nullptr;
    laneKernels().multiply(sums);
  }
}

/// Product of one leaf, without the addresses of its values and modes. For lines of single numbers the matrix is the
/// left factor, and its modes (backward: its values) are the lanes. For a line of vectors it is the right factor, and
/// the vectors are the lanes.
LaneProduct HalfTransform::product(const Lines& lines, const Leaf& leaf, bool back) const
{
  const Matrix& matrix = matrices_[static_cast<std::size_t>(leaf.kind)];
  const LaneBuffer& table = back ? matrix.by_value : matrix.by_mode;
  const int table_stride = back ? matrix.value_stride : matrix.mode_stride;
  const int values = half_ >> depth_, modes = depth_ == 0 && lines.all ? 2 * values : values;
  const bool whole = depth_ == 0;  // values of the whole transform, not of a step
  LaneProduct sums;
  sums.inner = back ? modes : values;
  if (lines.unit == 1)
  {
    const int value_stride = whole ? valueStride() : modesSize(lines), mode_stride = modesSize(lines);
    sums.lanes = roundUpToLanes(back ? values : modes);
    sums.columns = lines.count;
    sums.a = table.data();
    sums.a_stride = table_stride;
    sums.b_inner = 1;
    sums.b_column = back ? mode_stride : value_stride;
    sums.out_stride = back ? value_stride : mode_stride;
  }
  else
  {
    const int value_pitch = whole ? lines.pitch : lines.unit;
    sums.lanes = lines.unit;
    sums.columns = back ? values : modes;
    sums.a_stride = back ? lines.unit : value_pitch;
    sums.b = table.data();
    sums.b_inner = table_stride;
    sums.b_column = 1;
    sums.out_stride = back ? value_pitch : lines.unit;
  }
  return sums;
}
}  // namespace wheel_rail_contact::core
