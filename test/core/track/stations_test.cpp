// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "../../manchester_scene.h"
#include "core/profile/smoothing_spline.h"
#include "core/track/contact_search.h"
#include "wheel_rail_contact/core/standard_profiles.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double spacing = 2.5e-4;  ///< distance of the stations of the search [m]
constexpr double everywhere = 10;   ///< greater than the separation at any position [m]
constexpr double rounding = 1e-13;  ///< rounding error of sums up to 10 m [m]

class StationsTest : public testing::Test
{
 protected:
  double unit() { return unit_(random_); }
  std::shared_ptr<const Profile> wavyRail();
  void place(const std::shared_ptr<const Profile>& profile);
  double anyEnd();
  std::vector<Station> between(double u_begin, double u_end, double separation)
  {
    std::vector<Station> found;
    search_->addStationsBetween(u_begin, u_end, separation, found);
    return found;
  }

  const unsigned seed_ = 20112U;
  testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(seed_)};
  std::mt19937 random_{seed_};
  std::uniform_real_distribution<double> unit_{-1, 1};
  ContactModelConfig config_ = manchesterScene();
  std::unique_ptr<PlacedRail> rail_;
  std::unique_ptr<PlacedWheel> wheel_;
  std::unique_ptr<ContactSearch> search_;
  std::vector<Station> all_;  ///< stations of the whole rail
};

/// 60E1 with waves on its surface. The waves are inclined outward by up to 45 degrees; parts of the profile overhang.
std::shared_ptr<const Profile> StationsTest::wavyRail()
{
  const Profile base = rail60E1();
  const double height = 4e-3 * std::abs(unit());
  const double length = 1e-2 + 5e-3 * unit();
  const double tilt = unit();
  std::vector<SampledPoint> points;
  for (double u = 0; u < base.length(); u += spacing)
  {
    const CurvePoint p = base.at(u);
    const double wave = height * std::sin(2 * std::acos(-1.0) * u / length);
    points.push_back({p.y + tilt * wave, p.z + wave});
  }
  return std::make_shared<Profile>("wavy", interpolatingSpline(points));
}

void StationsTest::place(const std::shared_ptr<const Profile>& profile)
{
  rail_ = std::make_unique<PlacedRail>(PlacedRail(profile, config_.track).deflected({3e-3 * unit(), 0, 0.1 * unit()}));
  const WheelsetPose pose{0.01 * unit(), 0.46, 0.02 * unit(), 0.01 * unit()};
  wheel_ = std::make_unique<PlacedWheel>(*config_.wheel_profile, config_.wheelset, pose);
  search_ = std::make_unique<ContactSearch>(*config_.wheel_profile, *profile);
  search_->setRail(*rail_);
  search_->setWheel(*wheel_);
  all_ = between(-1, 1, everywhere);
}

/// Random parameter of the rail profile [m]: exactly at a station, the next number to one, or anywhere.
double StationsTest::anyEnd()
{
  const double share = std::abs(unit());
  const double at_station = all_[static_cast<std::size_t>(share * static_cast<double>(all_.size() - 1))].rail_u;
  const double kind = unit();
  if (kind < -0.4)
  {
    return at_station;
  }
  return kind < 0.2 ? std::nextafter(at_station, unit()) : 0.2 * unit();
}
}  // namespace

// There is a station every 0.25 mm across the whole width of the rail.
TEST_F(StationsTest, StationsCoverTheWholeRail)
{
  for (int i = 0; i < 100; ++i)
  {
    place(i == 0 ? std::make_shared<const Profile>(rail60E1()) : wavyRail());
    double low = 1;
    double high = -1;
    const double length = rail_->profile().length();
    const long chords = std::lround(length / spacing);  // segments of the outline
    for (long k = 0; k <= chords; ++k)
    {
      const double y = rail_->at(length * static_cast<double>(k) / static_cast<double>(chords)).y;
      low = std::min(low, y);
      high = std::max(high, y);
    }
    SpacePoint wheel_end{};
    ASSERT_TRUE(wheel_->locus(config_.wheel_profile->at(config_.wheel_profile->length()), wheel_end));
    high = std::min(high, wheel_end.y);
    ASSERT_GT(all_.size(), 2U);
    EXPECT_NEAR(all_.front().y, low, rounding);
    EXPECT_GT(all_.back().y, high - spacing - rounding);
    for (std::size_t k = 1; k < all_.size(); ++k)
    {
      EXPECT_NEAR(all_[k].y - all_[k - 1].y, spacing, rounding);
    }
  }
}

// The stations of any part of the rail profile are those of the whole rail in this part. This must also hold where the
// rail overhangs: stations may then be outside the lateral positions of the two ends of the part.
TEST_F(StationsTest, StationsOfAPartOfTheRailAreThoseOfTheWholeRailInIt)
{
  int found_any = 0;
  int beyond_ends = 0;
  for (int i = 0; i < 300; ++i)
  {
    place(i == 0 ? std::make_shared<const Profile>(rail60E1()) : wavyRail());
    for (int part = 0; part < 200; ++part)
    {
      const double one = anyEnd();
      const double other = part % 2 == 0 ? anyEnd() : one + 1e-3 * unit();
      const double u_begin = part % 10 == 0 ? one : std::min(one, other);
      const double u_end = part % 10 == 0 ? other : std::max(one, other);
      const double separation = part % 3 == 0 ? everywhere : 0.01 * unit();
      std::vector<Station> expected;
      for (const Station& station : all_)
      {
        const double over = everywhere - station.depth;
        if (station.rail_u > u_begin && station.rail_u < u_end && over < separation)
        {
          expected.push_back(station);
        }
      }
      const std::vector<Station> found = between(u_begin, u_end, separation);
      ASSERT_EQ(found.size(), expected.size()) << "between " << u_begin << " and " << u_end;
      for (std::size_t k = 0; k < found.size(); ++k)
      {
        EXPECT_EQ(found[k].y, expected[k].y);
        EXPECT_EQ(found[k].rail_u, expected[k].rail_u);
        EXPECT_NEAR(found[k].depth, separation - (everywhere - expected[k].depth), rounding);
      }
      if (!found.empty())
      {
        ++found_any;
        const double last_u = rail_->profile().length();
        const double begin = rail_->at(std::clamp(u_begin, 0.0, last_u)).y;
        const double end = rail_->at(std::clamp(u_end, 0.0, last_u)).y;
        beyond_ends +=
            found.front().y < std::min(begin, end) - 2 * spacing || found.back().y > std::max(begin, end) + 2 * spacing
                ? 1
                : 0;
      }
    }
  }
  EXPECT_GT(found_any, 10000);
  EXPECT_GT(beyond_ends, 100);
}
