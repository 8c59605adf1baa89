// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/lanes.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
namespace lane_sets
{
#define KERNELS_BODY "core/normal/operator/lanes_body.h"
#include "core/simd/instruction_sets_body.h"
}  // namespace lane_sets
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
  return lane_sets::supportedKernels();
}

const LaneKernels& laneKernels()
{
  static const LaneKernels& kernels = *supportedLaneKernels().front();
  return kernels;
}
}  // namespace wheel_rail_contact::core
