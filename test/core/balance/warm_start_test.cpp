// SPDX-License-Identifier: BSD-3-Clause
#include "same_bits.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
/// Loaded interval of a patch across the track [m].
struct LoadedInterval
{
  explicit LoadedInterval(const PatchResult& patch)
  {
    for (int j = 0; j < patch.grid.ny; ++j)
    {
      if (patch.pressure.col(j).maxCoeff() > 0)
      {
        const double y = patch.pose.y + patch.grid.y(j) * std::cos(patch.pose.angle);
        begin = std::min(begin, y);
        end = std::max(end, y);
      }
    }
  }
  double begin = INFINITY, end = -INFINITY;
};

bool liesBeside(const PatchResult& one, const PatchResult& other)
{
  const LoadedInterval a(one), b(other);
  return a.end < b.begin || b.end < a.begin;
}

/// States that differ strongly from one another.
const WheelsetState varied_states[] = {stateAt(0, 1e5), stateAt(3e-3, 2e4), stateAt(-5.2e-3, 1e5, 0.005),
                                       stateAt(7e-3, 8e4), stateAt(-1e-3, 1e3)};

class WarmStartTest : public testing::Test
{
 protected:
  /// Differences of warm and cold results along a sweep: largest one of pressure and area, relative, and number of
  /// wheels for which one of them or the height differs by more than a tenth of the tolerance.
  struct Difference
  {
    double largest = 0;
    int wheels = 0, beyond = 0;
  };

  Difference sweep(double amplitude)
  {
    WheelsetContact warm(scene_), cold(scene_);
    Difference difference;
    for (int i = 0; i <= 120; ++i)
    {
      const WheelsetState state = stateAt(amplitude * (1 - std::abs(i / 60.0 - 1)), 1e5);
      cold.reset();
      const WheelsetResult &a = okResult(warm, state), &b = okResult(cold, state);
      const double height = std::abs(a.z - b.z) / overlap;
      for (const Side side : {Side::left, Side::right})
      {
        const WheelTotal from_warm = wheelTotal(a, side), from_cold = wheelTotal(b, side);
        const double here = std::max({height, std::abs(from_warm.max_pressure / from_cold.max_pressure - 1),
                                      std::abs(from_warm.area / from_cold.area - 1)});
        difference.largest = std::max(difference.largest, here);
        difference.wheels += 1;
        difference.beyond += here > 0.1 * scene_.contact.tolerance ? 1 : 0;
      }
    }
    return difference;
  }

  static constexpr double overlap = 1e-4;  ///< typical one [m]
  ContactModelConfig scene_ = manchesterScene();
};
}  // namespace

// Steps of 0.05 to 0.1 mm, both ways. A grid follows from the state alone; the start of the search may change the
// result by a tenth of the tolerance. Where it leads to a grid of the next size, the difference is the error of the
// grids.
TEST_F(WarmStartTest, WarmResultsEqualColdResultsWithinATenthOfTheTolerance)
{
  for (const double amplitude : {3e-3, 6e-3})
  {
    for (const double tolerance : {0.01, 0.003})
    {
      scene_.contact.tolerance = tolerance;
      const Difference found = sweep(amplitude);
      std::printf("sweep of %g mm at tolerance %g: warm against cold %.2g, %d of %d wheels beyond a tenth of it\n",
                  amplitude * 1e3, tolerance, found.largest, found.beyond, found.wheels);
      EXPECT_LT(found.largest, 0.5 * tolerance);
      EXPECT_LE(found.beyond, 0.05 * found.wheels);
    }
  }
}

TEST_F(WarmStartTest, SameMessagesGiveTheSameBits)
{
  WheelsetContact first(scene_), second(scene_);
  for (const WheelsetState& state : varied_states)
  {
    expectSameBits(first.evaluate(state), second.evaluate(state));
  }
}

TEST_F(WarmStartTest, YawHasNoEffectAfterItHasEnded)
{
  // Without yaw both bodies are symmetric about x = 0. A yawed wheel touches at an x of up to yaw * 0.46 m times the
  // slope. Half a patch laid there would be mirrored at the wrong position.
  const WheelsetState straight = stateAt(6e-3, 1e5);
  WheelsetContact warm(scene_), cold(scene_);
  warm.evaluate(stateAt(6e-3, 1e5, 0.02));
  const WheelsetResult& found = warm.evaluate(straight);
  const WheelsetResult& expected = cold.evaluate(straight);
  ASSERT_EQ(found.patches.size(), expected.patches.size());
  for (std::size_t k = 0; k < found.patches.size(); ++k)
  {
    EXPECT_EQ(found.patches[k].pose.x, 0);
    EXPECT_NEAR(found.patches[k].max_pressure / expected.patches[k].max_pressure, 1, 0.1 * scene_.contact.tolerance);
  }
}

// Repeated messages: the result does not drift.
TEST_F(WarmStartTest, SteadySceneIsSteady)
{
  WheelsetContact contact(scene_);
  for (const WheelsetState& state : varied_states)
  {
    contact.reset();
    const WheelsetResult first = contact.evaluate(state);
    double low = 1e20;
    double high = 0;
    for (int i = 0; i < 50; ++i)
    {
      const double pressure = wheelTotal(contact.evaluate(state), Side::left).max_pressure;
      low = std::min(low, pressure);
      high = std::max(high, pressure);
    }
    EXPECT_LT(high / low - 1, 0.1 * scene_.contact.tolerance) << "at y " << state.y;
    EXPECT_NEAR(contact.evaluate(state).z, first.z, 0.1 * scene_.contact.tolerance * 1e-4);
  }
}

// An invalid message must not affect the following results.
TEST_F(WarmStartTest, GoodResultFollowsABadMessage)
{
  WheelsetContact contact(scene_), undisturbed(scene_);
  contact.evaluate(stateAt(1e-3, 1e5));
  undisturbed.evaluate(stateAt(1e-3, 1e5));
  EXPECT_EQ(contact.evaluate(stateAt(std::nan(""), 1e5)).status, ContactStatus::invalid_input);
  expectSameBits(contact.evaluate(stateAt(1.05e-3, 1e5)), undisturbed.evaluate(stateAt(1.05e-3, 1e5)));
}

// The grid of one contact may reach over the next contact, whose pressure must count in its own patch only.
TEST_F(WarmStartTest, NoContactIsCountedInTwoPatches)
{
  struct Place
  {
    std::shared_ptr<const Profile> rail;
    double y, yaw, force_z, gauge, inclination;
  };
  const auto uic60 = scene_.rail_profile.left;
  const auto rail_60e1 = std::make_shared<const Profile>(rail60E1());
  const Place places[] = {{uic60, -5.152e-3, -15.431e-3, -41711, 1.432924, 1.0 / 40},
                          {rail_60e1, -4.598e-3, 17.928e-3, -296284, 1.432, 1.0 / 20},
                          {uic60, -5.775e-3, -0.796e-3, -257755, 1.434076, 1.0 / 20},
                          {rail_60e1, -3.680e-3, 3.665e-3, -109143, 1.430310, 1.0 / 20}};
  for (const Place& place : places)
  {
    scene_.rail_profile = place.rail;
    scene_.track.gauge = place.gauge;
    scene_.track.rail_inclination = place.inclination;
    WheelsetContact warm(scene_), cold(scene_);
    WheelsetState state{};
    state.yaw = place.yaw;
    state.force_z = place.force_z;
    for (int i = 8; i >= 0; --i)
    {
      state.y = place.y - 5e-5 * i;
      warm.evaluate(state);
    }
    SCOPED_TRACE(testing::Message() << "y " << place.y << " yaw " << place.yaw);
    for (const WheelsetResult* result : {&okResult(warm, state), &okResult(cold, state)})
    {
      EXPECT_GE(wheelTotal(*result, Side::right).patches, 2);
      for (std::size_t k = 1; k < result->patches.size(); ++k)
      {
        if (result->patches[k].side == result->patches[k - 1].side)
        {
          EXPECT_TRUE(liesBeside(result->patches[k - 1], result->patches[k]));
        }
      }
    }
  }
}

// A yawed wheel comes nearest to the gauge corner in front of the contact of the tread. A second lobe lies there.
TEST_F(WarmStartTest, PressureInFrontOfTheTreadContactIsNotMissed)
{
  scene_.track.gauge = 1.430977;
  scene_.track.rail_inclination = 1.0 / 20;
  ContactModelConfig fine = scene_;
  fine.contact = {NormalMethod::conjugate_gradient, 1e-3, 128, 256};
  WheelsetContact warm(scene_), truth(fine);
  WheelsetState state{};
  state.yaw = 13.067e-3;
  state.force_z = -99775;
  for (const int offset : {0, 1, 0, -1, 0, 1})
  {
    state.y = 4.310e-3 + 5e-5 * offset;
    truth.reset();
    const WheelsetResult& found = okResult(warm, state);
    const WheelsetResult& expected = okResult(truth, state);
    const double error =
        std::abs(wheelTotal(found, Side::left).max_pressure / wheelTotal(expected, Side::left).max_pressure - 1);
    double estimate = 0;
    for (const PatchResult& patch : found.patches)
    {
      estimate = patch.side == Side::left ? std::max(estimate, patch.error_estimate) : estimate;
    }
    EXPECT_LT(error, std::max(estimate, scene_.contact.tolerance)) << "above the estimate, at offset " << offset;
    EXPECT_LT(error, 0.05) << "at offset " << offset;
  }
}

TEST(ResetTest, AfterAResetResultsEqualThoseOfANewObject)
{
  const ContactModelConfig scene = manchesterScene();
  WheelsetContact used(scene);
  for (const WheelsetState& state : varied_states)
  {
    for (const WheelsetState& before : varied_states)
    {
      used.evaluate(before);
    }
    used.reset();
    WheelsetContact fresh(scene);
    expectSameBits(used.evaluate(state), fresh.evaluate(state));
  }
}

// At y = 95 mm a wheel is beside its rail.
TEST(ResetTest, AFailureWithGivenHeightOnBendingRailsHasNoLastingEffect)
{
  ContactModelConfig scene = onPads(softPads());
  WheelsetContact by_load(scene);
  WheelsetState given = stateAt(2e-3, 1e5);
  const WheelsetResult& found = by_load.evaluate(given);
  given.z = found.z;
  given.roll = found.roll;
  scene.wheelset.solve_height_and_roll = false;
  WheelsetState lost = given;
  lost.y = 0.095;

  WheelsetContact used(scene);
  EXPECT_FALSE(isUsable(used.evaluate(lost).status));
  used.reset();
  WheelsetContact fresh(scene);
  const WheelsetResult& result = used.evaluate(given);
  ASSERT_TRUE(isUsable(result.status)) << result.reason;
  expectSameBits(result, fresh.evaluate(given));
}
