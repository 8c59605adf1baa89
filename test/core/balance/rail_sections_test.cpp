// SPDX-License-Identifier: BSD-3-Clause
// A wheelset on rails whose profile changes along the line, and on rails of several parts.
#include "core/track/rail_along.h"
#include "crossing_scene.h"
#include "round_bodies.h"
#include "same_bits.h"

using namespace wheel_rail_contact::core;
using crossing_scene::profileOf;
using crossing_scene::stateOn;

namespace
{
using Placement = RailSections::Placement;

std::shared_ptr<const RailSections> series(const RailSeries& sections, Placement placement)
{
  return std::make_shared<const RailSections>(std::vector<RailSeries>{sections}, placement);
}

/// A cylinder on a rail whose crown changes from a radius of 200 mm at x = 0 to 300 mm at 1 m.
ContactModelConfig fromCrown200To300()
{
  ContactModelConfig config = round_bodies::scene(0);
  config.rail_sections =
      series({{0, profileOf({0, 0, 0.036, 0.2}), {}}, {1, profileOf({0, 0, 0.036, 0.3}), {}}}, Placement::gauge);
  return config;
}

/// Numbers of the patches of the left wheel on wing rail and nose.
struct Carrying
{
  int wing = 0, nose = 0;
  double on_nose = 0;  ///< vertical force on the nose [N]
};

/// @param gap  y of a place between both, in side axes [m]
Carrying carrying(const WheelsetResult& result, double gap)
{
  Carrying found;
  for (const PatchResult* patch : patchesOf(result, Side::left))
  {
    const bool nose = patch->pose.y < gap;
    (nose ? found.nose : found.wing) += 1;
    found.on_nose += nose ? patch->normal_force * std::cos(patch->contact_angle) : 0;
  }
  return found;
}

TEST(Sections, EqualSectionsGiveTheBitsOfTheProfile)
{
  ContactModelConfig plain = manchesterScene(), changing = plain;
  const auto rail = std::make_shared<const Profile>(rail60E1());
  plain.rail_profile = rail;
  changing.rail_profile = std::shared_ptr<const Profile>();
  for (const Placement placement : {Placement::gauge, Placement::coordinates})
  {
    changing.rail_sections = series({{0, rail, {}}, {1, rail, {}}, {5, rail, {}}}, placement);
    for (const bool soft : {false, true})
    {
      plain.rail_bending.model = changing.rail_bending.model =
          soft ? RailBendingConfig::Model::compliance : RailBendingConfig::Model::none;
      plain.rail_bending.table = changing.rail_bending.table = softPads();
      WheelsetContact one(plain), other(changing);
      for (const double x : {0.0, 0.4, 1.0, 3.0, 5.0})
      {
        const WheelsetState state = stateOn(x, 4e-3 * std::sin(x), 1e5);
        const WheelsetResult& result = one.evaluate(state);
        ASSERT_TRUE(isUsable(result.status)) << result.reason;
        expectSameBits(result, other.evaluate(state));
      }
    }
  }
}

// All quantities change monotonously with the radius of the crown.
TEST(Sections, ResultBetweenTwoSectionsLiesBetweenThoseOnThem)
{
  WheelsetContact contact(fromCrown200To300());
  std::vector<WheelTotal> wheels;
  for (const double x : {0.0, 0.2, 0.5, 0.8, 1.0})
  {
    const WheelsetResult& result = okResult(contact, stateOn(x, 0, 8e4));
    wheels.push_back(wheelTotal(result, Side::left));
    EXPECT_NEAR(wheels.back().vertical, 8e4, 1e-3 * 8e4);  // tolerance of the balance: a tenth of contact/tolerance
  }
  for (std::size_t k = 1; k < wheels.size(); ++k)
  {
    EXPECT_LT(wheels[k].max_pressure, wheels[k - 1].max_pressure);
    EXPECT_GT(wheels[k].area, wheels[k - 1].area);
  }
}

// The blend of two arcs of equal width is nearly the arc with the mean of both curvatures at its crown.
TEST(Sections, CurvatureBetweenTwoSectionsIsTheirMean)
{
  const ContactModelConfig config = fromCrown200To300();
  ContactModelConfig mean = round_bodies::scene(0);
  mean.rail_profile = profileOf({0, 0, 0.036, 1 / (0.5 / 0.2 + 0.5 / 0.3)});
  const WheelTotal blend = wheelTotal(WheelsetContact(config).evaluate(stateOn(0.5, 0, 8e4)), Side::left),
                   exact = wheelTotal(WheelsetContact(mean).evaluate(stateOn(0.5, 0, 8e4)), Side::left);
  EXPECT_NEAR(blend.max_pressure / exact.max_pressure, 1, config.contact.tolerance);
  EXPECT_NEAR(blend.area / exact.area, 1, config.contact.tolerance);
}

// Cylinders on two equal heads at the same height: by symmetry each head carries half. The grids of both heads lie
// differently, which changes the force of each by less than the tolerance.
TEST(Sections, TwoSeparateHeadsShareTheLoad)
{
  ContactModelConfig config = round_bodies::scene(0);
  const auto one = profileOf({0, 0, 0.012, 0.15, 0.005}), two = profileOf({0.040, 0, 0.012, 0.15, 0.005});
  config.rail_sections =
      std::make_shared<const RailSections>(std::vector<RailSeries>{{{0, one, {}}}, {{0, two, {}}}}, Placement::gauge);
  WheelsetContact contact(config);
  const double load = 8e4;
  const WheelsetResult& result = okResult(contact, stateOn(3, 0, load));
  for (const Side side : sides)
  {
    const auto patches = patchesOf(result, side);
    ASSERT_EQ(patches.size(), 2U);
    for (const PatchResult* patch : patches)
    {
      EXPECT_NEAR(patch->normal_force, 0.5 * load, config.contact.tolerance * load);
    }
    const double distance = std::abs(patches[1]->pose.y - patches[0]->pose.y);
    EXPECT_NEAR(distance, 0.040, 1e-4);  // each raises the other one's far side: the centre moves by less than a cell
  }
}

TEST(Sections, PlacesOutsideTheSectionsAreOutsideTheLine)
{
  WheelsetContact contact(crossing_scene::scene());
  EXPECT_TRUE(isUsable(contact.evaluate(stateOn(-0.5, 0, 8e4)).status));
  for (const double x : {-0.501, 0.801, 1e9})
  {
    const WheelsetResult& result = contact.evaluate(stateOn(x, 0, 8e4));
    EXPECT_EQ(result.status, ContactStatus::outside_line) << x;
    EXPECT_NE(result.reason.find(" m is outside the sections of the left rail, from -0.5 to 0.8 m"), std::string::npos)
        << result.reason;
    EXPECT_TRUE(result.patches.empty());
  }
  EXPECT_TRUE(isUsable(contact.evaluate(stateOn(0.8, 0, 8e4)).status));
}

TEST(Sections, CrossingOfTheOtherSideGivesTheMirrorImage)
{
  const ContactModelConfig config = crossing_scene::scene();
  WheelsetContact contact(config), image(mirrored(config));
  for (double x = -0.2; x < 0.8; x += 0.06)
  {
    const WheelsetState state = stateOn(x, 2e-3 * std::sin(20 * x), 8e4);
    const WheelsetResult& result = contact.evaluate(state);
    ASSERT_TRUE(isUsable(result.status)) << result.reason;
    expectMirrorImage(result, image.evaluate(mirrored(state)));
  }
}

TEST(Sections, WheelMovesFromWingRailToNose)
{
  WheelsetContact contact(crossing_scene::scene());
  double before = 0;
  bool shared = false;
  for (double x = -0.1; x <= 0.8; x += 0.005)
  {
    const WheelsetResult& result = contact.evaluate(stateOn(x, 0, 8e4));
    ASSERT_TRUE(isUsable(result.status)) << x << ": " << result.reason;
    // Between the nose, which ends at most 60 mm outside the gauge face, and the wing rail, which begins at 0.1 x.
    const double nose_end = std::max(0.0, 0.020 + 0.040 * (x - 0.2) / 0.6), wing_begin = 0.1 * std::max(x, 0.0);
    const Carrying wheel = carrying(result, 0.7175 + 0.5 * (nose_end + wing_begin));
    if (x < crossing_scene::nose_begin)
    {
      EXPECT_EQ(wheel.wing, 1);
      continue;
    }
    shared = shared || (wheel.wing > 0 && wheel.nose > 0);
    // The nose rises and the wheel leaves the wing rail: the share of the nose grows. Errors are below the tolerance.
    EXPECT_GT(wheel.on_nose, before - 0.02 * 8e4) << x;
    before = wheel.on_nose;
  }
  EXPECT_TRUE(shared) << "both carry the wheel at some place";
  EXPECT_NEAR(before, 8e4, 1e-3 * 8e4) << "at the end only the nose does";
}

// Cold and warm results differ as on a constant rail (warm_start_test.cpp). Where a wheel is about to touch a second
// head, the load shared out between both may change with the height by as much as the tolerance of the balance.
TEST(Sections, WarmEqualsColdAlongACrossing)
{
  const ContactModelConfig config = crossing_scene::scene();
  WheelsetContact warm(config), cold(config);
  double largest = 0;
  int beyond = 0, wheels = 0;
  for (double x = -0.1; x <= 0.8; x += 0.0025)
  {
    const WheelsetState state = stateOn(x, 1e-3 * std::sin(5 * x), 8e4);
    cold.reset();
    const WheelsetResult &a = warm.evaluate(state), &b = cold.evaluate(state);
    ASSERT_TRUE(isUsable(a.status) && isUsable(b.status)) << x << ": " << a.reason << b.reason;
    for (const Side side : sides)
    {
      const WheelTotal one = wheelTotal(a, side), other = wheelTotal(b, side);
      const double difference =
          std::max(std::abs(one.max_pressure / other.max_pressure - 1), std::abs(one.area / other.area - 1));
      largest = std::max(largest, difference);
      ++wheels;
      beyond += difference > 0.1 * config.contact.tolerance ? 1 : 0;
    }
  }
  std::printf(
      "warm against cold along a crossing: largest difference %.2g, %d of %d wheels beyond a tenth of the "
      "tolerance\n",
      largest, beyond, wheels);
  EXPECT_LT(largest, config.contact.tolerance);
  EXPECT_LE(beyond, 0.05 * wheels);
}
}  // namespace
