// SPDX-License-Identifier: BSD-3-Clause
#include "replay/bag_inputs.h"

#include <algorithm>
#include <stdexcept>

namespace wheel_rail_contact
{
std::string BagInputs::topicOf(const std::string& wheelset, InputTopic topic) const
{
  const auto given = names.find(topic);
  const std::string name = given == names.end() ? nameOf(topic) : given->second;
  return name.rfind('/', 0) == 0 ? name : wheelset + "/" + name;
}

/// Rejects the name of a topic that is not read.
void BagInputs::requireUsed(const std::vector<InputTopic>& topics) const
{
  for (const auto& [topic, name] : names)
  {
    if (std::find(topics.begin(), topics.end(), topic) == topics.end())
    {
      throw std::invalid_argument(optionOf(topic) + " = " + name + ": the parameters require no " + nameOf(topic));
    }
  }
}

/// Rejects two inputs on one topic: each message would be used for both.
void BagInputs::requireDistinct(const std::vector<InputTopic>& topics) const
{
  std::map<std::string, InputTopic> first;  // by name of the topic in the bag
  for (const std::string& wheelset : wheelsets)
  {
    for (const InputTopic topic : topics)
    {
      const std::string name = topicOf(wheelset, topic);
      if (const auto [found, is_new] = first.emplace(name, topic); !is_new)
      {
        throw std::invalid_argument("topic " + name + " is given for two inputs, " + optionOf(found->second) + " and " +
                                    optionOf(topic) + ": each input requires a topic of its own");
      }
    }
  }
}

void BagInputs::check(const std::vector<InputTopic>& topics) const
{
  requireUsed(topics);
  requireDistinct(topics);
}

std::string optionOf(InputTopic topic)
{
  const std::string name = nameOf(topic);
  std::string option = "--" + name.substr(name.find('/') + 1);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}
}  // namespace wheel_rail_contact
