// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
constexpr std::size_t pairs = 201;
const ros::Time first(1, 0);

double force(const WheelsetContact& result, std::uint8_t side)
{
  double vertical = 0;
  for (const ContactPatch& patch : result.patches)
  {
    if (patch.side == side)
    {
      vertical += patch.normal_force * std::cos(patch.contact_angle);
    }
  }
  return vertical;
}
}  // namespace

TEST(LiveSweep, EveryPairOfTheRecordingIsEvaluatedAndBothWheelsCarryTheirLoad)
{
  ros::NodeHandle nh;
  std::vector<WheelsetContact> results;
  const auto receive = [&](const WheelsetContact::ConstPtr& result) { results.push_back(*result); };
  const auto subscriber = nh.subscribe<WheelsetContact>("/contact_node/contact", 1000, receive);
  ASSERT_TRUE(spinUntil([&] { return results.size() >= pairs; }, 100)) << results.size() << " results";
  for (std::size_t i = 0; i < pairs; ++i)
  {
    const WheelsetContact& result = results[i];
    SCOPED_TRACE("y = " + std::to_string(result.wheelset.position.y));
    EXPECT_EQ(result.header.stamp, first + ros::Duration().fromNSec(20000000 * static_cast<std::int64_t>(i)));
    EXPECT_EQ(result.status, WheelsetContact::OK) << result.status_text;
    // The normal of the patch plane is the mean normal of the pressure; the difference is below 1 % of the load.
    EXPECT_NEAR(force(result, ContactPatch::LEFT), 100e3, 1e3);
    EXPECT_NEAR(force(result, ContactPatch::RIGHT), 100e3, 1e3);
  }
  // The wheelset moves to the right until the flange carries, and back through the same positions. Where the contact
  // jumps from tread to flange (y = -6.3 to -6.5 mm), the error estimate may exceed the tolerance of 0.3 %. There the
  // force of a wheel has an error of 0.4 %. The height depends strongly on the force and has an error of up to 6 um.
  std::size_t above_tolerance = 0;
  for (std::size_t i = 0; i < pairs / 2; ++i)
  {
    const WheelsetContact &there = results[i], &back = results[pairs - 1 - i];
    const bool within = there.status_text.empty() && back.status_text.empty();
    EXPECT_NEAR(there.wheelset.position.z, back.wheelset.position.z, within ? 5e-6 : 20e-6)
        << "y = " << there.wheelset.position.y;
    above_tolerance += within ? 0 : 1;
  }
  EXPECT_LE(above_tolerance, pairs / 20);
  EXPECT_GT(results[pairs / 2].right_rail.lateral_force, 50e3);
}
