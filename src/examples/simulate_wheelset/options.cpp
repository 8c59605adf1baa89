// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/options.h"

#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

namespace simulate_wheelset
{
namespace
{
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

double numberOf(const std::string& option, const std::string& text)
{
  std::size_t end = 0;
  double value = 0;
  try
  {
    value = std::stod(text, &end);
  }
  catch (const std::exception&)
  {
    end = 0;
  }
  if (end == 0 || end != text.size())
  {
    throw std::invalid_argument(option + " " + text + ": must be a number");
  }
  return value;
}
}  // namespace

std::string usage()
{
  return "usage: simulate_wheelset [options]\n"
         "One wheelset on its primary suspension runs along a track. The contact comes from the contact calculation "
         "of\n"
         "wheel_rail_contact, the creep forces from Kalker's linear theory with a friction limit "
         "(doc/co_simulation.md).\n"
         "  --contact WAY            in_process (default), topics or service: the last two need a running contact "
         "node\n"
         "  --config F.yaml          parameters of the simulation, as in config/simulate_wheelset.yaml\n"
         "  --contact-config F.yaml  parameters of the contact for in_process; the contact node has its own\n"
         "  --speed V                running speed [m/s], over that of the file\n"
         "  --duration T             simulated time [s], over that of the file\n"
         "  --step S                 time step [s], over that of the file\n"
         "  --out F.csv              table of the run, one row per step\n"
         "  --node NAME              name of the contact node (default: contact_node)\n"
         "  --frame NAME             its parameter track/frame (default: track)\n";
}

Options parseOptions(const std::vector<std::string>& arguments)
{
  Options options;
  using Setter = std::function<void(const std::string&)>;
  const auto text = [](std::string& target) -> Setter
  { return [&target](const std::string& value) { target = value; }; };
  const auto number = [](const std::string& option, std::optional<double>& target) -> Setter
  { return [option, &target](const std::string& value) { target = numberOf(option, value); }; };
  const std::map<std::string, Setter> setters = {
      {"--contact", [&](const std::string& value) { options.contact = wayOf(value); }},
      {"--config", text(options.config)},
      {"--contact-config", text(options.contact_config)},
      {"--out", text(options.out)},
      {"--node", text(options.node)},
      {"--frame", text(options.frame)},
      {"--speed", number("--speed", options.speed)},
      {"--duration", number("--duration", options.duration)},
      {"--step", number("--step", options.step)}};
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    if (arguments[i] == "--help" || arguments[i] == "-h")
    {
      options.help = true;
      continue;
    }
    const auto setter = setters.find(arguments[i]);
    if (setter == setters.end())
    {
      throw std::invalid_argument(arguments[i] + ": unknown option");
    }
    if (++i == arguments.size())
    {
      throw std::invalid_argument(setter->first + ": a value must follow");
    }
    setter->second(arguments[i]);
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
