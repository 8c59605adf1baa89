// SPDX-License-Identifier: BSD-3-Clause
// Contact of a wheel with a rail of several separate parts.
#include "../../manchester_scene.h"
#include "../../seeded.h"
#include "../profile/section_scenes.h"
#include "dense_separation.h"

using namespace wheel_rail_contact::core;
using namespace section_scenes;

namespace
{
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
