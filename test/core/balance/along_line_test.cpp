// SPDX-License-Identifier: BSD-3-Clause
#include "../../seeded.h"
#include "core/balance/rail_support.h"
#include "core/track/rail_along.h"
#include "crossing_scene.h"
#include "round_bodies.h"
#include "same_bits.h"

using namespace wheel_rail_contact::core;
using crossing_scene::profileOf;
using crossing_scene::stateOn;

// A wheelset on a track with irregularities.
namespace
{
std::shared_ptr<const TrackLine> lineOf(const std::vector<LineStation>& stations)
{
  return std::make_shared<TrackLine>("line", stations);
}

/// The line in a mirror along the track.
std::shared_ptr<const TrackLine> mirrored(std::vector<LineStation> stations)
{
  for (LineStation& station : stations)
  {
    station.cross_level = -station.cross_level;
    std::swap(station.rail.left, station.rail.right);
  }
  return lineOf(stations);
}

class LineTest : public testing::Test
{
 protected:
  LineTest()
  {
    for (int i = 0; i <= 80; ++i)
    {
      const auto rail = [this] { return RailDeflection{within(2e-3), within(3e-3), within(2e-3)}; };
      stations_.push_back({0.25 * i, within(5e-3), {rail(), rail()}});
    }
  }

  double within(double limit) { return random_.within(-limit, limit); }
  /// States of a wheelset that runs over the line, `step` [m] apart.
  std::vector<WheelsetState> run(double step)
  {
    std::vector<WheelsetState> states;
    for (double distance = 0; distance <= stations_.back().x; distance += step)
    {
      WheelsetState state = stateAt(2e-3 * std::sin(0.7 * distance), 1e5, 1e-3 * std::cos(0.7 * distance));
      state.torque_x = 1e4 * std::sin(0.3 * distance);
      state.x = state.distance = distance;
      states.push_back(state);
    }
    return states;
  }
  /// Adds the displacements by the line to those of a state.
  WheelsetState displaced(WheelsetState state, const TrackLine& line) const
  {
    const auto reference = [this](Side side) { return restingRail(scene_, side).referencePoint(); };
    const auto rails = displacementsAt(line.at(state.distance), {reference(Side::left), reference(Side::right)});
    state.rail_displacement.left += rails.left;
    state.rail_displacement.right += rails.right;
    return state;
  }
  ContactModelConfig sceneOn(std::shared_ptr<const TrackLine> line) const
  {
    ContactModelConfig scene = scene_;
    scene.track.line = std::move(line);
    return scene;
  }

  Seeded random_{20111U};
  std::vector<LineStation> stations_;  ///< random, 0.25 m apart
  ContactModelConfig scene_ = manchesterScene();
};

TEST_F(LineTest, WhereRailsAreStraightTheResultIsThatOfTheSameDisplacementGivenWithTheState)
{
  std::vector<LineStation> pieces;  // each straight about a station
  for (std::size_t i = 0; i < 2 * stations_.size(); ++i)
  {
    pieces.push_back(stations_[i / 2]);
    pieces.back().x += i % 2 == 0 ? -0.05 : 0.05;
  }
  for (const bool soft : {false, true})
  {
    SCOPED_TRACE(soft ? "soft rails" : "rigid rails");
    scene_.rail_bending.model = soft ? RailBendingConfig::Model::compliance : RailBendingConfig::Model::none;
    scene_.rail_bending.table = softPads();
    WheelsetContact on_line(sceneOn(lineOf(pieces))), given(scene_);
    for (WheelsetState state : run(0.25))
    {
      SCOPED_TRACE("distance " + std::to_string(state.distance));
      state.rail_displacement.left = {within(1e-3), within(1e-3), within(1e-3)};  // is added to that of the line
      const WheelsetResult& a = on_line.evaluate(state);
      const WheelsetResult& b = given.evaluate(displaced(state, *on_line.config().track.line));
      ASSERT_TRUE(isUsable(a.status)) << a.reason;
      expectSameBits(a, b);
      for (const Side side : sides)
      {
        EXPECT_EQ(toCoordinates(a.rail[side].given), toCoordinates(b.rail[side].given));
      }
    }
  }
}

TEST_F(LineTest, LineWithoutIrregularitiesChangesNoBit)
{
  WheelsetContact ideal(scene_), on_line(sceneOn(lineOf({{0, 0, {}}, {7, 0, {}}, {20, 0, {}}})));
  for (const WheelsetState& state : run(0.4))
  {
    SCOPED_TRACE("distance " + std::to_string(state.distance));
    expectSameBits(ideal.evaluate(state), on_line.evaluate(state));
  }
}

TEST_F(LineTest, MirroredLineGivesTheMirroredResult)
{
  WheelsetContact contact(sceneOn(lineOf(stations_))), mirror(sceneOn(mirrored(stations_)));
  for (const WheelsetState& state : run(0.4))
  {
    SCOPED_TRACE("distance " + std::to_string(state.distance));
    expectMirrorImage(contact.evaluate(state), mirror.evaluate(mirrored(state)));
  }
}

// A track that is displaced as a whole carries a wheelset that is displaced with it in the same way.
TEST_F(LineTest, AlignmentAndLevelOfTheTrackMoveTheWheelset)
{
  constexpr double alignment = 4e-3, level = -6e-3;
  const Sides<RailDeflection> moved{RailDeflection{alignment, level, 0}, {-alignment, level, 0}};
  WheelsetContact ideal(scene_), on_line(sceneOn(lineOf({{0, 0, moved}, {1, 0, moved}})));
  for (const double y : {0.0, 2e-3, -5.5e-3})
  {
    const WheelsetResult& a = okResult(ideal, stateAt(y, 1e5));
    const WheelsetResult& b = okResult(on_line, stateAt(y + alignment, 1e5));
    // The grids have fixed places on the track. Their errors differ, by up to the tolerance of 1 %.
    EXPECT_NEAR(b.z - a.z, level, 1e-6);
    EXPECT_NEAR(a.roll, b.roll, 1e-6);
    for (const Side side : sides)
    {
      const double expected = wheelTotal(a, side).max_pressure;
      EXPECT_NEAR(wheelTotal(b, side).max_pressure, expected, scene_.contact.tolerance * expected) << "y = " << y;
    }
  }
}

// The centre line of the track keeps its place. The wheelset rolls with the track, up to the change of the contacts.
TEST_F(LineTest, CrossLevelRollsTheWheelset)
{
  constexpr double cross_level = 15e-3;
  const double base = 2 * restingRail(scene_, Side::left).referencePoint().y;
  WheelsetContact on_line(sceneOn(lineOf({{0, cross_level, {}}, {1, cross_level, {}}})));
  const double tilt = std::asin(cross_level / base);
  // In the tilted track, the axle centre is at y = 0: 0.46 m above the plane of the rail tops.
  const WheelsetResult& result = okResult(on_line, stateAt(-0.46 * std::sin(tilt), 1e5));
  EXPECT_NEAR(result.roll, tilt, 1e-5);
  EXPECT_NEAR(result.z, 0.46 * std::cos(tilt), 0.3e-3);  // first touch is 0.18 mm from it, the approach 0.1 mm
  EXPECT_NEAR(result.rail.left.deflection.roll, -tilt, 1e-12);
  EXPECT_NEAR(result.rail.right.deflection.roll, tilt, 1e-12);
}

TEST_F(LineTest, PlacesOutsideTheLineAreReportedAndKeepTheWarmStart)
{
  const ContactModelConfig scene = sceneOn(lineOf(stations_));
  WheelsetContact contact(scene), undisturbed(scene), cold(scene);
  const std::vector<WheelsetState> states = run(0.02);
  contact.evaluate(states[0]);
  undisturbed.evaluate(states[0]);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double distance : {-1e-9, 20.0 + 1e-9, 1e300, infinity, -infinity, std::nan("")})
  {
    WheelsetState outside = states[0];
    outside.distance = distance;
    const WheelsetResult& result = contact.evaluate(outside);
    EXPECT_EQ(result.status, ContactStatus::outside_line) << distance;
    EXPECT_FALSE(isUsable(result.status));
    EXPECT_NE(result.reason.find(" m is outside track/line, from 0 to 20 m"), std::string::npos) << result.reason;
    EXPECT_TRUE(result.patches.empty());
    EXPECT_EQ(result.y, outside.y);
  }
  const std::vector<LineStation> apart{{0, 0, {}}, {5, 0, {}}, {15, 0, {}}};
  WheelsetContact with_gap(sceneOn(std::make_shared<TrackLine>("apart", apart, 6)));
  WheelsetState in_gap = states[0];
  in_gap.distance = 7.5;
  EXPECT_EQ(with_gap.evaluate(in_gap).status, ContactStatus::outside_line);
  EXPECT_EQ(with_gap.evaluate(in_gap).reason,
            "the wheelset at 7.5 m is in a gap of track/line, from 5 to 15 m (longest_gap)");
  WheelsetState invalid_outside = stateAt(std::nan(""), 1e5);
  invalid_outside.distance = -1;
  EXPECT_EQ(contact.evaluate(invalid_outside).status, ContactStatus::invalid_input);
  const WheelsetResult& warm = contact.evaluate(states[1]);
  expectSameBits(warm, undisturbed.evaluate(states[1]));
  // A cold start takes another path to the result.
  EXPECT_NE(warm.z, cold.evaluate(states[1]).z);
}

TEST_F(LineTest, WithoutALineTheDistanceIsNotUsed)
{
  WheelsetContact contact(scene_), other(scene_);
  WheelsetState state = stateAt(1e-3, 1e5);
  const WheelsetResult& result = contact.evaluate(state);
  state.distance = std::nan("");
  expectSameBits(result, other.evaluate(state));
}

// A wheelset on rails whose profile changes along the line, and on rails of several parts.
using Placement = RailSections::Placement;

std::shared_ptr<const RailSections> series(const RailSeries& sections, Placement placement)
{
  return std::make_shared<const RailSections>(std::vector<RailSeries>{sections}, placement);
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

// A cylinder on crowns of 200 mm and 300 mm: all quantities change monotonously with the radius of the crown.
TEST(Sections, ResultBetweenTwoSectionsLiesBetweenThoseOnThem)
{
  ContactModelConfig config = round_bodies::scene(0);
  config.rail_sections =
      series({{0, profileOf({0, 0, 0.036, 0.2}), {}}, {1, profileOf({0, 0, 0.036, 0.3}), {}}}, Placement::gauge);
  WheelsetContact contact(config);
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
  ContactModelConfig config = round_bodies::scene(0);
  config.rail_sections =
      series({{0, profileOf({0, 0, 0.036, 0.2}), {}}, {1, profileOf({0, 0, 0.036, 0.3}), {}}}, Placement::gauge);
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
