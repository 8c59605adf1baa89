// SPDX-License-Identifier: BSD-3-Clause
#include "replay/bag_inputs.h"

#include <algorithm>

namespace wheel_rail_contact
{
std::string BagInputs::topicOf(const std::string& wheelset, InputTopic topic) const
{
  const auto given = names.find(topic);
  const std::string name = given == names.end() ? nameOf(topic) : given->second;
  return name.rfind('/', 0) == 0 ? name : wheelset + "/" + name;
}

std::string optionOf(InputTopic topic)
{
  const std::string name = nameOf(topic);
  std::string option = "--" + name.substr(name.find('/') + 1);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}
}  // namespace wheel_rail_contact
