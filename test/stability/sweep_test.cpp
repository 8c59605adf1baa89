// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.h"
#include "../core/balance/wheelset_scene.h"
#include "../refusal.h"
#include "../temporary_folder.h"
#include "random_scene.h"
#include "result_check.h"
#include "scene_file.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
std::string textOf(const Scene& scene)
{
  std::ostringstream text;
  writeScene(text, scene);
  return text.str();
}

Scene read(const std::string& text)
{
  return readScene(Folder().write("scene.yaml", text));
}

void expectRefusal(const std::string& text, const std::string& message)
{
  EXPECT_TRUE(contains(refusalOf([&] { read(text); }), message));
}

/// The first result of a scene. A different number in the configuration or in the state changes its last digits.
WheelsetResult firstResult(const Scene& scene)
{
  return WheelsetContact(scene.config).evaluate(scene.states.front());
}

/// The twenty scenes contain profiles from points, all rail models and kinds of lateral force, and given grids.
TEST(SceneFile, GivesTheSameNumbersWhenReadBack)
{
  const ScenePool pool = readScenePool();
  for (unsigned long number = 1; number <= 20; ++number)
  {
    SCOPED_TRACE(number);
    const Scene scene = randomScene(pool, number);
    const Scene copy = read(textOf(scene));
    EXPECT_EQ(textOf(copy), textOf(scene));
    ASSERT_EQ(copy.states.size(), scene.states.size());
    const auto values = [](const WheelsetState& one)
    { return std::make_tuple(one.y, one.z, one.yaw, one.roll, one.force_z, one.torque_x, one.rail_lateral_force); };
    for (std::size_t k = 0; k < scene.states.size(); ++k)
    {
      EXPECT_EQ(values(copy.states[k]), values(scene.states[k]));
    }
    const WheelsetResult expected = firstResult(scene), found = firstResult(copy);
    EXPECT_EQ(found.status, expected.status);
    EXPECT_EQ(found.z, expected.z);
    ASSERT_EQ(found.patches.size(), expected.patches.size());
    for (std::size_t k = 0; k < found.patches.size(); ++k)
    {
      EXPECT_EQ(found.patches[k].max_pressure, expected.patches[k].max_pressure);
    }
  }
}

TEST(SceneFile, KeepsTheOffsetOfTheRails)
{
  Scene scene = randomScene(readScenePool(), 1);
  scene.states.resize(1);
  scene.states[0].rail_displacement.right = {1.0 / 3, -2e-5, 1e-300};
  const RailDeflection offset = read(textOf(scene)).states[0].rail_displacement.right;
  EXPECT_EQ(offset.lateral, 1.0 / 3);
  EXPECT_EQ(offset.vertical, -2e-5);
  EXPECT_EQ(offset.roll, 1e-300);
}

TEST(SceneFile, IsRefusedWithTheNameOfTheWrongKey)
{
  const std::string profiles = "wheel: {profile: S1002}\nrail: {profile: 60E1}\n", states = "states: [{y: 0.001}]\n";
  EXPECT_EQ(read(profiles + states).states[0].y, 0.001);
  expectRefusal(profiles, "states is missing");
  expectRefusal(profiles + "states: []\n", "states");
  expectRefusal(profiles + "states: [{height: 1}]\n", "states/height is unknown");
  expectRefusal(profiles + "states: [{y: left}]\n", "states/y = left must be a finite number");
  expectRefusal("rail: {profile: 60E1}\n" + states, "wheel/profile is missing");
  expectRefusal(profiles + states + "contact: {methods: auto}\n", "contact/methods is unknown");
  expectRefusal(profiles + states + "rail_bending: {model: compliance}\n", "lateral_lateral is missing");
}

// Wheelsets that move to and fro: forces are continuous at the onset of a contact, and where two equilibria exist, both
// ways lead to one of them.

/// Number of jumps on a way.
int jumpsOf(const Sweep& sweep, const std::vector<SweepState>& way)
{
  int jumps = 0;
  for (std::size_t k = 1; k < way.size(); ++k)
  {
    jumps += lateralStep(way[k - 1], way[k]) > jump * sweep.wheel_load ? 1 : 0;
  }
  return jumps;
}

/// Moves a wheelset from one state of a sweep to another one.
const WheelsetResult& moved(WheelsetContact& contact, const Sweep& sweep, int from, int to)
{
  const int direction = to > from ? 1 : -1;
  for (int k = from; k != to; k += direction)
  {
    contact.evaluate(stateAt(sweep.at(k), sweep.wheel_load));
  }
  return contact.evaluate(stateAt(sweep.at(to), sweep.wheel_load));
}

/// Change of the height at which a wheel carries its load, per roll of the axle, on a rigid rail [m/rad].
double heightPerRoll(WheelsetContact& contact, Side side)
{
  const Eigen::Matrix3d stiffness = contact.stiffness(side);
  return -stiffness(1, 2) / stiffness(1, 1);
}

std::vector<Sweep> sweepsWith(bool two_equilibria)
{
  std::vector<Sweep> chosen = sweeps();
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                              [&](const Sweep& sweep) { return sweep.two_equilibria != two_equilibria; }),
               chosen.end());
  return chosen;
}

TEST(Sweep, EachStateHasAResultAfterFewNormalProblems)
{
  for (const Sweep& sweep : sweeps())
  {
    const SweepResult result = run(sweep);
    std::printf("%s: largest step %.3g N out, %.3g N back, %d normal problems\n", sweep.name.c_str(),
                largestStep(result.out), largestStep(result.back), mostSolutions(result));
    EXPECT_EQ(refused(result), 0) << sweep.name;
    // A jump needs 30 to 60. The limits of the search would allow for thousands.
    EXPECT_LE(mostSolutions(result), sweep.two_equilibria ? 120 : 20) << sweep.name;
  }
}

// Out and back differ by a tenth of the tolerance of the load at most, and there is no jump.
TEST(Sweep, OneEquilibriumDoesNotDependOnTheDirection)
{
  for (const Sweep& sweep : sweepsWith(false))
  {
    const SweepResult result = run(sweep);
    for (std::size_t k = 0; k < result.out.size(); ++k)
    {
      const double size = std::max({sweep.wheel_load, result.out[k].lateral.left, result.out[k].lateral.right});
      EXPECT_LT(lateralStep(result.out[k], result.back[k]), 0.1 * sweep.config.contact.tolerance * size)
          << sweep.name << ", y " << sweep.at(static_cast<int>(k));
    }
    EXPECT_EQ(jumpsOf(sweep, result.out) + jumpsOf(sweep, result.back), 0) << sweep.name;
  }
}

// A second contact begins without a force. The lateral force grows by 2 N in 1 µm before it, and by 20 N when it is
// complete. The rest of the limit, a fifth of the tolerance, is for other grids.
TEST(Sweep, ForcesAreContinuousAtTheOnsetOfAContact)
{
  const Sweep sweep = sweeps().front();
  WheelsetContact contact(sweep.config);
  EXPECT_EQ(wheelTotal(contact.evaluate(stateAt(sweep.begin, sweep.wheel_load)), Side::left).patches, 1);
  EXPECT_EQ(wheelTotal(moved(contact, sweep, 0, sweep.steps()), Side::left).patches, 2);
  const SweepResult result = run(sweep);
  const double limit = 0.2 * sweep.config.contact.tolerance * sweep.wheel_load;
  EXPECT_LT(largestStep(result.out), limit);
  EXPECT_LT(largestStep(result.back), limit);
}

// Hysteresis: on the way out the flange holds the wheel down longer than it would catch it on the way back.
TEST(Sweep, TwoEquilibriaFormALoop)
{
  for (const Sweep& sweep : sweepsWith(true))
  {
    const SweepResult result = run(sweep);
    const Loop loop = loopOf(sweep, result);
    ASSERT_LT(loop.first, loop.last) << sweep.name;
    EXPECT_GT(loop.first, 0) << sweep.name;
    EXPECT_LT(loop.last, sweep.steps()) << sweep.name;
    EXPECT_EQ(jumpsOf(sweep, result.out), 1) << sweep.name;
    EXPECT_EQ(jumpsOf(sweep, result.back), 1) << sweep.name;
    for (int k = loop.first; k <= loop.last; ++k)
    {
      const auto at = static_cast<std::size_t>(k);
      EXPECT_LT(result.out[at].height, result.back[at].height) << sweep.name << ", y " << sweep.at(k);
    }
  }
}

// Checked without the solver: loads, rail deflections and contact conditions of both results in the middle of a loop.
// The limit is three tolerances, because penetration, roll and rail deflection have errors of up to one each.
TEST(Sweep, BothResultsOfALoopAreEquilibria)
{
  for (const Sweep& sweep : sweepsWith(true))
  {
    const Loop loop = loopOf(sweep, run(sweep));
    const int middle = (loop.first + loop.last) / 2;
    for (const int from : {0, sweep.steps()})
    {
      WheelsetContact contact(sweep.config);
      const WheelsetResult& result = moved(contact, sweep, from, middle);
      ResultCheck check(contact.config());
      EXPECT_TRUE(isUsable(result.status)) << sweep.name << ": " << result.reason;
      for (const std::string& fault : check.faults(stateAt(sweep.at(middle), sweep.wheel_load), result))
      {
        ADD_FAILURE() << sweep.name << " from " << sweep.at(from) << ": " << fault;
      }
      EXPECT_LT(check.violation(), 3 * sweep.config.contact.tolerance) << sweep.name << " from " << sweep.at(from);
      if (sweep.config.rail_bending.model == RailBendingConfig::Model::none)
      {
        // A larger roll lowers the left contact relative to the right one: the moment of the loads turns it back.
        EXPECT_LT(heightPerRoll(contact, Side::left), heightPerRoll(contact, Side::right)) << sweep.name;
      }
    }
  }
}

// In the middle of a loop the other equilibrium is found from both ways; outside of the loop there is none.
TEST(Sweep, CheckBranchesFindsTheOtherEquilibriumInALoop)
{
  for (Sweep sweep : sweepsWith(true))
  {
    const Loop loop = loopOf(sweep, run(sweep));
    sweep.config.contact.check_branches = true;
    for (const int from : {0, sweep.steps()})
    {
      WheelsetContact contact(sweep.config);
      EXPECT_FALSE(contact.evaluate(stateAt(sweep.at(from), sweep.wheel_load)).near_branch) << sweep.name;
      const WheelsetResult& result = moved(contact, sweep, from, (loop.first + loop.last) / 2);
      EXPECT_TRUE(result.near_branch) << sweep.name << " from " << sweep.at(from);
      EXPECT_NE(result.reason.find("another equilibrium"), std::string::npos) << result.reason;
    }
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core::stability
