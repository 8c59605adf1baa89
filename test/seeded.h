// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "usual_headers.h"

namespace wheel_rail_contact::core
{
/// Random numbers that are the same in each run. A failure that occurs while they exist prints the seed.
template <typename Generator>
class SeededNumbers : public Generator
{
 public:
  explicit SeededNumbers(unsigned seed) : Generator(seed), trace_(__FILE__, __LINE__, "seed " + std::to_string(seed)) {}

  double within(double low, double high) { return std::uniform_real_distribution<double>(low, high)(*this); }
  double unit() { return within(-1, 1); }

 private:
  testing::ScopedTrace trace_;
};
using Seeded = SeededNumbers<std::mt19937>;
using Seeded64 = SeededNumbers<std::mt19937_64>;
}  // namespace wheel_rail_contact::core
