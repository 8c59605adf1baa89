// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/lanes.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
namespace baseline
{
constexpr int register_width = 2;
constexpr const char* kernel_name = "baseline";
#include "core/normal/operator/lanes_body.h"
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define WHEEL_RAIL_CONTACT_WIDE_REGISTERS
#pragma GCC push_options
#pragma GCC target("avx,fma")
namespace avx
{
constexpr int register_width = 4;
constexpr const char* kernel_name = "avx";
#include "core/normal/operator/lanes_body.h"
}  // namespace avx
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f")
namespace avx512
{
constexpr int register_width = 8;
constexpr const char* kernel_name = "avx512";
#include "core/normal/operator/lanes_body.h"
}  // namespace avx512
#pragma GCC pop_options
#endif
}  // namespace

void LaneBuffer::resize(int size)
{
  if (size == size_)
  {
    return;
  }
  if (size > capacity_)
  {
    const std::size_t bytes = static_cast<std::size_t>(size) * sizeof(double);
    data_.reset(static_cast<double*>(::operator new[](bytes, std::align_val_t{lane_padding * sizeof(double)})));
    capacity_ = size;
  }
  size_ = size;
  std::fill_n(data_.get(), size, 0.0);
}

std::vector<const LaneKernels*> supportedLaneKernels()
{
  std::vector<const LaneKernels*> supported;
#ifdef WHEEL_RAIL_CONTACT_WIDE_REGISTERS
  if (__builtin_cpu_supports("avx512f"))
  {
    supported.push_back(&avx512::kernels);
  }
  if (__builtin_cpu_supports("avx") && __builtin_cpu_supports("fma"))
  {
    supported.push_back(&avx::kernels);
  }
#endif
  supported.push_back(&baseline::kernels);
  return supported;
}

const LaneKernels& laneKernels()
{
  static const LaneKernels& kernels = *supportedLaneKernels().front();
  return kernels;
}
}  // namespace wheel_rail_contact::core
