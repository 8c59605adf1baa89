// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/newest_queue.h"

#include <gtest/gtest.h>

#include <thread>

using wheel_rail_contact::NewestQueue;

TEST(NewestQueue, KeepsTheNewestEntriesInOrderAndCountsTheOthers)
{
  NewestQueue<int> queue(3);
  for (int i = 1; i <= 5; ++i)
  {
    queue.push(i);
  }
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_EQ(queue.pop(), 4);
  EXPECT_EQ(queue.pop(), 5);
  EXPECT_EQ(queue.dropped(), 2U);
}

TEST(NewestQueue, WaitingEndsWithAnEntry)
{
  NewestQueue<int> queue(1);
  EXPECT_FALSE(queue.waitForEntry(0.001));
  std::thread writer([&queue] { queue.push(1); });
  EXPECT_TRUE(queue.waitForEntry(60));
  writer.join();
  EXPECT_EQ(queue.pop(), 1) << "waiting must not remove the entry";
  queue.close();
  EXPECT_TRUE(queue.waitForEntry(60));
}

TEST(NewestQueue, ClosingEndsTheWaitingOfTheReader)
{
  NewestQueue<int> queue(1);
  std::thread reader([&queue] { EXPECT_EQ(queue.pop(), std::nullopt); });
  queue.close();
  reader.join();
  queue.push(1);
  EXPECT_EQ(queue.pop(), std::nullopt);
}

TEST(NewestQueue, EveryEntryIsDeliveredOrCounted)
{
  NewestQueue<int> queue(10);
  constexpr int count = 20000;
  int delivered = 0, last = -1;
  std::thread reader(
      [&]
      {
        while (last != count - 1)
        {
          const int entry = *queue.pop();
          EXPECT_GT(entry, last);
          last = entry;
          ++delivered;
        }
      });
  for (int i = 0; i < count; ++i)
  {
    queue.push(i);
  }
  reader.join();
  EXPECT_EQ(static_cast<std::uint64_t>(delivered) + queue.dropped(), static_cast<std::uint64_t>(count));
}
