// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/parameters.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace simulate_wheelset
{
namespace
{
constexpr double shortest_step = 1e-6;  ///< [s]: rounding to a nanosecond then changes it by less than 0.1 %

/// Rule of a number.
enum class Rule
{
  finite,
  positive,
  not_negative,
  count  ///< a whole number of steps
};

bool holds(Rule rule, double value)
{
  switch (rule)
  {
    case Rule::finite:
      return std::isfinite(value);
    case Rule::positive:
      return std::isfinite(value) && value > 0;
    case Rule::not_negative:
      return std::isfinite(value) && value >= 0;
    case Rule::count:
      break;
  }
  return value >= 0 && value <= most_steps && value == std::floor(value);
}

std::string textOf(Rule rule)
{
  switch (rule)
  {
    case Rule::finite:
      return "a finite number";
    case Rule::positive:
      return "a finite number > 0";
    case Rule::not_negative:
      return "a finite number >= 0";
    case Rule::count:
      break;
  }
  return "a whole number from 0 to " + std::to_string(most_steps);
}

/// Shortest usual form of a number.
std::string textOf(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

/// A parameter by its name in the file.
struct Entry
{
  const char* group;
  const char* name;
  double* value;
  Rule rule;

  std::string fullName() const { return std::string(group) + "/" + name; }
};

std::vector<Entry> entriesOf(Parameters& p)
{
  return {{"wheelset", "mass", &p.wheelset.mass, Rule::positive},
          {"wheelset", "yaw_inertia", &p.wheelset.yaw_inertia, Rule::positive},
          {"wheelset", "spin_inertia", &p.wheelset.spin_inertia, Rule::positive},
          {"wheelset", "axle_load", &p.wheelset.axle_load, Rule::positive},
          {"suspension", "half_spacing", &p.suspension.half_spacing, Rule::positive},
          {"suspension", "longitudinal_stiffness", &p.suspension.longitudinal_stiffness, Rule::not_negative},
          {"suspension", "lateral_stiffness", &p.suspension.lateral_stiffness, Rule::not_negative},
          {"suspension", "vertical_stiffness", &p.suspension.vertical_stiffness, Rule::not_negative},
          {"suspension", "longitudinal_damping", &p.suspension.longitudinal_damping, Rule::not_negative},
          {"suspension", "lateral_damping", &p.suspension.lateral_damping, Rule::not_negative},
          {"creep", "friction", &p.creep.friction, Rule::positive},
          {"creep", "shear_modulus", &p.creep.shear_modulus, Rule::positive},
          {"creep", "poisson", &p.creep.poisson, Rule::not_negative},
          {"run", "speed", &p.run.speed, Rule::positive},
          {"run", "duration", &p.run.duration, Rule::positive},
          {"run", "step", &p.run.step, Rule::positive},
          {"run", "start", &p.run.start, Rule::finite},
          {"run", "y", &p.run.y, Rule::finite},
          {"run", "yaw", &p.run.yaw, Rule::finite},
          {"run", "held_steps", &p.run.held_steps, Rule::count}};
}

[[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& rule)
{
  throw std::invalid_argument(name + " = " + value + " must be " + rule);
}

[[noreturn]] void refuseUnknown(const std::string& group, const std::string& name)
{
  throw std::invalid_argument("parameter " + group + "/" + name + " has an unknown name");
}

void check(const Entry& entry)
{
  if (!holds(entry.rule, *entry.value))
  {
    refuse(entry.fullName(), textOf(*entry.value), textOf(entry.rule));
  }
}

void readGroup(const std::string& group, const YAML::Node& node, const std::vector<Entry>& entries)
{
  if (!node.IsMap())
  {
    throw std::invalid_argument("group " + group + " must be a map of names and values");
  }
  for (const auto& pair : node)
  {
    const auto name = pair.first.as<std::string>();
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& e) { return group == e.group && name == e.name; });
    if (entry == entries.end())
    {
      refuseUnknown(group, name);
    }
    try
    {
      *entry->value = pair.second.as<double>();
    }
    catch (const YAML::Exception&)
    {
      refuse(entry->fullName(), YAML::Dump(pair.second), "a number");
    }
  }
}
}  // namespace

Parameters readParameters(const std::string& file)
{
  Parameters parameters;
  try
  {
    const YAML::Node document = YAML::LoadFile(file);
    const std::vector<Entry> entries = entriesOf(parameters);
    if (!document.IsMap())
    {
      throw std::invalid_argument("the file must be a map of groups");
    }
    for (const auto& pair : document)
    {
      readGroup(pair.first.as<std::string>(), pair.second, entries);
    }
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
    check(entry);
  }
  if (parameters.creep.poisson > 0.5)
  {
    refuse("creep/poisson", textOf(parameters.creep.poisson), "from 0 to 0.5");
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
}  // namespace simulate_wheelset
