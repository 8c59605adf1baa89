// SPDX-License-Identifier: BSD-3-Clause
// Bags: every message that can be read, in the order of time, or a BagError.
#include <cstdlib>

#include "bag/bag_stream.h"
#include "scratch_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace wheel_rail_contact;
  static const fuzz::ScratchFolder folder;
  try
  {
    BagStream stream(folder.write("input.bag", data, size), [](const std::string& topic) { return !topic.empty(); });
    while (const auto message = stream.next())
    {
      if (message->connection->topic.empty())
      {
        std::abort();
      }
    }
  }
  catch (const BagError&)  // refused with a reason
  {
  }
  return 0;
}
