// SPDX-License-Identifier: BSD-3-Clause
#include "../../seeded.h"
#include "core/profile/along/changing_profile.h"
#include "section_scenes.h"

using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::section_scenes;

namespace
{
Profile single(const SectionLaw& law, double length)
{
  return {"single", {{law, length}}};
}

/// Compares the derivatives with central differences of second order.
void expectDerivatives(const Profile& profile, double u)
{
  const double step = 1e-5;
  const CurvePoint before = profile.at(u - step);
  const CurvePoint here = profile.at(u);
  const CurvePoint after = profile.at(u + step);
  EXPECT_NEAR(here.dy, (after.y - before.y) / (2 * step), 1e-6);
  EXPECT_NEAR(here.dz, (after.z - before.z) / (2 * step), 1e-6);
  EXPECT_NEAR(here.ddy, (after.dy - before.dy) / (2 * step), 1e-3);
  EXPECT_NEAR(here.ddz, (after.dz - before.dz) / (2 * step), 1e-3);
}

TEST(ProfileSection, LineIsStraight)
{
  const Profile line = single(LineSection{0.01, -0.02, 0.6, 0.8}, 0.05);
  const CurvePoint end = line.at(0.05);
  EXPECT_DOUBLE_EQ(end.y, 0.04);
  EXPECT_DOUBLE_EQ(end.z, 0.02);
  EXPECT_DOUBLE_EQ(end.slope(), 0.8 / 0.6);
  EXPECT_EQ(end.curvature(), 0.0);
  expectDerivatives(line, 0.02);
}

TEST(ProfileSection, ArcHasConstantRadiusAndArcLengthAsParameter)
{
  for (const double turn : {1.0, -1.0})
  {
    const Profile arc = single(ArcSection{0.003, -0.004, 0.013, 0.7, turn}, 0.02);
    for (const double u : {0.0, 0.004, 0.0123, 0.02})
    {
      const CurvePoint p = arc.at(u);
      EXPECT_NEAR(std::hypot(p.y - 0.003, p.z + 0.004), 0.013, 1e-16);
      EXPECT_NEAR(std::hypot(p.dy, p.dz), 1.0, 1e-15);
      EXPECT_NEAR(p.curvature(), turn / 0.013, 1e-12);
    }
    expectDerivatives(arc, 0.01);
  }
}

TEST(ProfileSection, SlopeOfAVerticalArcIsInfinite)
{
  const Profile arc = single(ArcSection{0.0, 0.0, 0.02, M_PI, 1.0}, 0.01);
  EXPECT_GT(std::abs(arc.at(0.0).slope()), 1e15);
  EXPECT_NEAR(arc.at(0.0).curvature(), 50.0, 1e-12);
}

TEST(ProfileSection, PolynomialHasTheDerivativesOfItsFormula)
{
  // z = 2 - 3 y + 50 y^2 + 4000 y^3, from y = -0.01
  const Profile curve = single(PolynomialSection{-0.01, {2.0, -3.0, 50.0, 4000.0}, 4}, 0.03);
  for (const double y : {-0.01, 0.0, 0.007, 0.02})
  {
    const CurvePoint p = curve.at(y + 0.01);
    EXPECT_NEAR(p.y, y, 1e-17);
    EXPECT_NEAR(p.z, 2.0 - 3.0 * y + 50.0 * y * y + 4000.0 * y * y * y, 1e-14);
    EXPECT_NEAR(p.slope(), -3.0 + 100.0 * y + 12000.0 * y * y, 1e-13);
    const double bend = 100.0 + 24000.0 * y;
    EXPECT_NEAR(p.curvature(), bend / std::pow(1.0 + p.slope() * p.slope(), 1.5), 1e-11);
    expectDerivatives(curve, y + 0.01);
  }
}

TEST(ProfileSection, CubicHasTheDerivativesOfItsFormula)
{
  const Profile curve = single(CubicSection{{0.01, 0.9, -5.0, 300.0}, {0.02, -0.4, 20.0, -700.0}}, 0.01);
  const double t = 0.004;
  const CurvePoint p = curve.at(t);
  EXPECT_NEAR(p.y, 0.01 + 0.9 * t - 5.0 * t * t + 300.0 * t * t * t, 1e-16);
  EXPECT_NEAR(p.dz, -0.4 + 40.0 * t - 2100.0 * t * t, 1e-15);
  EXPECT_NEAR(p.ddy, -10.0 + 1800.0 * t, 1e-13);
  EXPECT_NEAR(p.ddz, 40.0 - 4200.0 * t, 1e-13);
  expectDerivatives(curve, t);
}

TEST(Profile, EndSectionsAreContinuedBeyondTheEnds)
{
  const Profile profile(
      "two", {{LineSection{0.0, 0.0, 1.0, 0.0}, 0.01}, {ArcSection{0.01, 0.02, 0.02, -M_PI / 2, 1.0}, 0.01}});
  EXPECT_DOUBLE_EQ(profile.at(-0.005).y, -0.005);
  EXPECT_DOUBLE_EQ(profile.at(-0.005).z, 0.0);
  EXPECT_NEAR(profile.at(0.01 + M_PI * 0.02).z, 0.04, 1e-16);
}

TEST(Profile, SecondSectionIsUsedAtASectionBoundary)
{
  const Profile profile("step", {{LineSection{0.0, 0.0, 1.0, 0.0}, 0.01}, {LineSection{0.01, 0.5, 1.0, 0.0}, 0.01}});
  EXPECT_EQ(profile.at(std::nextafter(0.01, 0.0)).z, 0.0);
  EXPECT_EQ(profile.at(0.01).z, 0.5);
  EXPECT_EQ(profile.at(profile.length()).z, 0.5);
  ASSERT_EQ(profile.discontinuities().size(), 3U);
  EXPECT_DOUBLE_EQ(profile.discontinuities()[1], 0.01);
}

TEST(Profile, SectionIsFoundForAnyLengths)
{
  // Every section is a line at the height of its number. The height therefore identifies the section that was used.
  // Lengths over eight orders of magnitude put many sections into one bucket.
  Seeded generator(20240611);
  std::uniform_real_distribution<double> exponent(-10.0, -2.0);
  std::vector<ProfileSection> sections;
  for (int i = 0; i < 300; ++i)
  {
    sections.push_back({LineSection{0.0, static_cast<double>(i), 1.0, 0.0}, std::pow(10.0, exponent(generator))});
  }
  const Profile profile("lines", sections);
  const std::vector<double>& discontinuities = profile.discontinuities();
  std::uniform_real_distribution<double> anywhere(0.0, profile.length());
  for (std::size_t i = 0; i + 1 < discontinuities.size(); ++i)
  {
    EXPECT_EQ(profile.at(discontinuities[i]).z, static_cast<double>(i));
    EXPECT_EQ(profile.at(std::nextafter(discontinuities[i + 1], 0.0)).z, static_cast<double>(i));
    const double u = anywhere(generator);
    const auto section =
        std::upper_bound(discontinuities.begin(), discontinuities.end(), u) - discontinuities.begin() - 1;
    EXPECT_EQ(profile.at(u).z, static_cast<double>(section));
  }
}

// The profile has a section of each type. The positions are in random order, across section boundaries and beyond both
// ends.
TEST(ProfileCursor, PointsAreThoseOfTheProfile)
{
  const Profile profile("all", {{LineSection{0.0, 0.0, 0.6, 0.8}, 0.01},
                                {ArcSection{0.003, -0.004, 0.013, 0.7, -1.0}, 0.02},
                                {PolynomialSection{-0.01, {2.0, -3.0, 50.0, 4000.0}, 4}, 0.03},
                                {CubicSection{{0.01, 0.9, -5.0, 300.0}, {0.02, -0.4, 20.0, -700.0}}, 0.005}});
  const std::vector<double>& discontinuities = profile.discontinuities();
  Seeded generator(20261125);
  std::uniform_real_distribution<double> anywhere(-0.01, profile.length() + 0.01);
  std::vector<double> places(discontinuities);
  for (int i = 0; i < 200; ++i)
  {
    places.push_back(anywhere(generator));
    places.push_back(places.back() + 1e-4);  // mostly on the same section
  }
  ProfileCursor cursor(profile);
  for (const double u : places)
  {
    const CurvePoint expected = profile.at(u);
    const CurvePoint read = cursor.at(u);
    for (const auto& value :
         {&CurvePoint::y, &CurvePoint::z, &CurvePoint::dy, &CurvePoint::dz, &CurvePoint::ddy, &CurvePoint::ddz})
    {
      EXPECT_EQ(read.*value, expected.*value) << "at " << u;
      EXPECT_EQ(cursor.expansionAt(u).point.*value, expected.*value) << "at " << u;
    }
    double reach = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k + 1 < discontinuities.size(); ++k)
    {
      reach = std::min(reach, std::abs(u - discontinuities[k]));
    }
    EXPECT_EQ(cursor.reach(), reach) << "at " << u;
  }
}

TEST(ProfileCursor, ThirdDerivativesAgreeWithDifferencesOfTheSecond)
{
  const double step = 1e-5;
  for (const SectionLaw& law :
       {SectionLaw(LineSection{0.0, 0.0, 0.6, 0.8}), SectionLaw(ArcSection{0.003, -0.004, 0.013, 0.7, 1.0}),
        SectionLaw(ArcSection{0.003, -0.004, 0.013, 0.7, -1.0}),
        SectionLaw(PolynomialSection{-0.01, {2.0, -3.0, 50.0, 4000.0, -1e5}, 5}),
        SectionLaw(CubicSection{{0.01, 0.9, -5.0, 300.0}, {0.02, -0.4, 20.0, -700.0}})})
  {
    const Profile profile = single(law, 0.02);
    const CurveExpansion here = ProfileCursor(profile).expansionAt(0.01);
    const CurvePoint before = profile.at(0.01 - step);
    const CurvePoint after = profile.at(0.01 + step);
    // Error of the difference: fifth derivative times step²/6, which is 6e-4 on the arc of 13 mm.
    EXPECT_NEAR(here.dddy, (after.ddy - before.ddy) / (2 * step), 1e-3);
    EXPECT_NEAR(here.dddz, (after.ddz - before.ddz) / (2 * step), 1e-3);
  }
}

TEST(Profile, PartsAreSeparateCurvesThatIncludeTheirEnds)
{
  const std::vector<ProfileSection> first{{ArcSection{0, 0, 0.02, M_PI, -1}, 0.03}, {LineSection{0, 0.02, 1, 0}, 0.01}};
  const std::vector<ProfileSection> second{{LineSection{0.05, 0.01, 0.8, 0.6}, 0.02}};
  const section_scenes::ProfileOfParts profile({first, second});
  ASSERT_EQ(profile.parts().size(), 2U);
  EXPECT_EQ(profile.parts()[0].begin, 0);
  EXPECT_DOUBLE_EQ(profile.parts()[0].end, 0.04);
  EXPECT_DOUBLE_EQ(profile.parts()[1].begin, 0.04 + Profile::part_distance);
  EXPECT_DOUBLE_EQ(profile.parts()[1].end, profile.length());
  ProfileCursor cursor(profile);
  for (const CurvePoint& end : {profile.at(profile.parts()[0].end), cursor.at(profile.parts()[0].end)})
  {
    EXPECT_DOUBLE_EQ(end.y, 0.01);
    EXPECT_DOUBLE_EQ(end.z, 0.02);
    EXPECT_DOUBLE_EQ(end.dy, 1);
  }
  const CurvePoint begin = profile.at(profile.parts()[1].begin);
  EXPECT_DOUBLE_EQ(begin.y, 0.05);
  EXPECT_DOUBLE_EQ(begin.dz, 0.6);
  EXPECT_DOUBLE_EQ(profile.at(profile.length()).y, 0.066);
}

TEST(Profile, InvalidSectionsAreRejected)
{
  const LineSection line{0.0, 0.0, 1.0, 0.0};
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(Profile("empty", {}), std::invalid_argument);
  EXPECT_THROW(single(line, 0.0), std::invalid_argument);
  EXPECT_THROW(single(line, -1.0), std::invalid_argument);
  EXPECT_THROW(single(line, infinity), std::invalid_argument);
  EXPECT_THROW(single(line, std::nan("")), std::invalid_argument);
  EXPECT_THROW(single(ArcSection{0.0, 0.0, 0.0, 0.0, 1.0}, 0.01), std::invalid_argument);
  EXPECT_THROW(single(PolynomialSection{0.0, {}, PolynomialSection::max_coefficients + 1}, 0.01),
               std::invalid_argument);
}
TEST(ProfilePart, OriginIsItsPointNearestToTheOriginOfTheProfile)
{
  // An arc of 0.3 m about a point below, whose top is 2 mm above the origin and 5 mm to the side; and a line beside it.
  const section_scenes::ProfileOfParts profile(
      {{{ArcSection{0.005, -0.298, 0.3, M_PI / 2 + 0.1, -1}, 0.06}}, {{LineSection{0.1, 0.0, 0, 1}, 0.02}}});
  const CurvePoint nearest = profile.at(profile.parts()[0].origin);
  EXPECT_NEAR(nearest.y * nearest.dy + nearest.z * nearest.dz, 0, 1e-9);
  EXPECT_NEAR(nearest.y, 0.005 - 0.3 * 0.005 / std::hypot(0.005, 0.298), 1e-9);
  EXPECT_EQ(profile.parts()[1].origin, profile.parts()[1].begin);
}

// The profile of a rail at a place of the line.

constexpr auto coordinates = RailSections::Placement::coordinates;

std::shared_ptr<const Profile> headAt(double y)
{
  return shared(profileOf({y}));
}

TEST(ChangingProfile, IsASectionAtItsPlaceAndACurveBetweenTwo)
{
  const auto a = headAt(0), b = headAt(0.01), c = headAt(0.02);
  const RailSections rail({{{1, a, {}}, {2, b, {}}, {4, c, {}}}}, coordinates);
  ChangingProfile changing(rail);
  for (const auto& [x, section] :
       std::vector<std::pair<double, std::shared_ptr<const Profile>>>{{1, a}, {2, b}, {4, c}})
  {
    EXPECT_TRUE(changing.moveTo(x));
    EXPECT_EQ(changing.profile(), section) << "the section itself, without a copy";
  }
  EXPECT_TRUE(changing.moveTo(2.5));
  EXPECT_EQ(changing.section(), 1U);
  EXPECT_EQ(changing.share(), 0.25);
  const Profile exact = curveOf(*rail.between(0, 1), 0.25);
  for (double u = 0; u < exact.length(); u += 1e-3)
  {
    EXPECT_EQ(changing.profile()->at(u).y, exact.at(u).y);
    EXPECT_EQ(changing.profile()->at(u).z, exact.at(u).z);
  }
}

// What is not known of a section is not known between it and the next one.
TEST(ChangingProfile, HasTheErrorsOfBothSectionsBetweenThem)
{
  std::vector<ProfileSection> measured, other;
  const double side = head_depth - corner;
  addHead({}, side, side, measured);
  addHead({0.01}, side, side, other);
  for (ProfileSection& section : measured)
  {
    section.error = {1e-6, 2, false};
  }
  for (ProfileSection& section : other)
  {
    section.error = {0, 0, true};
  }
  const auto a = std::make_shared<const Profile>("a", measured), b = std::make_shared<const Profile>("b", other);
  const RailSections rail({{{0, a, {}}, {1, b, {}}}}, coordinates);
  ChangingProfile changing(rail);
  changing.moveTo(0.5);
  const ShapeError error = changing.profile()->errorAt(0.5 * changing.profile()->length());
  EXPECT_EQ(error.position, 1e-6);
  EXPECT_EQ(error.curvature, 2);
  EXPECT_TRUE(error.missing);
}

TEST(ChangingProfile, IsAnotherOneOnlyWhereTheRailChanges)
{
  const auto a = headAt(0), b = headAt(0.01);
  const RailSections rail({{{0, a, {}}, {1, a, {}}, {2, a, {}}, {3, b, {}}}}, coordinates);
  ChangingProfile changing(rail);
  EXPECT_TRUE(changing.moveTo(0));
  for (const double x : {0.0, 0.3, 1.0, 1.7, 2.0})
  {
    EXPECT_FALSE(changing.moveTo(x)) << x;
    EXPECT_EQ(changing.profile(), a) << x;
  }
  EXPECT_TRUE(changing.moveTo(2.5));
  EXPECT_FALSE(changing.moveTo(2.5));
  EXPECT_TRUE(changing.moveTo(2.6));
  EXPECT_TRUE(changing.moveTo(1.5));
}

TEST(ChangingProfile, FurtherPartsExistFromTheirFirstToTheirLastSection)
{
  const auto a = headAt(0), nose = headAt(0.1), later = headAt(0.11), check = headAt(-0.15);
  const RailSections rail(
      {{{0, a, {}}, {10, a, {}}}, {{4, nose, {}}, {6, later, {}}}, {{5, check, {}}, {12, check, {}}}}, coordinates);
  ChangingProfile changing(rail);
  changing.reserve();
  const auto parts_at = [&](double x)
  {
    changing.moveTo(x);
    return changing.profile()->parts().size();
  };
  const std::vector<std::pair<double, std::size_t>> expected{{0, 1}, {3.999, 1}, {4, 2},     {4.5, 2},
                                                             {5, 3}, {6, 3},     {6.001, 2}, {10, 2}};
  for (const auto& [x, parts] : expected)
  {
    EXPECT_EQ(parts_at(x), parts) << x;
  }
  EXPECT_EQ(parts_at(4.999), 2U) << "in any order of the places";
}

// The parts of the composed profile are those of its sections, at parameters that are Profile::part_distance apart.
TEST(ChangingProfile, PartsKeepTheirCurves)
{
  const auto a = headAt(0), b = headAt(0.01), nose = headAt(0.1);
  const RailSections rail({{{0, a, {}}, {1, b, {}}}, {{0, nose, {}}, {1, nose, {}}}}, coordinates);
  ChangingProfile changing(rail);
  changing.moveTo(0.5);
  const auto& parts = changing.profile()->parts();
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[1].begin - parts[0].end, Profile::part_distance, 1e-15);  // rounding of a sum below 0.3 m
  const Profile first = curveOf(*rail.between(0, 0), 0.5);
  for (double u = 0; u < nose->length(); u += 1e-3)
  {
    EXPECT_NEAR(changing.profile()->at(parts[0].begin + u).y, first.at(u).y, 1e-15);  // rounding of u
    EXPECT_NEAR(changing.profile()->at(parts[1].begin + u).y, nose->at(u).y, 1e-15);
    EXPECT_NEAR(changing.profile()->at(parts[1].begin + u).z, nose->at(u).z, 1e-15);
  }
  // The end of a part belongs to it.
  EXPECT_NEAR(changing.profile()->at(parts[0].end).y, first.at(first.length()).y, 1e-12);  // rounding of cubic pieces
  EXPECT_NEAR(changing.profile()->at(parts[0].end).z, first.at(first.length()).z, 1e-12);
  EXPECT_EQ(changing.profile()->partAt(parts[0].end + 0.04).end, parts[0].end);
  EXPECT_EQ(changing.profile()->partAt(parts[0].end + 0.06).end, parts[1].end);
}

TEST(ChangingProfile, LongestProfileIsFoundBetweenSectionsToo)
{
  // Only from 9 m to 11 m both parts exist, between two sections of the running rail.
  const auto a = headAt(0), b = headAt(0.01), nose = headAt(0.1), later = headAt(0.11);
  const RailSections rail({{{0, a, {}}, {20, b, {}}, {40, a, {}}}, {{8, nose, {}}, {9, later, {}}}}, coordinates);
  ChangingProfile changing(rail);
  changing.reserve();
  changing.moveTo(8.7);
  EXPECT_EQ(changing.longest(), changing.profile()->length());
  EXPECT_GT(changing.longest(), 2 * a->length());
}
}  // namespace
