// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <deque>

#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
constexpr std::size_t pairs = 20;
const std::vector<std::string> wheelsets{"/wheelset_1", "/wheelset_2", "/wheelset_3", "/rear"};

/// Lateral displacement, different for each wheelset [m].
double lateral(std::size_t wheelset, std::size_t pair)
{
  return 1e-3 * static_cast<double>(wheelset) - 2e-5 * static_cast<double>(pair);
}
}  // namespace

TEST(LiveVehicle, EachOfFourWheelsetsGetsItsOwnResultsInOrder)
{
  std::deque<ContactClient> clients;
  for (const std::string& wheelset : wheelsets)
  {
    clients.emplace_back(wheelset, wheelset + "/contact_node");
  }
  for (std::size_t pair = 0; pair < pairs; ++pair)
  {
    const ros::Time stamp = ContactClient::nextStamp();
    for (std::size_t i = 0; i < clients.size(); ++i)
    {
      clients[i].send(ContactClient::pose(lateral(i, pair), stamp));
      clients[i].send(ContactClient::load(-200e3, stamp));
    }
  }
  for (std::size_t i = 0; i < clients.size(); ++i)
  {
    SCOPED_TRACE(wheelsets[i]);
    ASSERT_TRUE(clients[i].waitForResults(pairs)) << clients[i].results().size() << " results";
    for (std::size_t pair = 0; pair < pairs; ++pair)
    {
      const WheelsetContact& result = clients[i].results()[pair];
      EXPECT_EQ(result.status, WheelsetContact::OK) << result.status_text;
      EXPECT_EQ(result.wheelset.position.y, lateral(i, pair));
      ASSERT_FALSE(result.patches.empty());
      EXPECT_EQ(result.patches[0].method == "hertz", wheelsets[i] == "/rear");
    }
  }
}
