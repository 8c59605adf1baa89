// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/scene_colors.h"

#include <algorithm>
#include <array>

namespace wheel_rail_contact
{
namespace
{
using Polynomial = std::array<double, 7>;  ///< coefficients of t^0 ... t^6

constexpr Polynomial red{0.2745, 0.1077, -0.3272, -4.5999, 6.2037, 4.7518, -5.4321};
constexpr Polynomial green{0.0058, 1.3965, 0.2148, -5.7582, 14.154, -13.7494, 4.6416};
constexpr Polynomial blue{0.3327, 1.3868, 0.092, -19.2918, 56.6563, -65.321, 26.2721};

double evaluate(const Polynomial& polynomial, double t)
{
  double value = 0;
  for (auto coefficient = polynomial.rbegin(); coefficient != polynomial.rend(); ++coefficient)
  {
    value = value * t + *coefficient;
  }
  return std::clamp(value, 0.0, 1.0);
}
}  // namespace

std_msgs::ColorRGBA colorOf(double value)
{
  const double t = value > 0 ? std::min(value, 1.0) : 0.0;  // 0 for NaN
  return makeColor(evaluate(red, t), evaluate(green, t), evaluate(blue, t));
}
}  // namespace wheel_rail_contact
