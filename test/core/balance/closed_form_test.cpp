// SPDX-License-Identifier: BSD-3-Clause
// Choice of Hertz's closed form by `method: auto`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <random>
#include <set>
#include <string_view>

#include "../normal/problems.h"
#include "core/balance/grid_levels.h"
#include "round_bodies.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double load = 1e5;  ///< load of each wheel [N]

std::set<std::string_view> methodsOf(const WheelsetResult& result)
{
  std::set<std::string_view> methods;
  std::transform(result.patches.begin(), result.patches.end(), std::inserter(methods, methods.end()),
                 [](const PatchResult& patch) { return patch.method; });
  return methods;
}

const std::set<std::string_view> closed_form{"hertz"}, grids{"conjugate_gradient"};

/// Largest relative difference of pressure, area and approach of a patch from given values [-].
double largestDifference(const PatchResult& found, double max_pressure, double area, double approach)
{
  return std::max({std::abs(found.max_pressure / max_pressure - 1), std::abs(found.area / area - 1),
                   std::abs(found.approach / approach - 1)});
}

// Over a half-width of 6 mm, an arc differs from a parabola by (6 / 300)² / 4 = 1e-4 of its height. The exact solution
// also neglects the curvature of the cone across the track. Limit: 0.1 %.
TEST(ClosedForm, IsChosenBetweenRoundBodiesAndIsAccurate)
{
  for (const double slope : {0.0, 0.05})
  {
    for (const double tolerance : {0.1, 0.01, 0.003})
    {
      ContactModelConfig scene = round_bodies::scene(slope);
      scene.contact.tolerance = tolerance;
      WheelsetContact contact(scene);
      for (const double y : {0.0, 0.05e-3, 2e-3, -1e-3})
      {
        const WheelsetResult& result = contact.evaluate(stateAt(y, load));
        ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
        EXPECT_EQ(methodsOf(result), closed_form) << "y = " << y << ", tolerance " << tolerance;
        const HertzContact exact = round_bodies::exactContact(scene, slope, y, load);
        const PatchResult& left = result.patches.front();
        EXPECT_LT(largestDifference(left, exact.max_pressure, exact.area, exact.approach), 1e-3) << "y = " << y;
        EXPECT_NEAR(left.normal_force, load * std::hypot(1, slope), 1e-4 * load);
      }
    }
  }
}

TEST(ClosedForm, IsNotChosenOnTheTreadOfS1002)
{
  for (const double tolerance : {0.1, 0.03, 0.01, 0.003})
  {
    ContactModelConfig scene = manchesterScene();
    scene.contact.tolerance = tolerance;
    WheelsetContact contact(scene);
    for (const double y : {2.95e-3, 3e-3, 3.05e-3})
    {
      EXPECT_EQ(methodsOf(contact.evaluate(stateAt(y, load))), grids) << "y = " << y << ", tolerance " << tolerance;
    }
  }
}

// A rail that bends under the contact is solved together with it. Hertz's closed form cannot do this.
TEST(ClosedForm, IsNotChosenOnRailsThatBend)
{
  ContactModelConfig scene = round_bodies::scene(0.05);
  scene.rail_bending.model = RailBendingConfig::Model::compliance;
  scene.rail_bending.table = softPads();
  WheelsetContact contact(scene);
  EXPECT_EQ(methodsOf(contact.evaluate(stateAt(0, load))), grids);
}

/// Wheel with one hollow arc of 600 mm, whose slope at the running circle is 0.045.
Profile hollowWheel()
{
  constexpr double radius = 0.6, reach = 0.06;
  const double angle = std::atan(0.045);
  return {"hollow",
          {{ArcSection{radius * std::sin(angle), -radius * std::cos(angle), radius, 0.5 * M_PI + angle + reach / radius,
                       -1},
            2 * reach}}};
}

// On the crown of 300 mm radius, the contact of a hollow tread moves by the same distance as the wheelset, from the
// middle to the transition to the arc of 80 mm. The bodies are round at one end of this motion and not at the other.
// Each result is within the tolerance of 1 %, whatever its method. The reference grid of 64 × 128 cells is accurate to
// 0.2 %.
TEST(ClosedForm, IsReplacedByTheGridAtTheCurvatureDiscontinuity)
{
  ContactModelConfig scene = manchesterScene();
  scene.wheel_profile = std::make_shared<Profile>(hollowWheel());
  WheelsetContact contact(scene);
  scene.contact.method = NormalMethod::conjugate_gradient;
  scene.contact.cells_along = 64;
  scene.contact.cells_across = 128;
  scene.contact.tolerance = 1e-3;
  WheelsetContact fine(scene);
  std::set<std::string_view> seen;
  for (double y = -6e-3; y <= 6e-3; y += 0.5e-3)
  {
    const WheelsetResult &result = contact.evaluate(stateAt(y, 2e4)), &truth = fine.evaluate(stateAt(y, 2e4));
    ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
    ASSERT_EQ(result.patches.size(), truth.patches.size()) << "y = " << y;
    for (std::size_t k = 0; k < result.patches.size(); ++k)
    {
      const PatchResult& fine_patch = truth.patches[k];
      EXPECT_LT(largestDifference(result.patches[k], fine_patch.max_pressure, fine_patch.area, fine_patch.approach),
                0.012)
          << "y = " << y << ", " << result.patches[k].method;
    }
    seen.merge(methodsOf(result));
  }
  EXPECT_EQ(seen, (std::set<std::string_view>{"conjugate_gradient", "hertz"}));
}

// After a start from a rough solution, the closed form is tried at once, even if it has just been rejected.
TEST(ClosedForm, IsTriedAtOnceAfterARestart)
{
  const GridLevels levels{ContactModelConfig()};
  const Grid grid = problems::centredGrid(8, 24, 0.014, 0.014, true);
  const auto gap = [&](double beyond)
  { return problems::sampled(grid, [=](double x, double y) { return x * x + (y < 0 ? 1 : beyond) * y * y; }); };
  const NormalProblem discontinuity = problems::underLoad(gap(2), 5e4), round = problems::underLoad(gap(1), 5e4);
  NormalSolution on_discontinuity, on_round;
  levels.solver().solve(discontinuity, false, on_discontinuity);
  levels.solver().solve(round, false, on_round);
  GridLevelChoice choice(levels, 0.01);
  choice.tryClosedForm(discontinuity, on_discontinuity);
  choice.tryClosedForm(round, on_round);
  EXPECT_FALSE(choice.leaveClosedForm()) << "tried again too soon";
  choice.start(ErrorEstimate());
  choice.tryClosedForm(round, on_round);
  EXPECT_TRUE(choice.leaveClosedForm());
}

// The method may change between two states. A warm and a cold result are each within the tolerance of 1 %.
TEST(ClosedForm, WarmAndColdResultsAgreeAfterJumps)
{
  constexpr unsigned long seed = 41;
  std::cout << "seed " << seed << ", 60 states\n";
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  ContactModelConfig scene = manchesterScene();
  scene.wheel_profile = std::make_shared<Profile>(hollowWheel());
  WheelsetContact warm(scene), cold(scene);
  for (int i = 0; i < 60; ++i)
  {
    const double y = uniform(-6e-3, 6e-3);  // one statement each: compilers evaluate arguments in different orders
    const double wheel_load = uniform(5e3, 150e3);
    const WheelsetState state = stateAt(y, wheel_load, i % 3 == 0 ? uniform(-0.01, 0.01) : 0);
    cold.reset();
    const WheelsetResult &result = warm.evaluate(state), &fresh = cold.evaluate(state);
    ASSERT_EQ(result.status, ContactStatus::ok) << "state " << i << ": " << result.reason;
    ASSERT_EQ(fresh.status, ContactStatus::ok) << "state " << i << ": " << fresh.reason;
    ASSERT_EQ(result.patches.size(), fresh.patches.size()) << "state " << i;
    for (std::size_t k = 0; k < result.patches.size(); ++k)
    {
      const PatchResult& other = fresh.patches[k];
      EXPECT_LT(largestDifference(result.patches[k], other.max_pressure, other.area, other.approach), 0.02)
          << "state " << i;
    }
  }
}
}  // namespace
