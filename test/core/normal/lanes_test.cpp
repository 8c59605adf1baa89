// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/lanes.h"

#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Parameter: each instruction set that this machine supports.
class Lanes : public testing::TestWithParam<const LaneKernels*>
{
 protected:
  static constexpr int size = 72;

  /// Random values; every third one is zero.
  LaneBuffer field(double low, double high)
  {
    LaneBuffer buffer;
    buffer.resize(size);
    for (int i = 0; i < size; ++i)
    {
      buffer[i] = i % 3 == 0 ? 0 : problems::uniform(random_, low, high);
    }
    return buffer;
  }

  const LaneKernels& kernels_ = *GetParam();
  std::mt19937_64 random_{31};
};

TEST_P(Lanes, ProductEqualsThePlainSum)
{
  for (const int columns : {1, 3, 4, 9})
  {
    constexpr int lanes = 24, inner = 5;
    LaneBuffer a, b, out, scale;
    a.resize(lanes * inner);
    b.resize(16 * columns);
    out.resize(lanes * columns);
    scale.resize(lanes * columns);
    for (LaneBuffer* buffer : {&a, &b, &scale})
    {
      std::generate_n(buffer->data(), buffer == &b ? 16 * columns : lanes * (buffer == &a ? inner : columns),
                      [this] { return problems::uniform(random_, -1, 1); });
    }
    LaneProduct product;
    product.lanes = lanes;
    product.inner = inner;
    product.columns = columns;
    product.a = a.data();
    product.a_stride = lanes;
    product.b = b.data();
    product.b_inner = 2;
    product.b_column = 16;
    product.out = out.data();
    product.out_stride = lanes;
    for (const bool scaled : {false, true})
    {
      product.scale = scaled ? scale.data() : nullptr;
      kernels_.multiply(product);
      for (int l = 0; l < lanes * columns; ++l)
      {
        double sum = 0;
        for (int k = 0; k < inner; ++k)
        {
          sum += a[l % lanes + lanes * k] * b[2 * k + 16 * (l / lanes)];
        }
        EXPECT_NEAR(out[l], scaled ? scale[l] * sum : sum, 1e-14);
      }
    }
  }
}

TEST_P(Lanes, FoldAndUnfoldAreTransposed)
{
  LaneBuffer in = field(-1, 1), other = field(-1, 1), folded = field(0, 0), unfolded = field(0, 0), sign = field(0, 0);
  for (int i = 0; i < 8; ++i)
  {
    sign[i] = i % 2 == 0 ? 1 : -1;
  }
  constexpr int pairs = 4;
  kernels_.fold(pairs, 8, sign.data(), in.data(), folded.data());
  EXPECT_DOUBLE_EQ(folded[17], in[17] + in[25]);
  EXPECT_DOUBLE_EQ(folded[25], in[25] - in[17]);
  kernels_.unfold(pairs, 8, sign.data(), other.data(), unfolded.data());
  EXPECT_NEAR(kernels_.dot(64, folded.data(), other.data()), kernels_.dot(64, in.data(), unfolded.data()), 1e-13);
}

TEST_P(Lanes, SolverLoopsEqualPlainLoops)
{
  LaneBuffer p = field(0, 1), u = field(0, 1), gap = field(-1, 1), s = field(-1, 1), q = field(-1, 1), z = field(-1, 1);
  LaneBuffer r = field(0, 0), trial = field(0, 0);
  double sum = 0, count = 0, inside = 0, outside = 0, z_r = 0, z_q = 0;
  LaneBuffer p_old = field(0, 0), u_old = field(0, 0);
  std::copy_n(p.data(), size, p_old.data());
  std::copy_n(u.data(), size, u_old.data());
  const CellSum cells = kernels_.advance(size, 0.7, s.data(), q.data(), gap.data(), p.data(), u.data());
  const Violation violation = kernels_.residual(size, 0.3, p.data(), u.data(), gap.data(), r.data());
  const MaskedSums masked = kernels_.masked_sums(size, r.data(), z.data(), q.data());
  for (int i = 0; i < size; ++i)
  {
    EXPECT_NEAR(p[i], std::max(p_old[i] + 0.7 * s[i], 0.0), 1e-15);
    EXPECT_NEAR(u[i], u_old[i] + 0.7 * q[i], 1e-15);
    const double w = u[i] + gap[i] - 0.3;
    sum += p[i] > 0 ? u[i] + gap[i] : 0;
    count += p[i] > 0 ? 1 : 0;
    inside = p[i] > 0 ? std::max(inside, std::abs(w)) : inside;
    outside = p[i] > 0 ? outside : std::max(outside, -w);
    EXPECT_NEAR(r[i], p[i] > 0 || w < 0 ? -w : 0, 1e-15);
    z_r += r[i] * z[i];
    z_q += r[i] != 0 ? z[i] * q[i] : 0;
  }
  EXPECT_NEAR(cells.sum, sum, 1e-13);
  EXPECT_EQ(cells.count, count);
  EXPECT_NEAR(violation.inside, inside, 1e-15);
  EXPECT_NEAR(violation.outside, outside, 1e-15);
  EXPECT_NEAR(masked.z_r, z_r, 1e-13);
  EXPECT_NEAR(masked.z_q, z_q, 1e-13);
}

TEST_P(Lanes, StepsStayWithinTheBounds)
{
  LaneBuffer p = field(0, 1), z = field(-3, 3), last = field(-1, 1), r = field(-1, 1), trial = field(0, 0);
  TrialStep step;
  step.length = 0.8;
  step.shift = 0.1;
  step.beta = 0.5;
  const double sum = kernels_.trial(size, step, r.data(), p.data(), z.data(), last.data(), trial.data());
  double expected = 0;
  for (int i = 0; i < size; ++i)
  {
    const double moved = r[i] != 0 ? p[i] + 0.8 * (z[i] - 0.1 + 0.5 * last[i]) : p[i];
    EXPECT_NEAR(trial[i], std::max(moved, 0.0), 1e-15);
    expected += trial[i];
  }
  EXPECT_NEAR(sum, expected, 1e-13);
  const double slope = kernels_.chord(size, 1.1, r.data(), p.data(), trial.data());
  EXPECT_NEAR(slope, kernels_.dot(size, r.data(), trial.data()), 1e-13);
  const StepSums sums = kernels_.step_sums(size, p.data(), trial.data(), z.data());
  EXPECT_NEAR(sums.s_q, kernels_.dot(size, trial.data(), z.data()), 1e-13);
  EXPECT_NEAR(sums.fall, 1, 1e-15) << "at least one cell is clipped to zero";
}

INSTANTIATE_TEST_SUITE_P(Supported, Lanes, testing::ValuesIn(supportedLaneKernels()),
                         [](const auto& instance) { return std::string(instance.param->name); });
}  // namespace
}  // namespace wheel_rail_contact::core
