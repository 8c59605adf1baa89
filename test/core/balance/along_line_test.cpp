// SPDX-License-Identifier: BSD-3-Clause
#include "../../seeded.h"
#include "core/balance/rail_support.h"
#include "core/track/rail_along.h"
#include "same_bits.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

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

TEST_F(LineTest, LineWithoutIrregularitiesChangesNoBitAndWithoutOneTheDistanceIsNotUsed)
{
  WheelsetContact ideal(scene_), on_line(sceneOn(lineOf({{0, 0, {}}, {7, 0, {}}, {20, 0, {}}})));
  for (const WheelsetState& state : run(0.4))
  {
    SCOPED_TRACE("distance " + std::to_string(state.distance));
    expectSameBits(ideal.evaluate(state), on_line.evaluate(state));
  }
  WheelsetContact contact(scene_), other(scene_);
  WheelsetState state = stateAt(1e-3, 1e5);
  const WheelsetResult& result = contact.evaluate(state);
  state.distance = std::nan("");
  expectSameBits(result, other.evaluate(state));
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
}  // namespace
