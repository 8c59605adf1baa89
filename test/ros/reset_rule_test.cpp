// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/contact_input.h"

#include <gtest/gtest.h>

#include <vector>

using namespace wheel_rail_contact;

namespace
{
/// Indices of the stamps [ms] at which the warm start is reset.
std::vector<std::size_t> resets(const std::vector<int>& stamps)
{
  ResetRule rule;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < stamps.size(); ++i)
  {
    if (rule.resets(ros::Time(0, 0) + ros::Duration().fromNSec(std::int64_t{1000000} * stamps[i])))
    {
      result.push_back(i);
    }
  }
  return result;
}
}  // namespace

TEST(WarmStartReset, OccursAtTheFirstInputAndAtEveryWholeSecond)
{
  EXPECT_EQ(resets({500, 700, 999, 1000, 1999, 2000, 5000}), (std::vector<std::size_t>{0, 3, 5, 6}));
}

TEST(WarmStartReset, OccursWhenAStampDecreasesButNotWhenItIsRepeated)
{
  EXPECT_EQ(resets({500, 700, 600, 610, 610}), (std::vector<std::size_t>{0, 2}));
}

TEST(WarmStartReset, OccursAfterTwoHundredInputsOfOneSecond)
{
  std::vector<int> stamps;
  for (int i = 0; i < 450; ++i)
  {
    stamps.push_back(2000 + 2 * i);
  }
  EXPECT_EQ(resets(stamps), (std::vector<std::size_t>{0, 200, 400}));
}

// Two evaluators that begin at different inputs have the same resets from the next whole second on.
TEST(WarmStartReset, DoesNotDependOnInputsOfEarlierSeconds)
{
  const std::vector<int> all{100, 300, 900, 1100, 1200, 2100};
  const std::vector<int> late{900, 1100, 1200, 2100};
  EXPECT_EQ(resets(all), (std::vector<std::size_t>{0, 3, 5}));
  EXPECT_EQ(resets(late), (std::vector<std::size_t>{0, 1, 3}));
}
