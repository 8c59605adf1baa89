// SPDX-License-Identifier: BSD-3-Clause
// Places of the sections of a rail across the track.
#include "core/track/rail_along.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

#include "../profile/section_scenes.h"

using namespace wheel_rail_contact::core;
using section_scenes::Head;
using section_scenes::profileOf;
using section_scenes::shared;

namespace
{
using Placement = RailSections::Placement;

/// Points of a rail are 7 um apart. The highest point of a head turned by 1:40 is on a corner of 13 mm: (7 um)² / (8 *
/// 13 mm). The innermost point of a straight upright side is exact.
constexpr double sampling = 1e-9;
constexpr double turned_sampling = 2e-7;  ///< of the innermost point of a side turned by 1:40: 7 um / 40

/// Highest point of a part of a rail, and its innermost point down to the gauge depth; side axes [m].
struct Extremes
{
  double top = -std::numeric_limits<double>::infinity(), face = std::numeric_limits<double>::infinity();
};

Extremes extremesOf(const PlacedRail& rail, std::size_t part, double gauge_depth)
{
  constexpr int count = 20000;
  const ParameterRange range = rail.profile().parts().at(part);
  const auto at = [&](int i) { return rail.at(range.begin + (range.end - range.begin) * i / count); };
  Extremes extremes;
  for (int i = 0; i <= count; ++i)
  {
    extremes.top = std::max(extremes.top, at(i).z);
  }
  for (int i = 0; i <= count; ++i)
  {
    extremes.face = at(i).z >= extremes.top - gauge_depth ? std::min(extremes.face, at(i).y) : extremes.face;
  }
  return extremes;
}

RailSeries twoHeads(const Head& first, const Head& second)
{
  return {{0, shared(profileOf(first)), {}}, {1, shared(profileOf(second)), {}}};
}

void expectSamePlace(const PlacedRail& a, const PlacedRail& b)
{
  ASSERT_EQ(a.profile().length(), b.profile().length());
  for (double u = 0; u < a.profile().length(); u += 1e-3)
  {
    EXPECT_EQ(a.at(u).y, b.at(u).y);
    EXPECT_EQ(a.at(u).z, b.at(u).z);
  }
}

/// Upright rails.
TrackConfig upright()
{
  TrackConfig track;
  track.rail_inclination = 0;
  return track;
}
}  // namespace

TEST(RailAlong, GaugePlacementPutsEachSectionToGaugeAndHeight)
{
  const RailSections sections({twoHeads({0.003, 0.002, 0.036}, {-0.001, -0.004, 0.030})}, Placement::gauge);
  for (const TrackConfig& track : {upright(), TrackConfig()})
  {
    for (const Side side : sides)
    {
      RailAlong along(sections, track, side);
      const bool turned = track.rail_inclination[side] != 0;
      for (const double x : {0.0, 1.0})
      {
        along.moveTo(x);
        const Extremes extremes = extremesOf(along.rail(), 0, track.gauge_depth);
        EXPECT_NEAR(extremes.top, 0, sampling) << x;
        EXPECT_NEAR(extremes.face, 0.5 * track.gauge, turned ? turned_sampling : sampling) << x;
      }
      // Between them the curve and its position are means. For upright heads, so are its top and its gauge face, up to
      // the error of cubic pieces where the side ends at a corner (section_blend_test.cpp). For turned heads, the
      // highest and the innermost points do not correspond exactly: 1:40 over 4 mm.
      along.moveTo(0.3);
      const Extremes extremes = extremesOf(along.rail(), 0, track.gauge_depth);
      EXPECT_NEAR(extremes.top, 0, turned ? 1e-4 : 1e-6);
      EXPECT_NEAR(extremes.face, 0.5 * track.gauge, turned ? 1e-4 : 1e-6);
    }
  }
}

TEST(RailAlong, CoordinatesKeepThePlaceRelativeToTheFirstSection)
{
  const TrackConfig track = upright();
  const RailSections sections({twoHeads({0.003, 0.002, 0.036}, {0.005, -0.004, 0.036})}, Placement::coordinates);
  RailAlong along(sections, track, Side::left);
  const Extremes first = extremesOf(along.rail(), 0, track.gauge_depth);
  EXPECT_NEAR(first.top, 0, sampling);
  EXPECT_NEAR(first.face, 0.5 * track.gauge, sampling);
  along.moveTo(1);
  const Extremes second = extremesOf(along.rail(), 0, track.gauge_depth);
  EXPECT_NEAR(second.top, -0.006, sampling);
  EXPECT_NEAR(second.face, 0.5 * track.gauge + 0.002, sampling);
  along.moveTo(0.25);
  const Extremes between = extremesOf(along.rail(), 0, track.gauge_depth);
  EXPECT_NEAR(between.top, -0.0015, sampling);
  EXPECT_NEAR(between.face, 0.5 * track.gauge + 0.0005, sampling);
}

TEST(RailAlong, FurtherPartsKeepTheirCoordinates)
{
  const TrackConfig track = upright();
  const RailSeries running = twoHeads({0, 0, 0.036}, {0.002, 0.001, 0.036});
  const RailSeries nose{{0, shared(profileOf({0.080, 0, 0.020})), {}}};
  const RailSections sections({running, nose}, Placement::coordinates);
  RailAlong along(sections, track, Side::right);
  along.moveTo(1);
  const Extremes rail = extremesOf(along.rail(), 0, track.gauge_depth),
                 further = extremesOf(along.rail(), 1, track.gauge_depth);
  // In the coordinates of the files, the nose begins 60 + 36 - 2 mm outside the gauge face of the rail, 1 mm lower.
  EXPECT_NEAR(further.face - rail.face, 0.094, sampling);
  EXPECT_NEAR(further.top - rail.top, -0.001, sampling);
}

// The gauge moves each section. Further parts would move with the wear of the running rail.
TEST(RailAlong, FurtherPartsBesideAChangingRailAreNotPlacedByTheGauge)
{
  const RailSeries running = twoHeads({0, 0, 0.036}, {0.002, 0.001, 0.036});
  const RailSeries nose{{0, shared(profileOf({0.080, 0, 0.020})), {}}};
  EXPECT_THROW(RailSections({running, nose}, Placement::gauge), std::invalid_argument);
}

TEST(RailAlong, MovesOnlyWhereTheRailChanges)
{
  const auto head = shared(profileOf({}));
  const RailSections sections({{{0, head, {}}, {1, head, {}}, {2, shared(profileOf({0.001})), {}}}}, Placement::gauge);
  RailAlong along(sections, TrackConfig(), Side::left);
  EXPECT_FALSE(along.moveTo(0.5));
  EXPECT_TRUE(along.moveTo(1.5));
  EXPECT_FALSE(along.moveTo(1.5));
  RailAlong constant(head, TrackConfig(), Side::left);
  EXPECT_FALSE(constant.moveTo(1.5));
}

TEST(RailAlong, PicturesShowTheRailOfTheCalculation)
{
  const RailSeries running = twoHeads({0, 0, 0.036}, {0.002, 0.001, 0.033});
  const RailSections by_gauge({running}, Placement::gauge);
  const RailSections by_coordinates({running, twoHeads({0.080, 0, 0.020}, {0.081, 0.001, 0.020})},
                                    Placement::coordinates);
  for (const RailSections* of_rail : {&by_gauge, &by_coordinates})
  {
    const RailSections& sections = *of_rail;
    RailAlong along(sections, TrackConfig(), Side::left);
    for (const double x : {0.0, 0.4, 1.0})
    {
      along.moveTo(x);
      expectSamePlace(railAt(sections, TrackConfig(), Side::left, x), along.rail());
    }
    // Outside, pictures show the nearest section.
    expectSamePlace(railAt(sections, TrackConfig(), Side::left, 7), along.rail());
  }
}

TEST(RailAlong, PicturesShowFurtherPartsBesideAConstantRail)
{
  const RailSections sections({{{0, shared(profileOf({})), {}}}, twoHeads({0.080}, {0.090})}, Placement::gauge);
  EXPECT_EQ(railAt(sections, TrackConfig(), Side::left, 0.5).profile().parts().size(), 2U);
  EXPECT_EQ(railAt(sections, TrackConfig(), Side::left, 1.5).profile().parts().size(), 1U);
  EXPECT_EQ(railAt(sections, TrackConfig(), Side::left, -0.5).profile().parts().size(), 1U);
}

TEST(RailAlong, ASectionThatEndsAboveTheGaugeDepthIsRefused)
{
  std::vector<ProfileSection> low;
  section_scenes::addHead({0, 0, 0.036, 0.004}, 0.006, 0.006, low);  // 10 mm deep
  const RailSeries series{{0, shared(profileOf({})), {}}, {1, shared({"low", low}), {}}};
  EXPECT_THROW(RailAlong(RailSections({series}, Placement::gauge), upright(), Side::left), std::invalid_argument);
  const RailSections free({series}, Placement::coordinates);
  EXPECT_NO_THROW(RailAlong(free, upright(), Side::left));
}
