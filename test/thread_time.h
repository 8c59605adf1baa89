// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace wheel_rail_contact
{
/// Processor time of this thread [s], independent of other processes.
inline double threadTime()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
}  // namespace wheel_rail_contact
