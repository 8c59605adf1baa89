// SPDX-License-Identifier: BSD-3-Clause
// Included by lanes.cpp once per instruction set, inside a namespace that defines kWidth. No include guard.

using Register = double __attribute__((vector_size(kWidth * sizeof(double))));
using Memory = double __attribute__((vector_size(kWidth * sizeof(double)), aligned(sizeof(double))));

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
  double sum = 0;
  for (int l = 0; l < kWidth; ++l)
  {
    sum += value[l];
  }
  return sum;
}

inline double maxOf(Register value)
{
  double largest = value[0];
  for (int l = 1; l < kWidth; ++l)
  {
    largest = value[l] > largest ? value[l] : largest;
  }
  return largest;
}

/// One tile of R registers × C columns, kept in registers over the whole sum.
template <int R, int C>
inline void tile(const LaneProduct& product, int lane, int column)
{
  Register sum[R][C] = {};
  const double* a = product.a + lane;
  const double* b = product.b + static_cast<std::ptrdiff_t>(column) * product.b_column;
  for (int k = 0; k < product.inner; ++k)
  {
    Register left[R];
    for (int r = 0; r < R; ++r)
    {
      left[r] = load(a + r * kWidth);
    }
    for (int c = 0; c < C; ++c)
    {
      const double right = b[c * product.b_column];
      for (int r = 0; r < R; ++r)
      {
        sum[r][c] += left[r] * right;
      }
    }
    a += product.a_stride;
    b += product.b_inner;
  }
  for (int c = 0; c < C; ++c)
  {
    const std::ptrdiff_t at = lane + static_cast<std::ptrdiff_t>(column + c) * product.out_stride;
    for (int r = 0; r < R; ++r)
    {
      const Register value = product.scale ? sum[r][c] * load(product.scale + at + r * kWidth) : sum[r][c];
      store(product.out + at + r * kWidth, value);
    }
  }
}

template <int C>
inline void tileColumn(const LaneProduct& product, int column)
{
  int lane = 0;
  for (; lane + 2 * kWidth <= product.lanes; lane += 2 * kWidth)
  {
    tile<2, C>(product, lane, column);
  }
  for (; lane < product.lanes; lane += kWidth)
  {
    tile<1, C>(product, lane, column);
  }
}

void multiply(const LaneProduct& product)
{
  int column = 0;
  for (; column + 4 <= product.columns; column += 4)
  {
    tileColumn<4>(product, column);
  }
  for (; column < product.columns; ++column)
  {
    tileColumn<1>(product, column);
  }
}

void fold(int pairs, int block, const double* sign, const double* in, double* out)
{
  for (int pair = 0; pair < pairs; ++pair, in += 2 * block, out += 2 * block)
  {
    for (int k = 0; k < block; k += kWidth)
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
    for (int k = 0; k < block; k += kWidth)
    {
      const Register even = load(in + k), odd = load(sign + k) * load(in + block + k);
      store(out + k, even + odd);
      store(out + block + k, even - odd);
    }
  }
}

LoadedCells advance(int size, double step, const double* d, const double* q, const double* gap, double* p, double* u)
{
  const Register zero = {}, one = zero + 1;
  Register sum = zero, count = zero;
  for (int i = 0; i < size; i += kWidth)
  {
    const Register moved = load(p + i) + step * load(d + i);
    const Register pressure = moved > zero ? moved : zero;
    const Register displacement = load(u + i) + step * load(q + i);
    store(p + i, pressure);
    store(u + i, displacement);
    sum += pressure > zero ? displacement + load(gap + i) : zero;
    count += pressure > zero ? one : zero;
  }
  return {sumOf(sum), sumOf(count)};
}

Violation residual(int size, double shift, const double* p, const double* u, const double* gap, double* r)
{
  const Register zero = {};
  Register inside = zero, outside = zero;
  for (int i = 0; i < size; i += kWidth)
  {
    const Register minus_w = shift - (load(u + i) + load(gap + i));
    const Register positive = minus_w > zero ? minus_w : zero;
    const Register size_of = minus_w > zero ? minus_w : -minus_w;
    const auto loaded = load(p + i) > zero;
    const Register in = loaded ? size_of : zero, out = loaded ? zero : positive;
    inside = in > inside ? in : inside;
    outside = out > outside ? out : outside;
    store(r + i, loaded ? minus_w : positive);
  }
  return {maxOf(inside), maxOf(outside)};
}

LoadedCells maskedSum(int size, const double* r, const double* z)
{
  const Register zero = {}, one = zero + 1;
  Register sum = zero, count = zero;
  for (int i = 0; i < size; i += kWidth)
  {
    const auto active = load(r + i) != zero;
    sum += active ? load(z + i) : zero;
    count += active ? one : zero;
  }
  return {sumOf(sum), sumOf(count)};
}

DirectionSums project(int size, double shift, const double* r, const double* r_old, double* z)
{
  const Register zero = {};
  Register z_r = zero, z_r_old = zero;
  for (int i = 0; i < size; i += kWidth)
  {
    const Register force = load(r + i);
    const Register projected = force != zero ? load(z + i) - shift : zero;
    store(z + i, projected);
    z_r += projected * force;
    z_r_old += projected * load(r_old + i);
  }
  return {sumOf(z_r), sumOf(z_r_old)};
}

TrialSums trial(int size, double beta, double step, const double* p, const double* z, double* d, double* trial)
{
  const Register zero = {}, one = zero + 1;
  Register sum = zero, clipped = zero;
  for (int i = 0; i < size; i += kWidth)
  {
    const Register pressure = load(p + i);
    const Register direction = load(z + i) + beta * load(d + i);
    const Register moved = pressure + step * direction;
    const Register cut = moved > zero ? moved : zero;
    store(d + i, direction);
    store(trial + i, cut);
    sum += cut;
    clipped += moved < zero ? one : zero;
  }
  return {sumOf(sum), sumOf(clipped)};
}

void chord(int size, double scale, const double* p, const double* trial, double* d)
{
  for (int i = 0; i < size; i += kWidth)
  {
    store(d + i, scale * load(trial + i) - load(p + i));
  }
}

StepSums stepLength(int size, const double* p, const double* r, const double* d, const double* q)
{
  const Register zero = {};
  Register r_d = zero, d_q = zero, fall = zero;
  for (int i = 0; i < size; i += kWidth)
  {
    const Register direction = load(d + i), pressure = load(p + i);
    r_d += load(r + i) * direction;
    d_q += direction * load(q + i);
    const Register ratio = direction < zero ? -direction / pressure : zero;
    fall = ratio > fall ? ratio : fall;
  }
  const double steepest = maxOf(fall);
  return {sumOf(r_d), sumOf(d_q), steepest > 0 ? 1 / steepest : std::numeric_limits<double>::infinity()};
}

constexpr LaneKernels kKernels = {kWidth,    multiply, fold,  unfold, advance,   residual,
                                  maskedSum, project,  trial, chord,  stepLength};
