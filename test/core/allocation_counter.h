// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
/// Counts the allocations of a test program, including those of Eigen and operator new. To be included in one source of
/// a program: it replaces malloc() and calloc().
namespace
{
volatile long allocations = 0;  // volatile: the compiler may assume that calloc() does not change it
volatile bool counting = false;
}  // namespace

extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_calloc(std::size_t count, std::size_t size);

extern "C" void* malloc(std::size_t size)
{
  allocations = allocations + (counting ? 1 : 0);
  return __libc_malloc(size);
}

extern "C" void* calloc(std::size_t count, std::size_t size)
{
  allocations = allocations + (counting ? 1 : 0);
  return __libc_calloc(count, size);
}
#endif
