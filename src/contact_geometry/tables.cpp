// SPDX-License-Identifier: BSD-3-Clause
#include "contact_geometry/tables.h"

#include <string>

#include "tables/csv.h"

namespace wheel_rail_contact::core::contact_geometry
{
namespace
{
constexpr int digits = 9;                ///< significant ones of each number: finer than any tolerance
constexpr double step_round_off = 1e-6;  ///< in the number of steps

constexpr int point_cells = 15;    ///< between y and the reason
constexpr int conicity_cells = 3;  ///< between the amplitude and the reason

std::string pointHeader()
{
  std::string header = "y [m],z [m],roll [rad],rolling_radius_difference [m]";
  for (const Side side : sides)
  {
    const std::string name = nameOf(side);
    for (const char* column :
         {"_y [m]", "_z [m]", "_wheel_y [m]", "_rail_y [m]", "_contact_angle [rad]", "_rolling_radius [m]"})
    {
      header += ',' + name + column;
    }
  }
  return header + ",reason";
}
}  // namespace

void writePoints(const ContactGeometry& geometry, const std::filesystem::path& file)
{
  Csv table(file, digits);
  table.line(pointHeader());
  for (const GeometryPoint& point : geometry.points)
  {
    table.add(point.y);
    if (point.status == GeometryStatus::ok)
    {
      table.add(point.z, point.roll, point.radiusDifference());
      for (const Side side : sides)
      {
        const TouchPoint& touch = point.touch[side];
        table.add(touch.y, touch.z, touch.wheel_y, touch.rail_y, touch.angle, touch.radius);
      }
      table.add("");
    }
    else
    {
      table.addEmpty(point_cells);
      table.add(toString(point.status));
    }
    table.endRow();
  }
}

void writeConicity(const ContactGeometry& geometry, const WheelsetConfig& wheelset, const Amplitudes& amplitudes,
                   const std::filesystem::path& file)
{
  Csv table(file, digits);
  table.line("amplitude [m],equivalent_conicity [-],wavelength [m],centre [m],reason");
  const auto steps = static_cast<long>((amplitudes.last - amplitudes.first) / amplitudes.step + step_round_off);
  for (long i = 0; i <= steps; ++i)
  {
    const double amplitude = amplitudes.first + static_cast<double>(i) * amplitudes.step;
    const EquivalentConicity conicity = equivalentConicity(geometry.curve, amplitude);
    table.add(amplitude);
    if (conicity.status == ConicityStatus::ok)
    {
      const double base = 2 * wheelset.halfBase();
      table.add(conicity.value, kinematicWavelength(conicity.value, base, wheelset.meanRadius()), conicity.centre, "");
    }
    else
    {
      table.addEmpty(conicity_cells);
      table.add(toString(conicity.status));
    }
    table.endRow();
  }
}
}  // namespace wheel_rail_contact::core::contact_geometry
