// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/file_axes.h"

#include <algorithm>
#include <set>
#include <string>

#include "core/profile/profile_order.h"
#include "core/text/table_title.h"

namespace wheel_rail_contact::core
{
namespace
{
using Y = ProfileReading::Y;
using Z = ProfileReading::Z;

bool isProfile(const TextFile& file, const FileProfile& content, ProfileKind kind, const FileAxes& axes,
               const ProfileReading& reading)
{
  try
  {
    orderedPoints(file, placedPoints(file, content, kind, axes, reading).points, kind);
    return true;
  }
  catch (const TextError&)
  {
    return false;
  }
}

const char* nameOf(Y y)
{
  return y == Y::outward ? "outward" : "inward";
}

const char* nameOf(Z z)
{
  return z == Z::up ? "up" : "down";
}

std::string joined(const std::set<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : " or ") + word;
  }
  return text;
}

/// Values of the options by which the points are a profile.
struct Fitting
{
  std::set<std::string> units, y, z;
  bool from_flange_back = false;  ///< only with origin: flange_back
};

/// Tries all values of what is not known.
Fitting fittingWith(const TextFile& file, const FileProfile& content, ProfileKind kind, const ProfileReading& reading)
{
  const std::optional<double> unit = reading.unit ? reading.unit : content.unit;
  const auto y = reading.y ? reading.y : content.y;
  const auto z = reading.z ? reading.z : content.z;
  Fitting fitting;
  for (const NamedUnit& named : named_lengths)
  {
    for (const Y y_axis : {Y::outward, Y::inward})
    {
      for (const Z z_axis : {Z::up, Z::down})
      {
        const bool is_free = (!y || *y == y_axis) && (!z || *z == z_axis);
        if (is_free && isProfile(file, content, kind, {unit.value_or(named.value), y_axis, z_axis}, reading))
        {
          fitting.units.insert(named.name);
          fitting.y.insert(nameOf(y_axis));
          fitting.z.insert(nameOf(z_axis));
        }
      }
    }
  }
  return fitting;
}

/// The same, and if nothing fits a wheel, with its origin at the flange back.
Fitting fittingAxes(const TextFile& file, const FileProfile& content, ProfileKind kind, const ProfileReading& reading)
{
  Fitting fitting = fittingWith(file, content, kind, reading);
  if (fitting.y.empty() && kind == ProfileKind::wheel && !reading.origin)
  {
    ProfileReading from_back = reading;
    from_back.origin = ProfileReading::Origin::flange_back;
    fitting = fittingWith(file, content, kind, from_back);
    fitting.from_flange_back = !fitting.y.empty();
  }
  return fitting;
}
}  // namespace

FileAxes requiredAxes(const TextFile& file, const FileProfile& content, ProfileKind kind, const ProfileReading& reading)
{
  if (const std::optional<FileAxes> axes = knownAxes(file, content, reading))
  {
    return *axes;
  }
  const Fitting fitting = fittingAxes(file, content, kind, reading);
  std::string missing, values;
  const auto require = [&](const char* name, bool known, const std::set<std::string>& fits)
  {
    if (!known)
    {
      missing += (missing.empty() ? "" : ", ") + std::string(name);
      values += (values.empty() ? "" : ", ") + std::string(name) + ": " + joined(fits);
    }
  };
  require("unit", reading.unit || content.unit, fitting.units);
  require("y", reading.y || content.y, fitting.y);
  require("z", reading.z || content.z, fitting.z);
  file.refuse(0, "the file does not state its " + missing + ", and no option does. " +
                     (fitting.y.empty() ? "The points are no profile by any values of them"
                                        : "The points are a profile by " + values +
                                              (fitting.from_flange_back ? ", origin: flange_back" : "")));
}

std::string hintFor(const TextFile& file, const FileProfile& content, ProfileKind kind, const FileAxes& axes,
                    const ProfileReading& reading)
{
  FileProfile open = content;
  open.y.reset();
  open.z.reset();
  ProfileReading any = reading;
  any.unit.reset();
  any.y.reset();
  any.z.reset();
  any.origin.reset();
  open.unit = axes.unit;
  Fitting fitting = fittingAxes(file, open, kind, any);
  std::string unit;
  if (fitting.y.empty())
  {
    open.unit.reset();
    fitting = fittingAxes(file, open, kind, any);
    unit = "unit: " + joined(fitting.units) +
           (content.unit_in_file ? " (the file states another one: correct it), " : ", ");
  }
  return fitting.y.empty()
             ? ""
             : "the points are a profile by " + unit + "y: " + joined(fitting.y) + ", z: " + joined(fitting.z) +
                   (fitting.from_flange_back ? ", origin: flange_back" : "") +
                   (reading.origin && !fitting.from_flange_back ? ", without origin" : "");
}
}  // namespace wheel_rail_contact::core
