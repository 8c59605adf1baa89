// SPDX-License-Identifier: BSD-3-Clause
#include "replay/bag_messages.h"

namespace wheel_rail_contact
{
// Transforms are added one by one, without reserving memory: the count in a damaged message may be arbitrarily large.
std::vector<geometry_msgs::TransformStamped> parseTransforms(std::string_view data)
{
  std::vector<geometry_msgs::TransformStamped> transforms;
  readStream(data,
             [&transforms](auto& stream)
             {
               std::uint32_t count = 0;
               stream.next(count);
               for (; count > 0; --count)
               {
                 stream.next(transforms.emplace_back());
               }
             });
  return transforms;
}
}  // namespace wheel_rail_contact
