// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/root_bracket.h"

#include "../../usual_headers.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Number of evaluations until the zero of a function is known to 1e-9; the Newton steps are those of a slope.
template <typename Function>
int evaluations(double x, double slope, double zero, const Function& function)
{
  RootBracket bracket;
  int count = 0;
  for (; count < 100 && !(bracket.width() < 1e-9) && std::abs(x - zero) > 1e-10; ++count)
  {
    bracket.add(x, function(x));
    x = bracket.next(x, -function(x) / slope);
  }
  EXPECT_NEAR(x, zero, 1e-9);
  return count;
}
}  // namespace

TEST(RootBracketTest, TakesNewtonStepsOnlyWhileTheyHalveTheFunction)
{
  EXPECT_LE(evaluations(3, -2.5, 1, [](double x) { return 2 * (1 - x); }), 15);
  // A slope that is half of the true one makes Newton's method swing about the zero without end.
  EXPECT_LE(evaluations(1.5, -1, 1, [](double x) { return 1.95 * (1 - x); }), 6);
  EXPECT_LE(evaluations(0, -1, 0.3, [](double x) { return x < 0.3 ? 1 - x : -5 - x; }), 70);
}
}  // namespace wheel_rail_contact::core
