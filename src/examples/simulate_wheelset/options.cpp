// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/options.h"

#include <boost/program_options.hpp>
#include <map>
#include <sstream>
#include <stdexcept>

namespace simulate_wheelset
{
namespace
{
namespace po = boost::program_options;

ContactWay wayOf(const std::string& word)
{
  const std::map<std::string, ContactWay> ways = {
      {"in_process", ContactWay::in_process}, {"topics", ContactWay::topics}, {"service", ContactWay::service}};
  const auto way = ways.find(word);
  if (way == ways.end())
  {
    throw std::invalid_argument("--contact " + word + ": must be in_process, topics or service");
  }
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
      "parameters of the contact for in_process, over config/default.yaml; the contact node has its own");
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

std::string usage()
{
  Options options;
  std::ostringstream out;
  out << "usage: simulate_wheelset [options]\n"
         "One wheelset on its primary suspension runs along a track. The contact comes from the contact calculation "
         "of\n"
         "wheel_rail_contact, the creep forces from Kalker's linear theory with a friction limit "
         "(doc/co_simulation.md).\n\n"
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
  catch (const po::validation_error& error)
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
  if (!options.contact_config.empty() && options.contact != ContactWay::in_process)
  {
    throw std::invalid_argument("--contact-config " + options.contact_config +
                                ": only with --contact in_process; the contact node has its own parameters");
  }
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
