// SPDX-License-Identifier: BSD-3-Clause
// Bags: all readable messages are delivered, or a BagError is thrown.
#include "../temporary_folder.h"
#include "bag/bag_stream.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace wheel_rail_contact;
  static const Folder folder;
  try
  {
    BagStream stream(folder.write("input.bag", {data, data + size}),
                     [](const std::string& topic) { return !topic.empty(); });
    while (const auto message = stream.next())
    {
      if (message->connection->topic.empty())
      {
        std::abort();
      }
    }
  }
  catch (const BagError&)  // rejected with a reason
  {
  }
  return 0;
}
