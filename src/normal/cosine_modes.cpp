// SPDX-License-Identifier: BSD-3-Clause
#include "cosine_modes.h"

#include <cmath>

namespace wheel_rail_contact
{
namespace
{
const double kPi = std::acos(-1.0);
}

CosineModes::CosineModes(int half_cells)
    : half(half_cells), count(2 * half_cells), value_stride(roundUpToLanes(half)), mode_stride(roundUpToLanes(count))
{
  by_mode.resize(half * mode_stride);
  by_value.resize(count * value_stride);
  sign.resize(value_stride);
  for (int k = 0; k < half; ++k)
  {
    sign[k] = k % 2 == 0 ? 1 : -1;
    for (int place = 0; place < count; ++place)
    {
      const double value = std::cos(kPi * number(0, place) * (k + 0.5) / count);
      by_mode[k * mode_stride + place] = value;
      by_value[place * value_stride + k] = value;
    }
  }
}

int CosineModes::number(int parity, int place) const
{
  const int a = place < half ? 2 * place : 2 * (place - half) + 1;
  return parity == 0 ? a : count - a;
}
}  // namespace wheel_rail_contact
