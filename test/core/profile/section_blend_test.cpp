// SPDX-License-Identifier: BSD-3-Clause
// Curves between two sections of a rail.
#include "core/profile/along/section_blend.h"

#include "section_scenes.h"
#include "wheel_rail_contact/core/profile_reader.h"

using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::section_scenes;

namespace
{
/// Largest error of cubic pieces of 0.5 mm where a line meets a corner of 13 mm: less than (0.5 mm)² / (27 * 13 mm) =
/// 0.71 um, the deviation of a chord polygon being (0.5 mm)² / (8 * 13 mm). distanceFrom() adds up to (0.02 mm)² / 13
/// mm.
constexpr double curve_error = 0.75e-6;

/// Head of 60E1, as a curve without its web.
const Profile& head60E1()
{
  static const Profile profile = rail60E1();
  return profile;
}
}  // namespace

TEST(SectionBlend, BetweenShiftedSectionsOfOneShapeIsTheShiftedSection)
{
  const Head a, b{0.004, -0.002};
  for (const double share : {0.25, 0.5, 0.9})
  {
    const Profile exact = profileOf({share * b.y, share * b.top});
    EXPECT_LT(distanceFrom(exact, between(profileOf(a), profileOf(b), share)), curve_error) << share;
  }
}

TEST(SectionBlend, SharesZeroAndOneAreTheSections)
{
  const Profile a = profileOf({0, 0, 0.036}), b = profileOf({0.003, 0.001, 0.030, 0.010});
  EXPECT_LT(distanceFrom(a, between(a, b, 0)), curve_error);
  // Lengths are up to 10 % longer or shorter on each of them: the pieces are up to 0.55 mm long, on a radius of 10 mm.
  EXPECT_LT(distanceFrom(b, between(a, b, 1)), 1.21 * 1.3 * curve_error);
  EXPECT_LT(distanceFrom(head60E1(), between(head60E1(), profileOf({}), 0)), curve_error);
}

// Corners of equal radius correspond from the sides to a slope of 14 degrees. Lengths are kept up to there, and the
// flat tops take the difference of 12 mm of 72 mm. On the last 3 mm of the corners, lengths change by up to 15 %.
TEST(SectionBlend, HeadsOfDifferentWidthKeepFlatTopsAndCornerRadii)
{
  const Profile blend = between(profileOf({0, 0, 0.036}), profileOf({0, 0.0004, 0.030}), 0.5);
  for (double u = 0; u < blend.length(); u += 1e-4)
  {
    const CurvePoint p = blend.at(u);
    const double beside = std::abs(p.y) - (0.033 - corner);
    if (beside < -1e-3)
    {
      EXPECT_NEAR(p.z, 0.0002, 1e-9) << p.y;  // rounding: the top is a mean of two flat tops
    }
    else if (beside > 5e-3 && p.z > -0.011)  // steeper than 22 degrees, and not yet on the straight side
    {
      EXPECT_NEAR(std::abs(p.curvature()) * corner, 1, 0.02) << p.y;  // the map is monotone cubic from there on
    }
  }
}

TEST(CorrespondingPlaces, LieOnBothSidesOfAHeadAtTheDepthOfTheGauge)
{
  const Profile a = profileOf({}), b = profileOf({0.002, 0.001, 0.033});
  const auto places = correspondingPlaces(a, b);
  ASSERT_EQ(places.size(), 4U);
  const double depth = 0.014, side = head_depth - depth;
  // Interpolation on a straight side: rounding. The top is the highest of samples 0.25 mm apart; on a flat top it is
  // exact.
  EXPECT_NEAR(places[0].a, side, 1e-12);
  EXPECT_NEAR(places[0].b, side, 1e-12);
  EXPECT_NEAR(places[3].a, a.length() - side, 1e-12);
  EXPECT_NEAR(places[3].b, b.length() - side, 1e-12);
  // The ends of the corners, at a slope of asin(0.25) on an arc; pieces of 0.25 mm turn by 1 degree.
  for (const CorrespondingPlaces& place : {places[1], places[2]})
  {
    EXPECT_NEAR(std::abs(a.at(place.a).dz), 0.25, 0.001);
    EXPECT_NEAR(std::abs(b.at(place.b).dz), 0.25, 0.001);
  }
}

TEST(CorrespondingPlaces, LieAsDeepAsBothHeadsReach)
{
  std::vector<ProfileSection> low;
  addHead({0, 0, 0.036, 0.004}, 0.006, 0.006, low);
  const Profile shallow("shallow", low);
  const auto places = correspondingPlaces(profileOf({}), shallow);
  ASSERT_EQ(places.size(), 2U) << "the corners differ, so their ends do not correspond";
  EXPECT_NEAR(places[0].b, 0, 1e-12);                          // its side is 10 mm deep
  EXPECT_NEAR(profileOf({}).at(places[0].a).z, -0.010, 1e-6);  // interpolated between samples on the arc
}

TEST(CorrespondingPlaces, HeadsOnBothSidesOfAGrooveCorrespondSeparately)
{
  const Head wing{0, 0, 0.030}, nose{0.075, 0, 0.020};
  const double depth = 0.020;
  const Profile a = groovedProfile(wing, nose, depth);
  const Profile b = groovedProfile(wing, {0.077, 0, 0.020}, depth);
  EXPECT_EQ(correspondingPlaces(a, b).size(), 8U);
  // The groove becomes 1 mm wider, the heads keep their shape. The map of the parameters changes from the groove to the
  // heads by 2 mm of 25 mm, and moves points that should correspond by 0.2 mm on corners of 13 mm: (0.2 mm)² / (8 * 13
  // mm).
  const double moved = 0.4e-6;
  const Profile blend = between(a, b, 0.5);
  for (double u = 0; u < blend.length(); u += 1e-4)
  {
    const CurvePoint p = blend.at(u);
    if (p.z > -0.018)
    {
      const Head& head = p.y < 0.04 ? wing : nose;
      const double beside = std::max(std::abs(p.y - (p.y < 0.04 ? 0 : 0.076)) - (head.half - corner), 0.0);
      const double distance = p.z > -corner ? std::hypot(beside, p.z + corner) - corner : beside - corner;
      EXPECT_NEAR(distance, 0, curve_error + moved) << p.y << " " << p.z;
    }
  }
}

// On a flat floor or shelf a slope of 1 um would move a place by its width.
TEST(CorrespondingPlaces, LieOnSteepFlanksBesideAFlatFloorOrShelf)
{
  constexpr double slope = 2.5e-5;
  const auto grooved = [](double fall)
  {
    std::vector<ProfileSection> sections;
    addHead({0, 0, 0.030, 0.004}, 0.02, 0.002, sections);
    sections.push_back({LineSection{0.030, -0.006, 1, fall}, 0.040});
    addHead({0.100, 0, 0.030, 0.004}, 0.002 - 0.04 * fall, 0.02, sections);
    return Profile("grooved", sections);
  };
  const auto shelved = [](double fall)
  {
    std::vector<ProfileSection> sections;
    addHead({0, 0, 0.030, 0.004}, 0.02, 0.010, sections);
    sections.push_back({LineSection{0.030, -0.014, 1, fall}, 0.040});
    sections.push_back({LineSection{0.070, -0.014 + 0.04 * fall, 0, -1}, 0.010});
    return Profile("shelved", sections);
  };
  for (const auto& [falling, rising] :
       {std::make_pair(grooved(-slope), grooved(slope)), std::make_pair(shelved(-slope), shelved(slope))})
  {
    for (const CorrespondingPlaces& place : correspondingPlaces(falling, rising))
    {
      const CurvePoint p = falling.at(place.a), q = rising.at(place.b);
      EXPECT_NEAR(p.y, q.y, 5e-6)
          << falling.name();  // the depth differs by up to 1 um, on flanks of at least 45 degrees
    }
  }
}

TEST(CorrespondingPlaces, HeadsThatDoNotOverlapDoNotCorrespond)
{
  EXPECT_TRUE(correspondingPlaces(profileOf({}), profileOf({0.2})).empty());
}

// One section only falls, the other one only rises: they share no side.
TEST(RailSections, SectionsWithoutACommonSideAreRefused)
{
  const auto line = [](double fall)
  {
    return std::make_shared<const Profile>(
        "plane",
        std::vector<ProfileSection>{{LineSection{-0.02, 0.02 * fall, std::sqrt(1 - fall * fall), -fall}, 0.04}});
  };
  EXPECT_THROW(RailSections({{{0, line(0.1), {}}, {1, line(-0.1), {}}}}, RailSections::Placement::coordinates),
               std::invalid_argument);
}

TEST(SectionBlend, AHeadOfOneSectionOnlyIsLeftOut)
{
  const Head wing{0, 0, 0.030}, nose{0.075, 0, 0.020};
  const Profile alone = profileOf(wing), both = groovedProfile(wing, nose, 0.020);
  const Profile blend = between(alone, both, 0.999);
  // The single head ends 30 mm below its top; the same length beyond the gauge depth reaches the bottom of the groove
  // and 10 mm along it, but not the nose, which begins 25 mm from the wing.
  EXPECT_LT(blend.at(blend.length()).y, 0.030 + 0.0105);
  EXPECT_LT(blend.at(blend.length()).z, -0.019);
}

TEST(SectionBlend, PointsAtCorrespondingPlacesAreMeans)
{
  const Profile a = profileOf({}), b = profileOf({0.001, 0.002, 0.033});
  const std::vector<CorrespondingPlaces> places{{0.012, 0.013}, {0.050, 0.052}, {0.080, 0.079}};
  const SectionBlend blend(a, b, places);
  double s = 0.012;  // u of the common parameter: from the first place, as far back as both sections reach
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    s += k > 0 ? 0.5 * (places[k].a - places[k - 1].a + places[k].b - places[k - 1].b) : 0;
    const CurvePoint p = curveOf(blend, 0.25).at(s), on_a = a.at(places[k].a), on_b = b.at(places[k].b);
    EXPECT_NEAR(p.y, 0.75 * on_a.y + 0.25 * on_b.y, curve_error) << k;
    EXPECT_NEAR(p.z, 0.75 * on_a.z + 0.25 * on_b.z, curve_error) << k;
  }
}

TEST(SectionBlend, PlacesMustExistAndIncrease)
{
  const Profile a = profileOf({}), b = profileOf({0.001});
  EXPECT_THROW(SectionBlend(a, b, {}), std::invalid_argument);
  EXPECT_THROW(SectionBlend(a, b, {{0.02, 0.02}, {0.03, 0.01}}), std::invalid_argument);
  EXPECT_THROW(SectionBlend(a, b, {{0.02, 0.02}, {0.02, 0.03}}), std::invalid_argument);
}

TEST(RailSections, GivenPlacesReplaceThoseOfTheShape)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto a = shared(profileOf({})), b = shared(profileOf({0.001, 0.002, 0.033}));
  // The second place is missing on one section, so it does not count.
  const RailSections rail({{{0, a, {0.012, none, 0.080}}, {1, b, {0.013, 0.030, 0.079}}}},
                          RailSections::Placement::coordinates);
  const Profile given = curveOf(*rail.between(0, 0), 0.5);
  const Profile same = curveOf({*a, *b, {{0.012, 0.013}, {0.080, 0.079}}}, 0.5);
  ASSERT_EQ(given.length(), same.length());
  for (double u = 0; u < given.length(); u += 1e-3)
  {
    EXPECT_EQ(given.at(u).y, same.at(u).y);
    EXPECT_EQ(given.at(u).z, same.at(u).z);
  }
  EXPECT_GT(distanceFrom(given, between(*a, *b, 0.5)), 1e-5);
}

TEST(RailSections, MistakesAreRefused)
{
  constexpr auto gauge = RailSections::Placement::gauge;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto head = shared(profileOf({})), other = shared(profileOf({0.001}));
  const auto two = shared(ProfileOfParts({{{LineSection{0, 0, 1, 0}, 0.1}}, {{LineSection{0.2, 0, 1, 0}, 0.1}}}));
  EXPECT_THROW(RailSections({}, gauge), std::invalid_argument);
  EXPECT_THROW(RailSections({{}}, gauge), std::invalid_argument);
  EXPECT_THROW(RailSections({{{0, nullptr, {}}}}, gauge), std::invalid_argument);
  EXPECT_THROW(RailSections({{{0, two, {}}}}, gauge), std::invalid_argument);
  EXPECT_THROW(RailSections({{{none, head, {}}}}, gauge), std::invalid_argument);
  EXPECT_THROW(RailSections({{{0, head, {}}, {0, other, {}}}}, gauge), std::invalid_argument);
  EXPECT_THROW(RailSections({{{0, head, {0.01}}, {1, other, {}}}}, gauge), std::invalid_argument);
  EXPECT_THROW(RailSections({{{0, head, {0.01, none}}, {1, other, {none, 0.05}}}}, gauge), std::invalid_argument);
  for (const std::vector<double>& places : {std::vector<double>{-0.5, 0.02}, {0.01, 3}, {0.03, 0.02}})
  {
    EXPECT_THROW(RailSections({{{0, head, places}, {1, other, {0.01, 0.02}}}}, gauge), std::invalid_argument);
  }
}

TEST(RailSections, ContainItsRunningRail)
{
  const auto head = shared(profileOf({})), other = shared(profileOf({0.001}));
  const RailSections changing({{{2, head, {}}, {5, other, {}}}}, RailSections::Placement::gauge);
  for (const double x : {2.0, 3.0, 5.0})
  {
    EXPECT_TRUE(changing.contains(x)) << x;
  }
  for (const double x : {1.999, 5.001, std::numeric_limits<double>::quiet_NaN()})
  {
    EXPECT_FALSE(changing.contains(x)) << x;
  }
  const RailSections constant({{{0, head, {}}}, {{2, head, {}}, {5, other, {}}}}, RailSections::Placement::gauge);
  EXPECT_TRUE(constant.contains(-1e6));
}
