// SPDX-License-Identifier: BSD-3-Clause
// Part of point_forces.cpp, see core/simd/instruction_sets_body.h. No include guard.

using FloatRegister = float __attribute__((vector_size(register_width * sizeof(double))));
using FloatMemory = float __attribute__((vector_size(register_width * sizeof(double)), aligned(sizeof(float))));
using FloatBits = int __attribute__((vector_size(register_width * sizeof(double))));
constexpr int float_width = register_width * static_cast<int>(sizeof(double) / sizeof(float));

inline FloatRegister load(const float* from)
{
  return *reinterpret_cast<const FloatMemory*>(from);
}

inline void store(float* to, FloatRegister value)
{
  *reinterpret_cast<FloatMemory*>(to) = value;
}

/// 1 / sqrt(value), by Newton's method from an approximation by the bits of the number.
inline FloatRegister inverseRoot(FloatRegister value)
{
  constexpr int magic = 0x5F375A86;  // relative error of the first approximation: 3.4 %
  constexpr int newton_steps = 3;    // 1.7e-3, 4.4e-6, rounding
  auto root = reinterpret_cast<FloatRegister>(magic - (reinterpret_cast<FloatBits>(value) >> 1));
  for (int step = 0; step < newton_steps; ++step)
  {
    root = root * (1.5F - 0.5F * value * root * root);
  }
  return root;
}

void pointForces(const PointForces& forces, const PointsBelow& points, PointForceSums& sums)
{
  for (int at = 0; at < point_batch; at += float_width)
  {
    const FloatRegister px = load(points.x.data() + at), py = load(points.y.data() + at);
    const FloatRegister z = load(points.depth.data() + at), zz = z * z;
    FloatRegister one{}, x{}, y{}, xx{}, xy{}, yy{}, chi_xx{}, chi_yy{}, chi_xy{};
    for (std::size_t k = 0; k < forces.count; ++k)
    {
      const FloatRegister dx = px - forces.x[k], dy = py - forces.y[k];
      const FloatRegister square = dx * dx + dy * dy + zz;
      const FloatRegister inverse = inverseRoot(square), r = square * inverse;
      const FloatRegister inverse_sum = 1.0F / (r + z);
      const FloatRegister first = forces.force[k] * inverse, third = first * inverse * inverse;
      const FloatRegister fifth = third * inverse * inverse;
      const FloatRegister fifth_x = fifth * dx, fifth_y = fifth * dy;
      const FloatRegister trace = first * inverse_sum, turned = third * (r + r + z) * inverse_sum * inverse_sum;
      const FloatRegister turned_x = turned * dx;
      one += fifth;
      x += fifth_x;
      y += fifth_y;
      xx += fifth_x * dx;
      xy += fifth_x * dy;
      yy += fifth_y * dy;
      chi_xx += trace - turned_x * dx;
      chi_yy += trace - turned * dy * dy;
      chi_xy -= turned_x * dy;
    }
    store(sums.one.data() + at, one);
    store(sums.x.data() + at, x);
    store(sums.y.data() + at, y);
    store(sums.xx.data() + at, xx);
    store(sums.xy.data() + at, xy);
    store(sums.yy.data() + at, yy);
    store(sums.chi_xx.data() + at, chi_xx);
    store(sums.chi_yy.data() + at, chi_yy);
    store(sums.chi_xy.data() + at, chi_xy);
  }
}

constexpr PointForceKernels kernels = {kernel_name, pointForces};
