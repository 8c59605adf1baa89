// SPDX-License-Identifier: BSD-3-Clause
#include "replay/warm_up.h"

#include <gtest/gtest.h>

#include <vector>

using namespace wheel_rail_contact;

namespace
{
/// Numbers of the inputs that are kept of slices with these lengths. The inputs are numbered from 0.
std::vector<int> kept(std::size_t results, const std::vector<int>& slices)
{
  WarmUpInputs warm_up(results);
  int number = 0;
  for (const int length : slices)
  {
    for (int i = 0; i < length; ++i)
    {
      PreparedInput input;
      input.resets = i == 0;
      input.state.distance = number++;
      warm_up.add(input);
    }
  }
  std::vector<int> numbers;
  for (const PreparedInput& input : warm_up.inputs())
  {
    numbers.push_back(static_cast<int>(input.state.distance));
  }
  return numbers;
}
}  // namespace

TEST(WarmUpInputs, KeepsTheLastSliceAndThoseWithTheRequiredResultsBeforeIt)
{
  EXPECT_EQ(kept(3, {2, 2, 2, 1}), (std::vector<int>{2, 3, 4, 5, 6}));
  EXPECT_EQ(kept(2, {2, 2, 2, 1}), (std::vector<int>{4, 5, 6}));
  EXPECT_EQ(kept(1, {1, 1, 1}), (std::vector<int>{1, 2}));
}

TEST(WarmUpInputs, KeepsAllInputsIfThereAreTooFew)
{
  EXPECT_EQ(kept(9, {2, 3}), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(kept(9, {}).empty());
}

TEST(WarmUpInputs, KeepsALongSliceFromItsBeginning)
{
  EXPECT_EQ(kept(2, {1, 6}), (std::vector<int>{0, 1, 2, 3, 4, 5, 6}));
}
