// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/parameters.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

namespace simulate_wheelset
{
namespace po = boost::program_options;

namespace
{
constexpr double shortest_step = 1e-6;  ///< [s]: rounding to a nanosecond then changes it by less than 0.1 %

/// Rule of a number.
struct Rule
{
  const char* text;
  bool (*holds)(double value);
};

constexpr Rule finite{"a finite number", [](double v) { return std::isfinite(v); }};
constexpr Rule positive{"a finite number > 0", [](double v) { return std::isfinite(v) && v > 0; }};
constexpr Rule not_negative{"a finite number >= 0", [](double v) { return std::isfinite(v) && v >= 0; }};
constexpr Rule on_off{"0 or 1", [](double v) { return v == 0 || v == 1; }};
constexpr Rule step_count{"a whole number from 0 to 10000000",  // most_steps
                          [](double v) { return v >= 0 && v <= most_steps && v == std::floor(v); }};

/// A parameter by its name in the file, with the group.
struct Entry
{
  std::string name;
  double* value;
  Rule rule;
};

std::vector<Entry> entriesOf(Parameters& p)
{
  return {
      {"wheelset/mass", &p.wheelset.mass, positive},
      {"wheelset/yaw_inertia", &p.wheelset.yaw_inertia, positive},
      {"wheelset/spin_inertia", &p.wheelset.spin_inertia, positive},
      {"wheelset/gyroscopic", &p.wheelset.gyroscopic, on_off},
      {"wheelset/line_inertia", &p.wheelset.line_inertia, on_off},
      {"wheelset/axle_load", &p.wheelset.axle_load, positive},
      {"suspension/half_spacing", &p.suspension.half_spacing, positive},
      {"suspension/longitudinal_stiffness", &p.suspension.longitudinal_stiffness, not_negative},
      {"suspension/lateral_stiffness", &p.suspension.lateral_stiffness, not_negative},
      {"suspension/vertical_stiffness", &p.suspension.vertical_stiffness, not_negative},
      {"suspension/longitudinal_damping", &p.suspension.longitudinal_damping, not_negative},
      {"suspension/lateral_damping", &p.suspension.lateral_damping, not_negative},
      {"run/speed", &p.run.speed, positive},
      {"run/duration", &p.run.duration, positive},
      {"run/step", &p.run.step, positive},
      {"run/start", &p.run.start, finite},
      {"run/y", &p.run.y, finite},
      {"run/yaw", &p.run.yaw, finite},
      {"run/held_steps", &p.run.held_steps, step_count},
  };
}

/// Shortest usual form of a number.
std::string textOf(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

[[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& rule)
{
  throw std::invalid_argument(name + " = " + value + " must be " + rule);
}

void require(bool is_met, const std::string& text)
{
  if (!is_met)
  {
    throw std::invalid_argument(text);
  }
}

void read(const YAML::Node& node, const Entry& entry)
{
  try
  {
    *entry.value = node.as<double>();
  }
  catch (const YAML::Exception&)
  {
    refuse(entry.name, YAML::Dump(node), "a number");
  }
}

void read(const YAML::Node& document, const std::vector<Entry>& entries)
{
  require(document.IsMap(), "the file must be a map of groups");
  for (const auto& group : document)
  {
    const auto group_name = group.first.as<std::string>();
    require(group.second.IsMap(), "group " + group_name + " must be a map of names and values");
    for (const auto& pair : group.second)
    {
      const std::string name = group_name + "/" + pair.first.as<std::string>();
      const auto entry =
          std::find_if(entries.begin(), entries.end(), [&name](const Entry& each) { return each.name == name; });
      require(entry != entries.end(), "parameter " + name + " has an unknown name");
      read(pair.second, *entry);
    }
  }
}

ContactWay wayOf(const std::string& word)
{
  const std::map<std::string, ContactWay> ways = {
      {"in_process", ContactWay::in_process}, {"topics", ContactWay::topics}, {"service", ContactWay::service}};
  const auto way = ways.find(word);
  require(way != ways.end(), "--contact " + word + ": must be in_process, topics or service");
  return way->second;
}

/// Options that write their values to `options`.
po::options_description describe(Options& options)
{
  constexpr unsigned width = 120;
  po::options_description described("options", width);
  const auto text = [](const char* value_name, std::string& target)
  { return po::value(&target)->value_name(value_name); };
  const auto number = [](const char* value_name, std::optional<double>& target)
  { return po::value<double>()->value_name(value_name)->notifier([&target](double value) { target = value; }); };
  const auto take_way = [&options](const std::string& word) { options.contact = wayOf(word); };
  auto add = described.add_options();
  add("contact", po::value<std::string>()->value_name("WAY")->notifier(take_way),
      "in_process (default), topics or service: the last two need a running contact node");
  add("config", text("F.yaml", options.config), "parameters of the simulation, as in config/simulate_wheelset.yaml");
  add("contact-config", text("F.yaml", options.contact_config),
      "parameters of the contact for in_process, over config/simulate_contact.yaml; the contact node has its own");
  add("speed", number("V", options.speed), "running speed [m/s], over that of the file");
  add("duration", number("T", options.duration), "simulated time [s], over that of the file");
  add("step", number("S", options.step), "time step [s], over that of the file");
  add("out", text("F.csv", options.out), "table of the run, one row per step");
  add("node", text("NAME", options.node), "name of the contact node (default: contact_node)");
  add("frame", text("NAME", options.frame), "its parameter track/frame (default: track)");
  add("help,h", po::bool_switch(&options.help), "prints this text");
  return described;
}
}  // namespace

Parameters readParameters(const std::string& file)
{
  Parameters parameters;
  try
  {
    read(YAML::LoadFile(file), entriesOf(parameters));
    validate(parameters);
  }
  catch (const std::exception& error)
  {
    throw std::invalid_argument(file + ": " + error.what());
  }
  return parameters;
}

void validate(const Parameters& parameters)
{
  Parameters copy = parameters;
  for (const Entry& entry : entriesOf(copy))
  {
    if (!entry.rule.holds(*entry.value))
    {
      refuse(entry.name, textOf(*entry.value), entry.rule.text);
    }
  }
  const RunParameters& run = parameters.run;
  if (run.step < shortest_step || run.step > run.duration)
  {
    refuse("run/step", textOf(run.step), "at least " + textOf(shortest_step) + " s, and at most run/duration");
  }
  if (run.duration / run.step > most_steps)
  {
    refuse("run/duration", textOf(run.duration), "at most " + std::to_string(most_steps) + " times run/step");
  }
}

std::int64_t RunParameters::stepNanoseconds() const
{
  return std::llround(1e9 * step);
}

int RunParameters::steps() const
{
  return static_cast<int>(std::ceil(1e9 * duration / static_cast<double>(stepNanoseconds()) - 1e-9));
}

std::string usage()
{
  Options options;
  std::ostringstream out;
  out << "usage: simulate_wheelset [options]\n"
         "One wheelset on its primary suspension runs along a track. The contact comes from the contact calculation "
         "of\n"
         "wheel_rail_contact, with friction (doc/co_simulation.md).\n\n"
      << describe(options);
  return out.str();
}

Options parseOptions(const std::vector<std::string>& arguments)
{
  using po::command_line_style::allow_guessing;
  using po::command_line_style::unix_style;
  Options options;
  const po::options_description described = describe(options);
  std::vector<std::string> others;
  try
  {
    const po::parsed_options parsed =
        po::command_line_parser(arguments).options(described).style(unix_style ^ allow_guessing).run();
    po::variables_map values;
    po::store(parsed, values);
    po::notify(values);
    others = po::collect_unrecognized(parsed.options, po::include_positional);
  }
  catch (const po::invalid_option_value& error)
  {
    throw std::invalid_argument(std::string(error.what()) + ": must be a number");
  }
  catch (const po::error& error)
  {
    throw std::invalid_argument(error.what());
  }
  if (!others.empty())
  {
    throw std::invalid_argument(others[0] + ": unknown option");
  }
  require(options.contact_config.empty() || options.contact == ContactWay::in_process,
          "--contact-config " + options.contact_config +
              ": only with --contact in_process; the contact node has its own parameters");
  return options;
}

Parameters parametersOf(const Options& options)
{
  Parameters parameters = options.config.empty() ? Parameters() : readParameters(options.config);
  parameters.run.speed = options.speed.value_or(parameters.run.speed);
  parameters.run.duration = options.duration.value_or(parameters.run.duration);
  parameters.run.step = options.step.value_or(parameters.run.step);
  validate(parameters);
  return parameters;
}
}  // namespace simulate_wheelset
