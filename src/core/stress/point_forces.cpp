// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/point_sources.h"

namespace wheel_rail_contact::core
{
namespace
{
namespace point_force_sets
{
#define KERNELS_BODY "core/stress/point_forces_body.h"
#include "core/simd/instruction_sets_body.h"
}  // namespace point_force_sets
}  // namespace

std::vector<const PointForceKernels*> supportedPointForceKernels()
{
  return point_force_sets::supportedKernels();
}

const PointForceKernels& pointForceKernels()
{
  static const PointForceKernels& kernels = *supportedPointForceKernels().front();
  return kernels;
}
}  // namespace wheel_rail_contact::core
