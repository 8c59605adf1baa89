// SPDX-License-Identifier: BSD-3-Clause
// Part of lanes.cpp, see core/simd/instruction_sets_body.h. No include guard.

using Register = double __attribute__((vector_size(register_width * sizeof(double))));
using Memory = double __attribute__((vector_size(register_width * sizeof(double)), aligned(sizeof(double))));

inline Register load(const double* from)
{
  return *reinterpret_cast<const Memory*>(from);
}

inline void store(double* to, Register value)
{
  *reinterpret_cast<Memory*>(to) = value;
}

inline double sumOf(Register value)
{
  for (int width = register_width / 2; width > 0; width /= 2)
  {
    for (int l = 0; l < width; ++l)
    {
      value[l] += value[l + width];
    }
  }
  return value[0];
}

inline double maxOf(Register value)
{
  double largest = value[0];
  for (int l = 1; l < register_width; ++l)
  {
    largest = value[l] > largest ? value[l] : largest;
  }
  return largest;
}

/// Calls act(m, n) for all m < M and n < N, unrolled, so that the elements of arrays of registers stay in registers.
template <int M, int N, typename Act>
inline void repeat(Act act)
{
#pragma GCC unroll 16
  for (int k = 0; k < M * N; ++k)
  {
    act(k / N, k % N);
  }
}

/// Computes one tile of R registers × C columns, which stays in registers over the whole sum.
template <int R, int C>
inline void tile(const LaneProduct& product, int lane, int column)
{
  Register sum[R][C];
  repeat<R, C>([&](int r, int c) { sum[r][c] = Register{}; });
  const double* a = product.a + lane;
  const double* b = product.b + static_cast<std::ptrdiff_t>(column) * product.b_column;
  for (int k = 0; k < product.inner; ++k)
  {
    repeat<C, R>([&](int c, int r) { sum[r][c] += load(a + r * register_width) * b[c * product.b_column]; });
    a += product.a_stride;
    b += product.b_inner;
  }
  repeat<C, R>(
      [&](int c, int r)
      {
        const std::ptrdiff_t at = lane + static_cast<std::ptrdiff_t>(column + c) * product.out_stride;
        const Register scale = product.scale ? load(product.scale + at + r * register_width) : Register{} + 1;
        store(product.out + at + r * register_width, scale * sum[r][c]);
      });
}

/// Computes tiles of R registers from `lane` on, as long as they fit. Returns the lane after them.
template <int R, int C>
inline int tileLanes(const LaneProduct& product, int lane, int column)
{
  for (; lane + R * register_width <= product.lanes; lane += R * register_width)
  {
    tile<R, C>(product, lane, column);
  }
  return lane;
}

/// Computes tiles of C columns from `column` on, as long as they fit. Returns the column after them.
template <int R, int C>
inline int tileColumns(const LaneProduct& product, int column)
{
  for (; column + C <= product.columns; column += C)
  {
    tileLanes<1, C>(product, tileLanes<R, C>(product, 0, column), column);
  }
  return column;
}

void multiply(const LaneProduct& product)
{
  int column = 0;
  if constexpr (register_width == 8)  // 32 registers, 16 of them for the sums
  {
    column = product.lanes % (4 * register_width) == 0 ? tileColumns<4, 4>(product, 0) : tileColumns<2, 8>(product, 0);
  }
  tileColumns<2, 1>(product, tileColumns<2, 4>(product, column));
}

void fold(int pairs, int block, const double* sign, const double* in, double* out)
{
  for (int pair = 0; pair < pairs; ++pair, in += 2 * block, out += 2 * block)
  {
    for (int k = 0; k < block; k += register_width)
    {
      const Register a = load(in + k), b = load(in + block + k);
      store(out + k, a + b);
      store(out + block + k, load(sign + k) * (a - b));
    }
  }
}

void unfold(int pairs, int block, const double* sign, const double* in, double* out)
{
  for (int pair = 0; pair < pairs; ++pair, in += 2 * block, out += 2 * block)
  {
    for (int k = 0; k < block; k += register_width)
    {
      const Register even = load(in + k), odd = load(sign + k) * load(in + block + k);
      store(out + k, even + odd);
      store(out + block + k, even - odd);
    }
  }
}

#include "core/normal/operator/solver_loops_body.h"
#include "core/normal/operator/transform_loops_body.h"

constexpr LaneKernels kernels = {kernel_name, multiply, fold,       unfold,     butterfly, turn,  turnBack, split,
                                 join,        combine,  multiplyBy, sum,        scale,     add,   dot,      countBelow,
                                 rootDepth,   advance,  residual,   maskedSums, trial,     chord, stepSums};
