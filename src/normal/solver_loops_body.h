// SPDX-License-Identifier: BSD-3-Clause
// Included by lanes.cpp once per instruction set, after lanes_body.h. No include guard.

double sum(int size, const double* values)
{
  Register total = {};
  for (int i = 0; i < size; i += kWidth)
  {
    total += load(values + i);
  }
  return sumOf(total);
}

void scale(int size, double factor, double* values)
{
  for (int i = 0; i < size; i += kWidth)
  {
    store(values + i, factor * load(values + i));
  }
}

double dot(int size, const double* a, const double* b)
{
  Register total = {};
  for (int i = 0; i < size; i += kWidth)
  {
    total += load(a + i) * load(b + i);
  }
  return sumOf(total);
}

double countBelow(int size, double limit, const double* values)
{
  const Register zero = {}, one = zero + 1;
  Register count = zero;
  for (int i = 0; i < size; i += kWidth)
  {
    count += load(values + i) < limit + zero ? one : zero;
  }
  return sumOf(count);
}

double rootDepth(int size, double level, const double* gap, double* p)
{
  double total = 0;
  for (int i = 0; i < size; ++i)
  {
    const double depth = level - gap[i];
    p[i] = depth > 0 ? std::sqrt(depth) : 0;
    total += p[i];
  }
  return total;
}

CellSum advance(int size, double step, const double* d, const double* q, const double* gap, double* p, double* u)
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

CellSum maskedSum(int size, const double* r, const double* z)
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

CellSum trial(int size, double beta, double step, const double* p, const double* z, double* d, double* trial)
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

StepSums stepSums(int size, const double* p, const double* r, const double* d, const double* q)
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
  return {sumOf(r_d), sumOf(d_q), maxOf(fall)};
}

constexpr LaneKernels kKernels = {kName,     multiply, fold,     unfold,    sum,     scale, dot,   countBelow,
                                  rootDepth, advance,  residual, maskedSum, project, trial, chord, stepSums};
