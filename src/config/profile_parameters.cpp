// SPDX-License-Identifier: BSD-3-Clause
#include "config/body_parameters.h"

#include <algorithm>

#include "core/text/table_title.h"

namespace wheel_rail_contact
{
namespace
{
constexpr double micrometre = 1e-6;  ///< [m]
constexpr std::array<const char*, 9> names{"unit",    "y",      "z",      "origin",   "shift/y",
                                           "shift/z", "rotate", "mirror", "smoothing"};

template <typename Value>
void readOptional(ParameterReader& reader, const std::string& name,
                  const std::vector<std::pair<std::string, Value>>& choices, std::optional<Value>& value)
{
  Value given{};
  reader.read(name, choices, given);
  if (reader.has(name))
  {
    value = given;
  }
}

std::vector<std::pair<std::string, double>> lengths()
{
  std::vector<std::pair<std::string, double>> choices;
  for (const core::NamedUnit& unit : core::named_lengths)
  {
    choices.emplace_back(unit.name, unit.value);
  }
  return choices;
}

/// A value of 5e-6 would be in metres: it is far below what any device measures in micrometres.
bool isSmoothing(double value)
{
  return value == 0 || (value >= 0.01 && value <= 100);
}

bool isShift(double value)
{
  return value >= -1 && value <= 1;
}
}  // namespace

void readProfileOptions(ParameterReader& reader, const std::string& prefix, core::ProfileReading& reading)
{
  using Reading = core::ProfileReading;
  readOptional(reader, prefix + "unit", lengths(), reading.unit);
  readOptional<Reading::Y>(reader, prefix + "y", {{"outward", Reading::Y::outward}, {"inward", Reading::Y::inward}},
                           reading.y);
  readOptional<Reading::Z>(reader, prefix + "z", {{"up", Reading::Z::up}, {"down", Reading::Z::down}}, reading.z);
  using Origin = Reading::Origin;
  readOptional<Origin>(reader, prefix + "origin",
                       {{"running_circle", Origin::running_circle},
                        {"flange_back", Origin::flange_back},
                        {"crown", Origin::crown},
                        {"gauge_corner", Origin::gauge_corner},
                        {"foot", Origin::foot}},
                       reading.origin);
  const NumberRule shift{"a length from -1 to 1 m", isShift};
  reader.read(prefix + "shift/y", shift, reading.shift_y);
  reader.read(prefix + "shift/z", shift, reading.shift_z);
  reader.read(prefix + "rotate", rules::finite, reading.rotate);
  reader.read(prefix + "mirror", {{"false", false}, {"true", true}}, reading.mirror);
  double smoothing = 0;
  reader.read(prefix + "smoothing", {"0, or from 0.01 to 100 [um]", isSmoothing}, smoothing);
  if (reader.has(prefix + "smoothing"))
  {
    reading.smoothing = smoothing * micrometre;
  }
}

core::ProfileReading readProfileOptions(const ParameterTree& group)
{
  ParameterReader reader(group, "");
  core::ProfileReading reading;
  readProfileOptions(reader, "", reading);
  double tape_circle = 0;
  reader.read("tape_circle", rules::positive, tape_circle);
  if (reader.has("tape_circle"))
  {
    reading.tape_circle = tape_circle;
  }
  reader.read("scale", {"above 0, at most 1", [](double value) { return value > 0 && value <= 1; }}, reading.scale);
  reader.refuseUnknown();
  return reading;
}

bool hasProfileOptions(const ParameterReader& reader, const std::string& prefix)
{
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return reader.has(prefix + name); });
}
}  // namespace wheel_rail_contact
