// SPDX-License-Identifier: BSD-3-Clause
#include "replay/held_results.h"

#include "replay/bag_messages.h"
#include "replay/csv_rows.h"
#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
void HeldResults::follow(std::uint8_t status, const std::string& data)
{
  if (isUsable(status))
  {
    last_ = data;
  }
  else
  {
    complete(data);
  }
}

void HeldResults::complete(OutputItem& item, const std::string& wheelset)
{
  if (isUsable(item.status))
  {
    last_ = item.data;
    return;
  }
  const auto message = complete(item.data);
  item.data = serialized(*message);
  item.reason = message->status_text;
  item.held = message->held;
  if (!item.csv.empty())
  {
    item.csv = csvRows(*message, item.result, wheelset);
  }
}

/// @param data bytes of a result that is not usable
boost::shared_ptr<WheelsetContact> HeldResults::complete(const std::string& data)
{
  if (!last_.empty())
  {
    hold_.apply(parse<WheelsetContact>(last_));
    last_.clear();
  }
  auto message = parse<WheelsetContact>(data);
  hold_.apply(message);
  return message;
}
}  // namespace wheel_rail_contact
