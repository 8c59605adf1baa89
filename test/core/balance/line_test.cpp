// SPDX-License-Identifier: BSD-3-Clause
// A wheelset on a track with irregularities.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/balance/rail_support.h"
#include "core/track/rail_along.h"
#include "same_bits.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

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

WheelsetState mirrored(WheelsetState state)
{
  state.y = -state.y;
  state.yaw = -state.yaw;
  state.torque_x = -state.torque_x;
  std::swap(state.rail_displacement.left, state.rail_displacement.right);
  return state;
}

/// Expects the forces and positions of a mirror image; equal bits, no tolerance.
void expectMirrorImage(const WheelsetResult& result, const WheelsetResult& image)
{
  EXPECT_EQ(result.status, image.status);
  EXPECT_EQ(result.z, image.z);
  EXPECT_EQ(result.roll, -image.roll);
  ASSERT_EQ(result.patches.size(), image.patches.size());
  for (const Side side : sides)
  {
    const WheelTotal total = wheelTotal(result, side),
                     other = wheelTotal(image, side == Side::left ? Side::right : Side::left);
    EXPECT_EQ(total.patches, other.patches);
    EXPECT_EQ(total.vertical, other.vertical);
    EXPECT_EQ(total.max_pressure, other.max_pressure);
    EXPECT_EQ(total.area, other.area);
  }
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

  double within(double limit) { return std::uniform_real_distribution<double>(-limit, limit)(random_); }
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

  const unsigned seed_ = 20111U;
  testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(seed_)};
  std::mt19937 random_{seed_};
  std::vector<LineStation> stations_;  ///< random, 0.25 m apart
  ContactModelConfig scene_ = manchesterScene();
};
}  // namespace

TEST_F(LineTest, ResultIsThatOfTheSameDisplacementGivenWithTheState)
{
  for (const bool soft : {false, true})
  {
    SCOPED_TRACE(soft ? "soft rails" : "rigid rails");
    scene_.rail_bending.model = soft ? RailBendingConfig::Model::compliance : RailBendingConfig::Model::none;
    scene_.rail_bending.table = softPads();
    const auto line = lineOf(stations_);
    WheelsetContact on_line(sceneOn(line)), given(scene_);
    for (WheelsetState state : run(0.4))
    {
      SCOPED_TRACE("distance " + std::to_string(state.distance));
      state.rail_displacement.left = {within(1e-3), within(1e-3), within(1e-3)};  // is added to that of the line
      const WheelsetResult& a = on_line.evaluate(state);
      const WheelsetResult& b = given.evaluate(displaced(state, *line));
      ASSERT_TRUE(isUsable(a.status)) << a.reason;
      expectSameBits(a, b);
      for (const Side side : sides)
      {
        EXPECT_EQ(a.rail[side].given.lateral, b.rail[side].given.lateral);
        EXPECT_EQ(a.rail[side].given.vertical, b.rail[side].given.vertical);
        EXPECT_EQ(a.rail[side].given.roll, b.rail[side].given.roll);
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
    const WheelsetResult& a = ideal.evaluate(stateAt(y, 1e5));
    const WheelsetResult& b = on_line.evaluate(stateAt(y + alignment, 1e5));
    ASSERT_EQ(a.status, ContactStatus::ok);
    ASSERT_EQ(b.status, ContactStatus::ok);
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
  const WheelsetResult& result = on_line.evaluate(stateAt(-0.46 * std::sin(tilt), 1e5));
  ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
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
  const WheelsetResult& warm = contact.evaluate(states[1]);
  expectSameBits(warm, undisturbed.evaluate(states[1]));
  // A cold start takes another path to the result.
  EXPECT_NE(warm.z, cold.evaluate(states[1]).z);
}

TEST_F(LineTest, InvalidStateOutsideTheLineIsInvalid)
{
  WheelsetContact contact(sceneOn(lineOf(stations_)));
  WheelsetState state = stateAt(std::nan(""), 1e5);
  state.distance = -1;
  EXPECT_EQ(contact.evaluate(state).status, ContactStatus::invalid_input);
}

TEST_F(LineTest, WithoutALineTheDistanceIsNotUsed)
{
  WheelsetContact contact(scene_), other(scene_);
  WheelsetState state = stateAt(1e-3, 1e5);
  const WheelsetResult& result = contact.evaluate(state);
  state.distance = std::nan("");
  expectSameBits(result, other.evaluate(state));
}
