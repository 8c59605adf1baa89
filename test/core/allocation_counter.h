// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
/// Counts the allocations of a test program, including those of Eigen and operator new. To be included in one source of
/// a program: it replaces malloc().
namespace
{
long allocations = 0;
bool counting = false;
}  // namespace

extern "C" void* __libc_malloc(std::size_t size);

extern "C" void* malloc(std::size_t size)
{
  allocations += counting ? 1 : 0;
  return __libc_malloc(size);
}
#endif
