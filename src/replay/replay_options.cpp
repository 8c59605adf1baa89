// SPDX-License-Identifier: BSD-3-Clause
#include "replay/replay_options.h"

#include <ros/message_traits.h>
#include <ros/package.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>

#include <wheel_rail_contact/WheelsetContact.h>

namespace wheel_rail_contact
{
namespace
{
/// Beginning and end of the lines of a description that give a wheelset.
constexpr std::string_view wheelset_line = "wheelset: ", wheelset_inputs = "/wheelset";

bool isOption(const std::string& argument)
{
  return argument.size() > 1 && argument[0] == '-';
}

/// Iterator over the arguments.
class Arguments
{
 public:
  explicit Arguments(const std::vector<std::string>& all) : all_(all) {}

  bool empty() const { return next_ == all_.size(); }
  std::string take() { return all_[next_++]; }

  /// Value of an option. @throw std::invalid_argument if it is missing.
  std::string valueOf(const std::string& option)
  {
    if (empty() || isOption(all_[next_]))
    {
      throw std::invalid_argument(option + ": requires a value");
    }
    return take();
  }

  /// One or more values up to the next option.
  std::vector<std::string> valuesOf(const std::string& option)
  {
    std::vector<std::string> values{valueOf(option)};
    while (!empty() && !isOption(all_[next_]))
    {
      values.push_back(take());
    }
    return values;
  }

 private:
  const std::vector<std::string>& all_;
  std::size_t next_ = 0;
};

int threadCount(const std::string& text)
{
  constexpr int most = 1024;
  std::size_t read = 0;
  int count = 0;
  try
  {
    count = std::stoi(text, &read);
  }
  catch (const std::exception&)  // not a number: rejected below
  {
  }
  if (read != text.size() || count < 1 || count > most)
  {
    throw std::invalid_argument("--threads = " + text + ": must be an integer from 1 to 1024");
  }
  return count;
}

/// Recording time [ns] from a text in seconds, such as 1700000000.25.
std::uint64_t recordingTime(const std::string& option, const std::string& text)
{
  constexpr std::size_t most_seconds = 10, decimals = 9;
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string seconds = text.substr(0, point);
  std::string fraction = point < text.size() ? text.substr(point + 1) : "";
  const bool digits = (seconds + fraction).find_first_not_of("0123456789") == std::string::npos;
  if (!digits || seconds.empty() || seconds.size() > most_seconds || fraction.size() > decimals)
  {
    throw std::invalid_argument(option + " = " + text +
                                ": must be a recording time in seconds with at most 9 decimals");
  }
  fraction.resize(decimals, '0');
  return std::stoull(seconds) * 1000000000 + std::stoull(fraction);
}

/// Namespace from a name: "/front" from "front", "/front" or "/front/", and "" from "/".
std::string asNamespace(const std::string& name)
{
  const auto first = name.find_first_not_of('/');
  if (first == std::string::npos)
  {
    return "";
  }
  return "/" + name.substr(first, name.find_last_not_of('/') - first + 1);
}

std::vector<std::string> namespaces(const std::vector<std::string>& names)
{
  std::vector<std::string> result;
  for (const std::string& name : names)
  {
    result.push_back(asNamespace(name));
    if (std::count(result.begin(), result.end(), result.back()) > 1)
    {
      throw std::invalid_argument("--wheelset " + name + ": is given twice");
    }
  }
  return result;
}

/// Input topic whose name an option gives; empty for another option.
std::optional<InputTopic> topicOf(const std::string& option)
{
  const auto found = std::find_if(all_input_topics.begin(), all_input_topics.end(),
                                  [&option](InputTopic topic) { return optionOf(topic) == option; });
  return found == all_input_topics.end() ? std::nullopt : std::optional<InputTopic>(*found);
}

/// Value of an option that names a topic.
std::string topicName(const std::string& option, const std::string& name)
{
  if (name.find_first_not_of('/') == std::string::npos)
  {
    throw std::invalid_argument(option + " = \"" + name + "\": must be the name of a topic");
  }
  return name;
}

void requireRelativeNames(const BagInputs& inputs)
{
  for (const auto& [topic, name] : inputs.names)
  {
    if (inputs.wheelsets.size() > 1 && name.rfind('/', 0) == 0)
    {
      throw std::invalid_argument(optionOf(topic) + " = " + name +
                                  ": must not begin with a slash if there are several wheelsets; the name is relative "
                                  "to the namespace of each wheelset");
    }
  }
}

void takeOption(const std::string& option, Arguments& arguments, ReplayOptions& options,
                std::vector<std::string>& wheelsets)
{
  if (option == "--config")
  {
    options.configs.push_back(arguments.valueOf(option));
  }
  else if (option == "--csv")
  {
    options.csv = arguments.valueOf(option);
  }
  else if (option == "--threads")
  {
    options.threads = threadCount(arguments.valueOf(option));
  }
  else if (option == "--wheelset")
  {
    const auto names = arguments.valuesOf(option);
    wheelsets.insert(wheelsets.end(), names.begin(), names.end());
  }
  else if (const auto topic = topicOf(option))
  {
    options.inputs.names[*topic] = topicName(option, arguments.valueOf(option));
  }
  else if (option == "--from")
  {
    options.span.from = recordingTime(option, arguments.valueOf(option));
  }
  else if (option == "--to")
  {
    options.span.to = recordingTime(option, arguments.valueOf(option));
  }
  else if (option == "--keep-topics")
  {
    options.keep_topics = true;
  }
  else if (option == "--no-grids")
  {
    options.grids = false;
  }
  else if (option == "--lz4")
  {
    options.compression = "lz4";
  }
  else if (option == "--resume")
  {
    options.resume = true;
  }
  else if (option == "--help" || option == "-h")
  {
    options.help = true;
  }
  else
  {
    throw std::invalid_argument(option + ": unknown option");
  }
}
}  // namespace

ReplayOptions parseReplayOptions(const std::vector<std::string>& arguments)
{
  ReplayOptions options;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<std::string> files, wheelsets;
  for (Arguments rest(arguments); !rest.empty();)
  {
    const std::string argument = rest.take();
    if (isOption(argument))
    {
      takeOption(argument, rest, options, wheelsets);
    }
    else
    {
      files.push_back(argument);
    }
  }
  if (options.help)
  {
    return options;
  }
  if (options.span.from >= options.span.to)
  {
    throw std::invalid_argument("--from: must be before --to");
  }
  if (files.size() != 2)
  {
    throw std::invalid_argument("two bags are required, IN.bag and OUT.bag, before --wheelset");
  }
  options.input = files[0];
  options.output = files[1];
  if (!wheelsets.empty())
  {
    options.inputs.wheelsets = namespaces(wheelsets);
  }
  requireRelativeNames(options.inputs);
  return options;
}

void printReplayUsage(std::ostream& out)
{
  out << "usage: contact_replay IN.bag OUT.bag [--config F.yaml]... [--threads N] [--csv F.csv] [--wheelset NAME...]\n"
         "                      [--pose TOPIC] [--load TOPIC] [--left-rail-force TOPIC] [--right-rail-force TOPIC]\n"
         "                      [--rail-displacement TOPIC] [--distance TOPIC]\n"
         "                      [--from T] [--to T] [--keep-topics] [--no-grids] [--lz4] [--resume]\n"
         "\n"
         "Evaluates every pair of pose and load in a bag, as fast as the cores allow. The results are those of the\n"
         "live node. On one machine, the same bag and parameters give the same file, to the last byte.\n"
         "\n"
         "  --config F.yaml     parameters, applied over config/default.yaml and over the files given before\n"
         "  --threads N         number of threads that evaluate; default: one per core\n"
         "  --csv F.csv         also writes a table with one row per patch; the column names contain the units\n"
         "  --wheelset NAME...  namespaces of the wheelsets; the results for NAME/wheelset/pose are on\n"
         "                      NAME/contact_node/contact; default: /\n"
         "  --pose TOPIC        the poses are on this topic instead of wheelset/pose. A name without a leading slash "
         "is\n"
         "                      relative to the namespace of each wheelset. The same for the other inputs: --load,\n"
         "                      --left-rail-force, --right-rail-force, --rail-displacement, --distance\n"
         "  --from T, --to T    evaluates only the inputs recorded from the first time on and before the second one\n"
         "                      [s]; each result is identical to that of the whole bag\n"
         "  --keep-topics       copies the other messages of IN.bag\n"
         "  --no-grids          omits the pressure grids\n"
         "  --lz4               compresses OUT.bag\n"
         "  --resume            continues an interrupted replay (Ctrl-C, crash); requires the same options\n"
         "\n"
         "Exit status: 0 done; 1 failed, or IN.bag contains no pair; 2 wrong arguments; 3 done, but parts of IN.bag\n"
         "could not be read; 4 done, but fewer than half of the poses have a result of usable input, that is other\n"
         "than INVALID_INPUT and NO_TRANSFORM (not with --from or --to); 130 interrupted.\n";
}

ParameterTree replayParameters(const ReplayOptions& options)
{
  std::vector<ParameterSource> sources{{ParameterSource::file, default_parameters}};
  for (const std::string& file : options.configs)
  {
    sources.push_back({ParameterSource::file, file});
  }
  return readParameters(sources, {".", ros::package::getPath});
}

std::string replayDescription(const ReplayOptions& options, const ParameterTree& parameters, std::uint64_t input_size)
{
  std::ostringstream text;
  text << "input size: " << input_size << " B\n";
  text << "options: message " << ros::message_traits::md5sum<WheelsetContact>() << ", grids " << options.grids
       << ", keep topics " << options.keep_topics << ", compression " << options.compression << "\n";
  for (const std::string& name : options.inputs.wheelsets)
  {
    text << wheelset_line << name << wheelset_inputs << "\n";
  }
  for (const auto& [topic, name] : options.inputs.names)
  {
    text << optionOf(topic) << ": " << name << "\n";
  }
  for (const auto& [name, value] : parameters)
  {
    text << name << ": " << YAML::Dump(value) << "\n";
  }
  if (!options.span.isWhole())
  {
    text << part_line << options.span.from << " ns to " << options.span.to << " ns\n";
  }
  return text.str();
}

std::vector<std::string> describedWheelsets(const std::string& description)
{
  std::vector<std::string> names;
  std::istringstream lines(description);
  std::string line;
  std::getline(lines, line);  // line of the input
  std::getline(lines, line);  // line of the options
  while (std::getline(lines, line) && line.rfind(wheelset_line, 0) == 0)
  {
    const std::size_t both = wheelset_line.size() + wheelset_inputs.size();
    names.push_back(line.substr(wheelset_line.size(), line.size() - both));
  }
  return names;
}
}  // namespace wheel_rail_contact
