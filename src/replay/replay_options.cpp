// SPDX-License-Identifier: BSD-3-Clause
#include "replay/replay_options.h"

#include <ros/message_traits.h>
#include <ros/package.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <ostream>
#include <sstream>
#include <thread>

#include <wheel_rail_contact/WheelsetContact.h>

#include "core/option_check.h"

namespace wheel_rail_contact
{
namespace
{
namespace po = boost::program_options;

/// Beginning and end of the lines of a description that give a wheelset.
constexpr std::string_view wheelset_line = "wheelset: ", wheelset_inputs = "/wheelset";

/// Value of an option that is an integer from 1 to `most`.
int countOf(const std::string& option, const std::string& text, int most)
{
  std::size_t read = 0;
  int count = 0;
  try
  {
    count = std::stoi(text, &read);
  }
  catch (const std::exception&)  // not a number: rejected below
  {
  }
  core::refuseIf(read != text.size() || count < 1 || count > most,
                 option + " = " + text + ": must be an integer from 1 to " + std::to_string(most));
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
  core::refuseIf(!digits || seconds.empty() || seconds.size() > most_seconds || fraction.size() > decimals,
                 option + " = " + text + ": must be a recording time in seconds with at most 9 decimals");
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
    core::refuseIf(std::count(result.begin(), result.end(), result.back()) > 1,
                   "--wheelset " + name + ": is given twice");
  }
  return result;
}

/// Value of an option that names a topic.
std::string topicName(const std::string& option, const std::string& name)
{
  core::refuseIf(name.find_first_not_of('/') == std::string::npos,
                 option + " = \"" + name + "\": must be the name of a topic");
  return name;
}

void requireRelativeNames(const BagInputs& inputs)
{
  for (const auto& [topic, name] : inputs.names)
  {
    core::refuseIf(inputs.wheelsets.size() > 1 && name.rfind('/', 0) == 0,
                   optionOf(topic) + " = " + name +
                       ": must not begin with a slash if there are several wheelsets; the name is relative "
                       "to the namespace of each wheelset");
  }
}

/// Options that write their values to `options`.
po::options_description describe(ReplayOptions& options)
{
  constexpr unsigned width = 120;
  po::options_description described("options", width);
  using Words = std::vector<std::string>;
  const auto one = [](const char* value_name, const std::function<void(const std::string&)>& take)
  { return po::value<std::string>()->value_name(value_name)->notifier(take); };
  const auto time = [one](const std::string& option, std::uint64_t& target)
  { return one("T", [option, &target](const std::string& text) { target = recordingTime(option, text); }); };
  auto add = described.add_options();
  add("config", po::value(&options.configs)->value_name("F.yaml"),
      "parameters, applied over config/default.yaml and over the files given before");
  add("threads", one("N", [&](const std::string& text) { options.threads = countOf("--threads", text, 1024); }),
      "number of threads that evaluate; default: one per core");
  add("csv", po::value(&options.csv)->value_name("F.csv"),
      "also writes a table with one row per patch; the column names contain the units");
  add("wheelset",
      po::value<Words>()->multitoken()->value_name("NAME...")->notifier(
          [&](const Words& names) { options.inputs.wheelsets = namespaces(names); }),
      "namespaces of the wheelsets; the results for NAME/wheelset/pose are on NAME/contact_node/contact; default: /");
  for (const InputTopic topic : all_input_topics)
  {
    const std::string option = optionOf(topic);
    const std::string text = "topic of the bag to read instead of " + nameOf(topic) +
                             ". A name without a leading slash is relative to the namespace of each wheelset";
    add(option.substr(2).c_str(),
        one("TOPIC", [&options, topic, option](const std::string& name)
            { options.inputs.names[topic] = topicName(option, name); }),
        text.c_str());
  }
  add("from", time("--from", options.span.from),
      "evaluates only the inputs recorded from this time on [s]; each result is identical to that of the whole bag");
  add("to", time("--to", options.span.to), "evaluates only the inputs recorded before this time [s]");
  add("tf-static", po::value(&options.tf_static)->value_name("FIRST.bag"),
      "first part of a split recording: its messages on /tf_static, which later parts lack, are read before IN.bag");
  add("expand-up-to",
      one("MIB", [&](const std::string& text)
          { options.most_expanded = static_cast<std::uint64_t>(countOf("--expand-up-to", text, 1 << 30U)) << 20U; }),
      "largest total size of the decompressed chunks of IN.bag; default: 100 times the size of the file, at least 256");
  add("keep-topics", po::bool_switch(&options.keep_topics), "copies the other messages of IN.bag");
  add("no-grids", po::bool_switch()->notifier([&](bool given) { options.grids = !given; }), "omits the pressure grids");
  add("lz4", po::bool_switch()->notifier([&](bool given) { options.compression = given ? "lz4" : "none"; }),
      "compresses OUT.bag");
  add("resume", po::bool_switch(&options.resume),
      "continues an interrupted replay (Ctrl-C, crash); requires the same options");
  add("help,h", po::bool_switch(&options.help), "prints this text");
  return described;
}

/// The program_options library takes a following option for the value of an option.
void requireValues(const po::parsed_options& parsed)
{
  const auto is_option = [](const std::string& text) { return text.size() > 1 && text[0] == '-'; };
  for (const po::option& option : parsed.options)
  {
    core::refuseIf(option.position_key < 0 && std::any_of(option.value.begin(), option.value.end(), is_option),
                   "--" + option.string_key + ": requires a value");
  }
}
}  // namespace

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
    core::refuseIf(std::find(topics.begin(), topics.end(), topic) == topics.end(),
                   optionOf(topic) + " = " + name + ": the parameters require no " + nameOf(topic));
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

ReplayOptions parseReplayOptions(const std::vector<std::string>& arguments)
{
  using po::command_line_style::allow_guessing;
  using po::command_line_style::unix_style;
  ReplayOptions options;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const po::options_description described = describe(options);
  std::vector<std::string> files;
  try
  {
    const po::parsed_options parsed =
        po::command_line_parser(arguments).options(described).style(unix_style ^ allow_guessing).run();
    requireValues(parsed);
    po::variables_map values;
    po::store(parsed, values);
    po::notify(values);
    files = po::collect_unrecognized(parsed.options, po::include_positional);
  }
  catch (const po::error& error)
  {
    throw std::invalid_argument(error.what());
  }
  if (options.help)
  {
    return options;
  }
  core::refuseIf(options.span.from >= options.span.to, "--from: must be before --to");
  core::refuseIf(files.size() != 2, "two bags are required, IN.bag and OUT.bag, before --wheelset");
  options.input = files[0];
  options.output = files[1];
  requireRelativeNames(options.inputs);
  return options;
}

void printReplayUsage(std::ostream& out)
{
  ReplayOptions options;
  out << "usage: contact_replay IN.bag OUT.bag [options]\n\n"
         "Evaluates every pair of pose and load in a bag, as fast as the cores allow. The results are those of the\n"
         "live node. On one machine, the same bag and parameters give the same file, to the last byte.\n\n"
      << describe(options)
      << "\nExit status: 0 done; 1 failed, or IN.bag contains no pair; 2 wrong arguments; 3 done, but parts of IN.bag\n"
         "could not be read; 4 done, but fewer than half of the poses have a result of usable input, that is other\n"
         "than INVALID_INPUT and NO_TRANSFORM (not with --from or --to); 5 done, but the loads have a doubtful unit "
         "or\n"
         "sign; 130 interrupted.\n";
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
  if (!options.tf_static.empty())
  {
    text << "tf-static: " << options.tf_static << "\n";
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
