// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Compiles a function, and what is inlined into it, for several instruction sets. The loader chooses one. The function
/// consists of loops that the compiler can vectorise. Sanitizers do not work with such a choice, nor does GCC 10 with
/// -fno-semantic-interposition: it "cannot create clones" of a function that other sources call.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && __GNUC__ > 10 && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WHEEL_RAIL_CONTACT_WIDE __attribute__((flatten, target_clones("avx512f", "arch=haswell", "default")))
#else
#define WHEEL_RAIL_CONTACT_WIDE
#endif
