// SPDX-License-Identifier: BSD-3-Clause
// Compiles kernels for several instruction sets. A source defines KERNELS_BODY, a file that defines `constexpr ...
// kernels`, and includes this file in a namespace of its own within an anonymous one. Each body is in a namespace that
// defines register_width (doubles in a register) and kernel_name. No include guard.

namespace baseline
{
constexpr int register_width = 2;
constexpr const char* kernel_name = "baseline";
#include KERNELS_BODY
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define WHEEL_RAIL_CONTACT_WIDE_REGISTERS
#pragma GCC push_options
#pragma GCC target("avx,fma")
namespace avx
{
constexpr int register_width = 4;
constexpr const char* kernel_name = "avx";
#include KERNELS_BODY
}  // namespace avx
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f")
namespace avx512
{
constexpr int register_width = 8;
constexpr const char* kernel_name = "avx512";
#include KERNELS_BODY
}  // namespace avx512
#pragma GCC pop_options
#endif

/// Kernels that this processor supports, widest registers first.
auto supportedKernels()
{
  std::vector<decltype(&baseline::kernels)> supported;
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
#undef KERNELS_BODY
