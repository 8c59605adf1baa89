// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cerrno>

#include "../usual_headers.h"  // before the definitions: clang declares posix_memalign() there once more

#ifdef __GLIBC__
/// Counts all allocations of a test program, also of Eigen, by functions of its own. For one source of the program.
namespace
{
volatile long allocations = 0;        ///< by malloc() and calloc(), which the compiler may assume not to change it
volatile long other_allocations = 0;  ///< by the other functions
volatile bool counting = false;

void countIn(volatile long& number)
{
  number = number + (counting ? 1 : 0);
}

/// Number of all allocations of a call.
template <typename Call>
long allocationsOf(const Call& call)
{
  allocations = other_allocations = 0;
  counting = true;
  call();
  counting = false;
  return allocations + other_allocations;
}
}  // namespace

extern "C"
{
  void* __libc_malloc(std::size_t size);
  void* __libc_calloc(std::size_t count, std::size_t size);
  void* __libc_realloc(void* memory, std::size_t size);
  void* __libc_memalign(std::size_t alignment, std::size_t size);

  void* malloc(std::size_t size)
  {
    countIn(allocations);
    return __libc_malloc(size);
  }
  void* calloc(std::size_t count, std::size_t size)
  {
    countIn(allocations);
    return __libc_calloc(count, size);
  }
  void* realloc(void* memory, std::size_t size)
  {
    countIn(other_allocations);
    return __libc_realloc(memory, size);
  }
  void* aligned_alloc(std::size_t alignment, std::size_t size)
  {
    countIn(other_allocations);
    return __libc_memalign(alignment, size);
  }
  int posix_memalign(void** memory, std::size_t alignment, std::size_t size)
  {
    countIn(other_allocations);
    *memory = __libc_memalign(alignment, size);
    return *memory ? 0 : ENOMEM;
  }
}

TEST(AllocationCounter, CountsEachAllocation)
{
  void* volatile memory = nullptr;  // volatile: an optimizer may remove the unused allocation
  EXPECT_EQ(allocationsOf([&] { memory = std::malloc(16); }), 1);
  std::free(memory);
  EXPECT_EQ(allocationsOf([&] { memory = std::calloc(2, 8); }), 1);
  std::free(memory);
  Eigen::ArrayXXd array;
  std::unique_ptr<int> number;
  EXPECT_EQ(allocationsOf([&] { array.setZero(8, 8); }), 1);
  EXPECT_EQ(allocationsOf([&] { number = std::make_unique<int>(1); }), 1);
}
#endif
