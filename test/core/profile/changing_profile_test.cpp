// SPDX-License-Identifier: BSD-3-Clause
// The profile of a rail at a place of the line.
#include "core/profile/along/changing_profile.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "section_scenes.h"

using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::section_scenes;

namespace
{
constexpr auto coordinates = RailSections::Placement::coordinates;

std::shared_ptr<const Profile> headAt(double y)
{
  return shared(profileOf({y}));
}
}  // namespace

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
