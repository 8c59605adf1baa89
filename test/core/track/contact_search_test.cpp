// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/contact_search.h"
#include "../../manchester_scene.h"
#include "../../seeded.h"
#include "../profile/section_scenes.h"
#include "dense_separation.h"

using namespace wheel_rail_contact::core;
using section_scenes::addHead;
using section_scenes::Head;
using section_scenes::shared;

namespace
{
/// Largest curvature of the separation [1/m]: on the flank, at a section boundary of S1002.
constexpr double sharpest = 3200;

/// Largest error of a minimum by brute force [m]. The nearest station is up to 5 um beside the minimum and therefore up
/// to 3200 1/m / 2 * (5 um)² = 0.04 um too high. Chords add 0.002 um / cos(70 degrees) on the flank.
constexpr double dense_error = 0.05e-6;

/// One wheel and its deflected rail, in side axes.
struct Scene
{
  Scene(const ContactModelConfig& config, Side side, const WheelsetPose& pose, const RailDeflection& bent)
      : rail(PlacedRail(config.rail_profile.left, config.track, Side::left).deflected(bent)),
        wheel(*config.wheel_profile.left, config.wheelset, Side::left, toSide(side, pose))
  {
    const WheelsetPose& seen = wheel.pose();
    std::ostringstream out;
    out.precision(9);
    out << "pose in side axes: y " << seen.y << " yaw " << seen.yaw << " roll " << seen.roll << "; rail deflected by "
        << bent.lateral << " outward, " << bent.vertical << " up, roll " << bent.roll;
    description = out.str();
  }
  std::string description;  ///< for messages
  PlacedRail rail;
  PlacedWheel wheel;
};

/// Interval in which the separation by brute force is below a given value.
struct DenseInterval
{
  double begin, end;    ///< y in side axes [m]
  std::size_t station;  ///< station of the smallest separation
  double lowest;        ///< smallest separation [m]
};

/// Largest depth of a minimum below the stations of the search, which are 0.25 mm apart [m]: curvature / 2 * (0.125
/// mm)². The curvature is 2^1.5 / 13 mm where the rail is less steep than 45 degrees, and `sharpest` on the flank.
double stationError(const DenseSeparation& dense, std::size_t station)
{
  const bool flank = dense.railHeight(station + 1) - dense.railHeight(station) > DenseSeparation::spacing;
  return 0.5 * (flank ? sharpest : std::pow(2, 1.5) / 0.013) * 0.125e-3 * 0.125e-3;
}

/// Nearest position of a search that must have one.
template <typename Search>
InitialContact nearestOf(Search&& search)
{
  InitialContact contact;
  return search.nearest(contact) ? contact : throw std::runtime_error("no contact");
}

std::vector<OverlapInterval> intervalsOf(const ContactSearch& search, double separation)
{
  std::vector<OverlapInterval> found;
  search.overlapIntervals(separation, found);
  return found;
}

std::vector<DenseInterval> intervalsBelow(const DenseSeparation& dense, double level)
{
  std::vector<DenseInterval> found;
  for (std::size_t k = 0; k < dense.size(); ++k)
  {
    if (dense.at(k) < level)
    {
      DenseInterval interval{dense.y(k), 0, k, dense.at(k)};
      for (; k < dense.size() && dense.at(k) < level; ++k)
      {
        interval.end = dense.y(k);
        if (dense.at(k) < interval.lowest)
        {
          interval.lowest = dense.at(k);
          interval.station = k;
        }
      }
      found.push_back(interval);
    }
  }
  return found;
}

class ContactSearchTest : public testing::Test
{
 protected:
  double unit() { return random_.unit(); }
  Scene randomScene(Side side, double yaw)
  {
    const WheelsetPose pose{0.012 * unit(), 0.46, yaw * unit(), 0.01 * unit()};
    return {config_, side, pose, {3e-3 * unit(), 1e-3 * unit(), 0.01 * unit()}};
  }
  void place(const Scene& scene)
  {
    search_.setRail(scene.rail);
    search_.setWheel(scene.wheel);
  }
  std::vector<OverlapInterval> intervals(double separation) const { return intervalsOf(search_, separation); }

  Seeded random_{20111U};
  ContactModelConfig config_ = manchesterScene();
  ContactSearch search_{*config_.wheel_profile.left, *config_.rail_profile.left};
};

// The position found must be a point of both bodies and have the smallest separation. Among positions whose separations
// differ by less than the error of the stations, the search takes the one with the lowest station. It also stays at a
// station if the minimum is not next to it. Both cases are rare.
TEST_F(ContactSearchTest, NearestPositionAgreesWithBruteForce)
{
  int exact = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Scene scene = randomScene(i % 2 == 0 ? Side::left : Side::right, i % 3 == 0 ? 0.06 : 0.02);
    place(scene);
    const InitialContact contact = nearestOf(search_);
    SCOPED_TRACE(scene.description);
    const DenseSeparation dense(scene.wheel, scene.rail);
    const std::size_t lowest = dense.lowest();
    exact += contact.separation < dense.at(lowest) + dense_error ? 1 : 0;
    EXPECT_GT(contact.separation, dense.at(lowest) - dense_error);
    EXPECT_LT(contact.separation, dense.at(lowest) + stationError(dense, lowest))
        << contact.y << " found, expected " << dense.y(lowest);

    const PlanePoint rail = scene.rail.at(contact.rail_u);
    SpacePoint wheel{};
    ASSERT_TRUE(scene.wheel.locus(config_.wheel_profile.left->at(contact.wheel_u), wheel));
    EXPECT_NEAR(rail.y, contact.y, 1e-10);  // the search ends at 1e-11 m
    EXPECT_NEAR(wheel.y, contact.y, 1e-10);
    EXPECT_NEAR(wheel.z - rail.z, contact.separation, 3e-10);
    EXPECT_NEAR(rail.dz / rail.dy, contact.slope, 1e-9);
  }
  EXPECT_GE(exact, 194);  // of 200; 1.2 inexact ones are expected (15 of 2500)
}

// Wheel and rail are parallel at a minimum. The position is exact to 10 nm, and the relative curvature is below 3200
// 1/m. Positions at which the search stayed at a station are not minima of smooth bodies.
TEST_F(ContactSearchTest, OutlinesAreParallelAtTheNearestPosition)
{
  int smooth = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Scene scene = randomScene(i % 2 == 0 ? Side::left : Side::right, 0.03);
    place(scene);
    const InitialContact contact = nearestOf(search_);
    SpacePoint locus{};
    PlanePoint wheel{};
    const CurvePoint point = config_.wheel_profile.left->at(contact.wheel_u);
    ASSERT_TRUE(scene.wheel.locus(point, locus));
    ASSERT_TRUE(scene.wheel.section(point, locus.x, wheel));
    if (contact.curvature > 0 && std::abs(wheel.dz / wheel.dy - contact.slope) < 4e-5)
    {
      ++smooth;
    }
  }
  EXPECT_GE(smooth, 190);  // some minima are corners: a step of S1002 between sections, or an end of the rail
}

// Each interval of the brute force must be in an interval of the search if it is deeper than the error of the stations.
// Each interval of the search, except on the flank, must contain one of the brute force.
//
// The ends of the intervals only determine the first grid, which grows until it covers the overlap. They are
// interpolated between stations or computed from the curvature at the minimum. The separation there may differ from the
// given value by the depth (the grid is then too wide or too narrow by sqrt(2)). On the flank, where the curvature
// jumps at a section boundary, the difference may be larger.
TEST_F(ContactSearchTest, OverlapIntervalsAgreeWithBruteForce)
{
  for (int i = 0; i < 200; ++i)
  {
    const Scene scene = randomScene(i % 2 == 0 ? Side::left : Side::right, i % 3 == 0 ? 0.06 : 0.02);
    place(scene);
    SCOPED_TRACE(scene.description);
    const DenseSeparation dense(scene.wheel, scene.rail);
    const double lowest = dense.at(dense.lowest());
    for (const double depth : {1e-5, 5e-5, 2e-4, 1e-3})
    {
      const double level = lowest + depth;
      const std::vector<DenseInterval> expected = intervalsBelow(dense, level);
      const std::vector<OverlapInterval> found = intervals(level);
      for (const DenseInterval& interval : expected)
      {
        const double y = dense.y(interval.station);
        const bool held = std::any_of(
            found.begin(), found.end(),
            [&](const OverlapInterval& candidate)
            { return y > scene.rail.at(candidate.u_begin).y - 2e-5 && y < scene.rail.at(candidate.u_end).y + 2e-5; });
        EXPECT_TRUE(held || level - interval.lowest < stationError(dense, interval.station))
            << "interval not found: " << interval.begin << " to " << interval.end << ", depth "
            << level - interval.lowest;
      }
      for (const OverlapInterval& interval : found)
      {
        if (interval.contact.slope < 1)
        {
          EXPECT_LT(dense.near(interval.contact.y), level + dense_error) << "no overlap by brute force";
          EXPECT_NEAR(dense.near(scene.rail.at(interval.u_begin).y), level, depth);
          EXPECT_NEAR(dense.near(scene.rail.at(interval.u_end).y), level, depth);
        }
      }
    }
  }
}

// Intervals neither overlap nor touch: between two of them there is a place without overlap.
TEST_F(ContactSearchTest, IntervalsAreSeparateAndInOrder)
{
  int apart = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Scene scene = randomScene(i % 2 == 0 ? Side::left : Side::right, 0.06);
    place(scene);
    const InitialContact contact = nearestOf(search_);
    SCOPED_TRACE(scene.description);
    const std::vector<OverlapInterval> found =
        intervals(contact.separation + (i < 1000 ? 6e-3 : 2e-4) * std::abs(unit()));
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      EXPECT_LE(found[k].u_begin, found[k].u_end);
      if (k + 1 < found.size())
      {
        EXPECT_LT(found[k].u_end, found[k + 1].u_begin);
        ++apart;
      }
    }
  }
  EXPECT_GE(apart, 5);
}

// At about 5 mm of lateral displacement the contact moves from the tread to the flange root, and both touch. The search
// must find two intervals with very different normals, each about its own minimum.
TEST_F(ContactSearchTest, TreadAndFlangeContactAreTwoIntervals)
{
  int with_two = 0;
  for (double y = 4.8e-3; y < 5.4e-3; y += 2e-5)
  {
    const Scene scene(config_, Side::left, {y, 0.46, 0, 0}, {});
    place(scene);
    SCOPED_TRACE(scene.description);
    const DenseSeparation dense(scene.wheel, scene.rail);
    const double level = dense.at(dense.lowest()) + 4e-5;
    const std::vector<DenseInterval> expected = intervalsBelow(dense, level);
    if (expected.size() != 2 || level - std::max(expected[0].lowest, expected[1].lowest) < 1e-6)
    {
      continue;
    }
    ++with_two;
    const std::vector<OverlapInterval> found = intervals(level);
    ASSERT_EQ(found.size(), 2U) << "y " << y;
    EXPECT_LT(found[0].u_end, found[1].u_begin);
    EXPECT_GT(std::atan(found[0].contact.slope) - std::atan(found[1].contact.slope), 0.1);
    for (std::size_t k = 0; k < 2; ++k)
    {
      EXPECT_NEAR(found[k].contact.separation, expected[k].lowest, dense_error);
      EXPECT_GT(found[k].contact.rail_u, found[k].u_begin);
      EXPECT_LT(found[k].contact.rail_u, found[k].u_end);
    }
  }
  EXPECT_GE(with_two, 10);
}

// The ends are accurate to one station (0.25 mm). An interval may seem to shrink by this amount where its width is no
// longer computed from the curvature at the minimum, but from the stations.
TEST_F(ContactSearchTest, IntervalsWidenWithTheSeparation)
{
  for (int i = 0; i < 50; ++i)
  {
    const Scene scene = randomScene(Side::left, 0.02);
    place(scene);
    const InitialContact contact = nearestOf(search_);
    OverlapInterval before;
    double first_width = 0;
    for (double depth = 2e-4; depth < 4e-3; depth *= 1.3)
    {
      const std::vector<OverlapInterval> found = intervals(contact.separation + depth);
      const auto around = std::find_if(found.begin(), found.end(),
                                       [&](const OverlapInterval& one)
                                       { return one.u_begin < contact.rail_u && one.u_end > contact.rail_u; });
      ASSERT_NE(around, found.end());
      const OverlapInterval& interval = *around;
      if (before.u_end > 0)
      {
        EXPECT_LE(interval.u_begin, before.u_begin + 2.5e-4);
        EXPECT_GE(interval.u_end, before.u_end - 2.5e-4);
      }
      first_width = first_width > 0 ? first_width : interval.u_end - interval.u_begin;
      before = interval;
    }
    EXPECT_GT(before.u_end - before.u_begin, 1.5 * first_width);
  }
}

TEST_F(ContactSearchTest, ThereIsNoOverlapAboveTheFirstTouch)
{
  place({config_, Side::left, {0, 0.46, 0, 0}, {}});
  const InitialContact contact = nearestOf(search_);
  EXPECT_TRUE(intervals(contact.separation - 1e-9).empty());
  EXPECT_FALSE(intervals(contact.separation + 2e-4).empty());
}

TEST_F(ContactSearchTest, WheelBesideTheRailHasNoContact)
{
  for (const double y : {-0.3, 0.3})
  {
    place({config_, Side::left, {y, 0.46, 0, 0}, {}});
    InitialContact contact;
    EXPECT_FALSE(search_.nearest(contact));
    EXPECT_TRUE(intervals(1.0).empty());
  }
}

// At 60 mrad of yaw the outline of the flange root is folded. The search must find the lower branch.
TEST_F(ContactSearchTest, LowerBranchOfAFoldedOutlineIsFoundAtLargeYaw)
{
  int folded = 0;
  for (int i = 0; i < 40; ++i)
  {
    const double yaw = i % 2 == 0 ? 0.06 : -0.06;
    const Scene scene(config_, Side::left, {0.004 + 0.006 * std::abs(unit()), 0.46, yaw, 0}, {});
    place(scene);
    double y_before = -1;
    bool turns_back = false;
    for (double u = 0.012; u < config_.wheel_profile.left->length(); u += 1e-4)
    {
      SpacePoint locus{};
      ASSERT_TRUE(scene.wheel.locus(config_.wheel_profile.left->at(u), locus));
      turns_back = turns_back || locus.y < y_before;
      y_before = locus.y;
    }
    folded += turns_back ? 1 : 0;
    const InitialContact contact = nearestOf(search_);
    SCOPED_TRACE(scene.description);
    const DenseSeparation dense(scene.wheel, scene.rail);
    EXPECT_GT(contact.separation, dense.at(dense.lowest()) - dense_error);
    EXPECT_LT(contact.separation, dense.at(dense.lowest()) + stationError(dense, dense.lowest()));
  }
  EXPECT_GT(folded, 0);
}

// Contact of a wheel with a rail of several separate parts.
using Sections = std::vector<ProfileSection>;

Sections sectionsOf(const Head& head)
{
  Sections sections;
  addHead(head, 0.02, 0.02, sections);
  return sections;
}

/// A rail of two parts in side axes, and each part alone.
struct TwoParts
{
  TwoParts(const Sections& first, const Sections& second)
      : both(shared(section_scenes::ProfileOfParts({first, second})), RailFrame{}),
        alone{PlacedRail(shared({"first", first}), RailFrame{}), PlacedRail(shared({"second", second}), RailFrame{})}
  {
  }
  /// Parameter u of the whole rail for one of a part alone.
  double wholeParameter(std::size_t part, double u) const { return both.profile().parts()[part].begin + u; }

  PlacedRail both;
  std::array<PlacedRail, 2> alone;
};

class ContactPartsTest : public testing::Test
{
 protected:
  double unit() { return random_.unit(); }
  PlacedWheel randomWheel()
  {
    return {*config_.wheel_profile.left,
            config_.wheelset,
            Side::left,
            {0.006 * unit(), 0.4605, 0.02 * unit(), 0.003 * unit()}};
  }
  ContactSearch searchOn(const PlacedRail& rail, const PlacedWheel& wheel) const
  {
    ContactSearch search(*config_.wheel_profile.left, rail.profile());
    search.setRail(rail);
    search.setWheel(wheel);
    return search;
  }

  Seeded random_{561U};
  ContactModelConfig config_ = manchesterScene();
  /// A wing on the field side of a nose, both below the tread.
  const TwoParts separate_{sectionsOf({0.745, 0, 0.010, 0.005}), sectionsOf({0.785, 0.0015, 0.012, 0.005})};
};

// Each part is sampled at the same parameters, alone or with the other one. The stations differ. An interval of less
// than eight stations has the width of its osculating parabola, any other one is interpolated between stations: the
// separation is then exact to ContactSearch::station_error, on flanks of at least 1:20 in these scenes.
TEST_F(ContactPartsTest, IntervalsOnSeparateHeadsAreThoseOfEachAlone)
{
  const double end_error = 2 * ContactSearch::station_error / 0.05;
  int compared = 0, on_both = 0;
  for (int i = 0; i < 100; ++i)
  {
    const PlacedWheel wheel = randomWheel();
    ContactSearch both = searchOn(separate_.both, wheel);
    const InitialContact nearest = nearestOf(both);
    for (const double depth : {5e-5, 2e-4, 5e-4})
    {
      const double level = nearest.separation + depth;
      std::vector<OverlapInterval> expected;
      for (const std::size_t part : {0U, 1U})
      {
        for (OverlapInterval interval : intervalsOf(searchOn(separate_.alone[part], wheel), level))
        {
          interval.u_begin = separate_.wholeParameter(part, interval.u_begin);
          interval.u_end = separate_.wholeParameter(part, interval.u_end);
          expected.push_back(interval);
        }
      }
      const std::vector<OverlapInterval> found = intervalsOf(both, level);
      // A flat overlap as shallow as the error of the stations may be missed by one of them.
      ASSERT_EQ(found.size(), expected.size()) << "state " << i << " depth " << depth;
      on_both += found.size() == 2 ? 1 : 0;
      for (std::size_t k = 0; k < found.size(); ++k)
      {
        EXPECT_NEAR(found[k].u_begin, expected[k].u_begin, end_error);
        EXPECT_NEAR(found[k].u_end, expected[k].u_end, end_error);
        EXPECT_NEAR(found[k].contact.separation, expected[k].contact.separation, ContactSearch::station_error);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 300);
  EXPECT_GT(on_both, 50) << "the scenes must have contacts on both heads";
}

TEST_F(ContactPartsTest, EachHeadHasAContact)
{
  // Both tops at the height of the tread above them: the second one is raised by the difference of its separation.
  const PlacedWheel wheel(*config_.wheel_profile.left, config_.wheelset, Side::left, {0, 0.46, 0, 0});
  std::array<double, 2> separation{};
  for (const std::size_t part : {0U, 1U})
  {
    separation[part] = nearestOf(searchOn(separate_.alone[part], wheel)).separation;
  }
  const double raise = separation[1] - separation[0];
  const TwoParts level(sectionsOf({0.745, 0, 0.010, 0.005}), sectionsOf({0.785, 0.0015 + raise, 0.012, 0.005}));
  const std::vector<OverlapInterval> found = intervalsOf(searchOn(level.both, wheel), separation[0] + 1e-4);
  ASSERT_EQ(found.size(), 2U);
  for (const std::size_t part : {0U, 1U})
  {
    const ParameterRange range = level.both.profile().parts()[part];
    EXPECT_GE(found[part].u_begin, range.begin);
    EXPECT_LE(found[part].u_end, range.end);
    // The contact moves on the tread, whose slope is below 1:15, by the raise; it is exact to the error of the search.
    EXPECT_NEAR(found[part].contact.separation, separation[0], 1e-9);
  }
}

// Two flat heads with a gap of 0.05 mm to 1 mm, far below the distance of the stations and above it: the separation is
// below the level on both sides of the gap.
TEST_F(ContactPartsTest, IntervalsNeverSpanTwoParts)
{
  for (const double gap : {0.05e-3, 0.2e-3, 1e-3})
  {
    const TwoParts close(sectionsOf({0.745, 0, 0.015, 1e-4}), sectionsOf({0.745 + 0.030 + gap, 0, 0.015, 1e-4}));
    for (int i = 0; i < 50; ++i)
    {
      ContactSearch search = searchOn(close.both, randomWheel());
      const InitialContact nearest = nearestOf(search);
      for (const double depth : {1e-4, 1e-3, 5e-3})
      {
        for (OverlapInterval interval : intervalsOf(search, nearest.separation + depth))
        {
          for (const bool moved : {false, true})
          {
            if (moved)
            {
              search.moveEnds(nearest.separation + 0.5 * depth, interval);
            }
            const ParameterRange part = close.both.profile().partAt(interval.contact.rail_u);
            // The width by curvature may reach beyond the end of a part, as it does at the end of a profile.
            EXPECT_GT(interval.u_begin, part.begin - 0.5 * Profile::part_distance);
            EXPECT_LT(interval.u_end, part.end + 0.5 * Profile::part_distance);
          }
        }
      }
    }
  }
}

// The second part lies on the gauge side of the first one, as a nose beside its wing rail.
TEST_F(ContactPartsTest, IntervalsAreInTheOrderOfTheParts)
{
  const TwoParts swapped(sectionsOf({0.785, 0.0015, 0.012, 0.005}), sectionsOf({0.745, 0, 0.010, 0.005}));
  const PlacedWheel wheel(*config_.wheel_profile.left, config_.wheelset, Side::left, {0, 0.458, 0, 0});
  const std::vector<OverlapInterval> found = intervalsOf(searchOn(swapped.both, wheel), 0);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_GT(found[0].contact.y, found[1].contact.y);
  EXPECT_LT(found[0].u_end, found[1].u_begin);
}

// A blade that lies against a stock rail, partly above it and partly below: the wheel touches the higher one.
TEST_F(ContactPartsTest, BladeAgainstAStockRailIsTouchedWhereItIsHigher)
{
  int on_blade = 0, on_stock = 0;
  for (int i = 0; i < 60; ++i)
  {
    const double blade_top = 0.0008 * unit();
    const TwoParts rail(sectionsOf({0.790, 0.001, 0.036}), sectionsOf({0.745, blade_top, 0.012, 0.010}));
    const PlacedWheel wheel = randomWheel();
    const InitialContact contact = nearestOf(searchOn(rail.both, wheel));
    const DenseSeparation stock(wheel, rail.alone[0]), blade(wheel, rail.alone[1]);
    const double lowest = std::min(stock.at(stock.lowest()), blade.at(blade.lowest()));
    EXPECT_GT(contact.separation, lowest - dense_error);
    EXPECT_LT(contact.separation, lowest + 2 * ContactSearch::station_error);  // the search may stay at a station
    const bool is_blade = contact.rail_u >= rail.both.profile().parts()[1].begin;
    (is_blade ? on_blade : on_stock) += 1;
    EXPECT_EQ(is_blade, blade.at(blade.lowest()) < stock.at(stock.lowest()));
  }
  EXPECT_GT(on_blade, 10);
  EXPECT_GT(on_stock, 10);
}
}  // namespace
