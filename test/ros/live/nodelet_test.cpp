// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "../message_bytes.h"
#include "contact_client.h"

using namespace wheel_rail_contact;

TEST(LiveNodelet, GivesBitwiseTheSameResultsAsTheNode)
{
  ContactClient node("/", "/contact_node");
  ContactClient nodelet("/", "/contact_nodelet");
  constexpr std::size_t count = 40;
  for (std::size_t i = 0; i < count; ++i)
  {
    const ros::Time stamp = ContactClient::nextStamp();
    auto pose = ContactClient::pose(-2e-4 * static_cast<double>(i), stamp);
    if (i == 20)
    {
      pose.header.frame_id = "nowhere";
    }
    node.send(pose);
    node.send(ContactClient::load(-200e3, stamp));
  }
  ASSERT_TRUE(node.waitForResults(count));
  ASSERT_TRUE(nodelet.waitForResults(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    EXPECT_EQ(bytesWithoutTime(node.results()[i]), bytesWithoutTime(nodelet.results()[i])) << "result " << i;
  }
  EXPECT_EQ(node.results()[20].status, WheelsetContact::NO_TRANSFORM);
}
