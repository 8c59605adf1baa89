// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "core/profile/files/steps.h"
#include "core/text/table_title.h"
#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
using Y = ProfileReading::Y;
using Z = ProfileReading::Z;

/// Unit and directions as far as they are known.
struct KnownAxes
{
  std::optional<double> unit;  ///< [m]
  std::optional<Y> y;
  std::optional<Z> z;
};

/// What `reading`, the file or its format states.
/// @throw FileError if `reading` contradicts the unit in the file.
KnownAxes statedAxes(const TextFile& file, const FileProfile& content, const ProfileReading& reading)
{
  if (reading.unit && content.unit && content.unit_in_file && std::abs(*reading.unit / *content.unit - 1) > 1e-9)
  {
    file.refuse(0,
                "unit " + nameOfLength(*reading.unit) + " contradicts " + nameOfLength(*content.unit) + " in the file");
  }
  return {reading.unit ? reading.unit : content.unit, reading.y ? reading.y : content.y,
          reading.z ? reading.z : content.z};
}

bool isProfile(const TextFile& file, const FileProfile& content, ProfileKind kind, const FileAxes& axes,
               const ProfileReading& reading)
{
  try
  {
    orderedPoints(file, placedPoints(file, content, kind, axes, reading).points, kind);
    return true;
  }
  catch (const FileError&)
  {
    return false;
  }
}

/// Values of the options by which the points are a profile.
struct Fitting
{
  std::set<std::string> units, y, z;
  bool from_flange_back = false;  ///< only with origin: flange_back
};

/// Tries all values of what is not known.
Fitting fittingWith(const TextFile& file, const FileProfile& content, ProfileKind kind, const KnownAxes& known,
                    const ProfileReading& reading)
{
  Fitting fitting;
  for (const NamedUnit& named : named_lengths)
  {
    for (const Y y : {Y::outward, Y::inward})
    {
      for (const Z z : {Z::up, Z::down})
      {
        const bool is_free = known.y.value_or(y) == y && known.z.value_or(z) == z;
        if (is_free && isProfile(file, content, kind, {known.unit.value_or(named.value), y, z}, reading))
        {
          fitting.units.insert(named.name);
          fitting.y.insert(y == Y::outward ? "outward" : "inward");
          fitting.z.insert(z == Z::up ? "up" : "down");
        }
      }
    }
  }
  return fitting;
}

/// The same, and if nothing fits a wheel, with its origin at the flange back.
Fitting fittingAxes(const TextFile& file, const FileProfile& content, ProfileKind kind, const KnownAxes& known,
                    ProfileReading reading)
{
  Fitting fitting = fittingWith(file, content, kind, known, reading);
  if (fitting.y.empty() && kind == ProfileKind::wheel && !reading.origin)
  {
    reading.origin = ProfileReading::Origin::flange_back;
    fitting = fittingWith(file, content, kind, known, reading);
    fitting.from_flange_back = !fitting.y.empty();
  }
  return fitting;
}

/// Refuses a file whose axes are not known. Names what is not known, and the values by which the points are a profile.
[[noreturn]] void refuseUnknown(const TextFile& file, const FileProfile& content, ProfileKind kind,
                                const KnownAxes& known, const ProfileReading& reading)
{
  const Fitting fitting = fittingAxes(file, content, kind, known, reading);
  std::string missing, values;
  const auto require = [&](const char* name, bool is_known, const std::set<std::string>& fits)
  {
    if (!is_known)
    {
      missing += (missing.empty() ? "" : ", ") + std::string(name);
      values += (values.empty() ? "" : ", ") + std::string(name) + ": " + joined(fits, " or ");
    }
  };
  require("unit", known.unit.has_value(), fitting.units);
  require("y", known.y.has_value(), fitting.y);
  require("z", known.z.has_value(), fitting.z);
  file.refuse(0, "the file does not state its " + missing + ", and no option does. " +
                     (fitting.y.empty() ? "The points are no profile by any values of them"
                                        : "The points are a profile by " + values +
                                              (fitting.from_flange_back ? ", origin: flange_back" : "")));
}

/// Names the values by which points that were refused are a profile; empty if there are none.
std::string hintFor(const TextFile& file, const FileProfile& content, ProfileKind kind, double unit,
                    const ProfileReading& reading)
{
  ProfileReading any = reading;
  any.origin.reset();
  Fitting fitting = fittingAxes(file, content, kind, {unit, {}, {}}, any);
  std::string other_unit;
  if (fitting.y.empty())
  {
    fitting = fittingAxes(file, content, kind, {}, any);
    other_unit = "unit: " + joined(fitting.units, " or ") +
                 (content.unit_in_file ? " (the file states another one: correct it), " : ", ");
  }
  return fitting.y.empty()
             ? ""
             : "the points are a profile by " + other_unit + "y: " + joined(fitting.y, " or ") +
                   ", z: " + joined(fitting.z, " or ") + (fitting.from_flange_back ? ", origin: flange_back" : "") +
                   (reading.origin && !fitting.from_flange_back ? ", without origin" : "");
}
}  // namespace

FramedPoints framedPoints(const TextFile& file, const FileProfile& content, ProfileKind kind,
                          const ProfileReading& reading)
{
  const KnownAxes known = statedAxes(file, content, reading);
  if (!known.unit || !known.y || !known.z)
  {
    refuseUnknown(file, content, kind, known, reading);
  }
  FramedPoints framed{{*known.unit, *known.y, *known.z}, {}};
  framed.placed = placedPoints(file, content, kind, framed.axes, reading);
  try
  {
    framed.placed.points = orderedPoints(file, framed.placed.points, kind);
  }
  catch (const FileError& error)
  {
    const std::string hint = hintFor(file, content, kind, framed.axes.unit, reading);
    file.refuse(error.line(), error.reason() + (hint.empty() ? "" : "; " + hint));
  }
  return framed;
}
}  // namespace wheel_rail_contact::core
