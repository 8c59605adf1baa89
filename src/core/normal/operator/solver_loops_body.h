// SPDX-License-Identifier: BSD-3-Clause
// Included by lanes_body.h. No include guard.

double sum(int size, const double* values)
{
  Register total = {};
  for (int i = 0; i < size; i += register_width)
  {
    total += load(values + i);
  }
  return sumOf(total);
}

void scale(int size, double factor, double* values)
{
  for (int i = 0; i < size; i += register_width)
  {
    store(values + i, factor * load(values + i));
  }
}

void multiplyBy(int size, const double* factors, double* values)
{
  for (int i = 0; i < size; i += register_width)
  {
    store(values + i, load(factors + i) * load(values + i));
  }
}

void add(int size, double factor, const double* values, double* out)
{
  for (int i = 0; i < size; i += register_width)
  {
    store(out + i, load(out + i) + factor * load(values + i));
  }
}

double dot(int size, const double* a, const double* b)
{
  Register total = {};
  for (int i = 0; i < size; i += register_width)
  {
    total += load(a + i) * load(b + i);
  }
  return sumOf(total);
}

double countBelow(int size, double limit, const double* values)
{
  const Register zero = {}, one = zero + 1;
  Register count = zero;
  for (int i = 0; i < size; i += register_width)
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

CellSum advance(int size, double length, const double* s, const double* q, const double* gap, double* p, double* u)
{
  const Register zero = {}, one = zero + 1;
  Register sum = zero, count = zero;
  for (int i = 0; i < size; i += register_width)
  {
    const Register moved = load(p + i) + length * load(s + i);
    const Register pressure = moved > zero ? moved : zero;
    const Register displacement = load(u + i) + length * load(q + i);
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
  for (int i = 0; i < size; i += register_width)
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

MaskedSums maskedSums(int size, const double* r, const double* z, const double* q)
{
  const Register zero = {}, one = zero + 1;
  Register count = zero, sum_z = zero, sum_q = zero, z_q = zero, z_r = zero;
  for (int i = 0; i < size; i += register_width)
  {
    const Register force = load(r + i);
    const auto free = force != zero;
    const Register direction = free ? load(z + i) : zero, displacement = free ? load(q + i) : zero;
    count += free ? one : zero;
    sum_z += direction;
    sum_q += displacement;
    z_q += direction * displacement;
    z_r += direction * force;
  }
  return {sumOf(count), sumOf(sum_z), sumOf(sum_q), sumOf(z_q), sumOf(z_r)};
}

double trial(int size, const TrialStep& step, const double* r, const double* p, const double* z, const double* last,
             double* out)
{
  const Register zero = {};
  Register sum = zero;
  for (int i = 0; i < size; i += register_width)
  {
    const Register direction = load(z + i) - step.shift + step.beta * load(last + i);
    const Register moved = load(p + i) + (load(r + i) != zero ? step.length * direction : zero);
    const Register kept = moved > zero ? moved : zero;
    store(out + i, kept);
    sum += kept;
  }
  return sumOf(sum);
}

double chord(int size, double scale, const double* r, const double* p, double* trial)
{
  Register slope = {};
  for (int i = 0; i < size; i += register_width)
  {
    const Register step = scale * load(trial + i) - load(p + i);
    store(trial + i, step);
    slope += load(r + i) * step;
  }
  return sumOf(slope);
}

StepSums stepSums(int size, const double* p, const double* s, const double* q)
{
  const Register zero = {};
  Register s_q = zero, fall = zero, of = zero + 1;  // the largest fall is a fraction, because divisions are slow
  for (int i = 0; i < size; i += register_width)
  {
    const Register step = load(s + i), pressure = load(p + i);
    s_q += step * load(q + i);
    const auto is_larger = -step * of > fall * pressure;
    fall = is_larger ? -step : fall;
    of = is_larger ? pressure : of;
  }
  return {sumOf(s_q), maxOf(fall / of)};
}
