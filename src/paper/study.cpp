// SPDX-License-Identifier: BSD-3-Clause
#include "paper/study.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/normal/solvers/conjugate_gradients.h"
#include "paper/methods.h"
#include "paper/placement.h"
#include "paper/scan.h"
#include "paper/stress_rows.h"
#include "tables/csv.h"

namespace wheel_rail_contact::core::paper
{
namespace
{
constexpr int digits = 8;                    ///< significant ones of each number
constexpr double near_start = 0.03;          ///< largest deviation from the results without bending of a start [-]
constexpr Range chart_forces{0, 80e3, 20};   ///< [N]
constexpr Range search_forces{0, 60e3, 12};  ///< [N]
constexpr Range search_positions{2e-3, 8e-3, 24};     ///< [m]
constexpr const char* divided_table = "pads_40_100";  ///< table for the parts of the deflection, see DeflectionShare

constexpr std::array<const char*, 3> stress_tables{"paper", "pads_40_100", "pads_10_25"};
constexpr Range stress_forces{0, 60e3, 2};  ///< [N]

/// A table with these titles.
Csv tableAt(const std::filesystem::path& file, const std::string& titles)
{
  Csv csv(file, digits);
  csv.line(titles);
  return csv;
}

/// @param level  results of each placement at roll 0
void writeFigures(const std::vector<Placement>& placements, const std::vector<Figures>& level,
                  const std::filesystem::path& folder)
{
  Csv csv = tableAt(folder / "figures.csv",
                    "case,max_pressure,area,level_max_pressure,level_area,reference_max_pressure,reference_area,"
                    "printed_max_pressure,printed_area,deviation,wheelset_roll,rail_lateral,rail_vertical,rail_roll");
  for (std::size_t i = 0; i < placements.size(); ++i)
  {
    const Placement& at = placements[i];
    const Figures reference = at.of.reference.value_or(Figures{0, 0});
    csv.row(at.of.name, at.balanced.max_pressure, at.balanced.area, level[i].max_pressure, level[i].area,
            reference.max_pressure, reference.area, at.of.printed.max_pressure, at.of.printed.area,
            deviation(at.balanced, at.of.printed), at.roll, at.deflection.lateral, at.deflection.vertical,
            at.deflection.roll);
  }
}

void writeOutlines(const std::vector<Placement>& placements, const std::filesystem::path& folder)
{
  Csv profiles = tableAt(folder / "profiles.csv", "case,body,y,z");
  Csv contacts = tableAt(folder / "contacts.csv", "case,y,z");
  for (const Placement& at : placements)
  {
    contacts.row(at.of.name, at.initial_contact.y, at.initial_contact.z);
    for (const auto& [body, outline] : {std::pair{"rail", &at.rail}, std::pair{"wheel", &at.wheel}})
    {
      for (const PlanePoint& point : *outline)
      {
        profiles.row(at.of.name, body, point.y, point.z);
      }
    }
  }
}

/// Adds one row for each cell of a patch, which begins with `keys`.
template <typename... Keys>
void writeCells(Csv& csv, const PatchResult& patch, const Keys&... keys)
{
  for (int column = 0; column < patch.grid.ny; ++column)
  {
    for (int row = 0; row < patch.grid.nx; ++row)
    {
      csv.row(keys..., patch.grid.x(row), patch.grid.y(column), patch.pressure(row, column));
    }
  }
}

void writePatches(const std::vector<Placement>& placements, const std::filesystem::path& folder)
{
  Csv csv = tableAt(folder / "patches.csv", "case,patch,x,y,pressure");
  for (const Placement& at : placements)
  {
    for (std::size_t k = 0; k < at.patches.size(); ++k)
    {
      writeCells(csv, at.patches[k], at.of.name, k);
    }
  }
}

void writeStressRows(const std::vector<StressRow>& rows, double poisson, Csv& csv, Csv& cells)
{
  for (const StressRow& row : rows)
  {
    const StressMaxima& highest = row.highest;
    csv.row(row.rail, row.lateral_force, row.in_range ? 1 : 0, row.patch.max_pressure, row.patch.area,
            row.patch.semi_axis_along, row.patch.semi_axis_across, highest.von_mises.value, highest.von_mises.x,
            highest.von_mises.y, highest.von_mises.depth, highest.shear.value, highest.shear.depth, highest.alternating,
            highest.yield_depth, highest.principal[0], highest.principal[1], highest.principal[2], row.strain[0],
            row.strain[1], row.strain[2], row.load_factor, row.shakedown_limit, poisson);
    writeCells(cells, row.patch, row.rail, row.lateral_force);
  }
}

void writeForceRows(Csv& csv, const std::vector<ForceRow>& rows)
{
  for (const ForceRow& row : rows)
  {
    csv.row(row.table, toString(row.share), row.y, row.lateral_force, row.in_range ? 1 : 0, row.deflection.lateral,
            row.deflection.vertical, row.deflection.roll, row.figures.max_pressure, row.figures.area,
            deviation(row.figures, printed_with_bending));
  }
}

constexpr const char* force_columns =
    "table,share,y,lateral_force,in_range,rail_lateral,rail_vertical,rail_roll,max_pressure,area,deviation_with";

void writeScanRows(Csv& csv, const std::vector<ScanRow>& rows)
{
  for (const ScanRow& row : rows)
  {
    csv.row(row.part, row.rail, row.inclination, row.load, row.y, row.roll, row.crown.lateral, row.crown.vertical,
            row.crown.roll, row.other_crown.lateral, row.other_crown.vertical, row.without.max_pressure,
            row.without.area, row.figures.max_pressure, row.figures.area,
            deviation(row.figures, printed_without_bending), deviation(row.figures, printed_with_bending),
            row.pairDeviation());
  }
}
}  // namespace

void writeCases(const ContactModelConfig& config, const std::filesystem::path& folder, const Progress& progress)
{
  std::vector<Placement> placements;
  std::vector<Figures> level;
  Csv methods = tableAt(folder / "methods.csv",
                        "case,method,cells_along,cells_across,cell_along,cell_across,stop,iterations,max_pressure,area,"
                        "counted_area");
  for (const Case& of : paperCases())
  {
    progress("case " + of.name);
    placements.push_back(solveCase(config, of));
    const std::vector<MethodRow> rows = compareMethods(config, placements.back().deflection);
    level.push_back(rows.front().figures);
    for (const MethodRow& row : rows)
    {
      methods.row(of.name, row.method, row.size.along, row.size.across, row.cell_along, row.cell_across, row.stop,
                  row.iterations, row.figures.max_pressure, row.figures.area, row.counted_area);
    }
  }
  writeFigures(placements, level, folder);
  writeOutlines(placements, folder);
  writePatches(placements, folder);
}

void writeForces(const ContactModelConfig& config, const std::vector<NamedTable>& tables,
                 const std::filesystem::path& folder, const Progress& progress)
{
  Csv csv = tableAt(folder / "forces.csv", force_columns);
  for (const NamedTable& table : tables)
  {
    progress("lateral forces on " + table.name);
    writeForceRows(csv, underForces(config, table, DeflectionShare::whole, {case_position}, chart_forces.values()));
    for (const DeflectionShare share : {DeflectionShare::without_moment, DeflectionShare::shift_only})
    {
      if (table.name == divided_table)
      {
        writeForceRows(csv, underForces(config, table, share, {case_position}, chart_forces.values()));
      }
    }
  }
}

void writeStress(const ContactModelConfig& config, const std::vector<NamedTable>& tables,
                 const std::filesystem::path& folder, const Progress& progress)
{
  progress("stress");
  Csv csv = tableAt(folder / "stress.csv",
                    "rail,lateral_force,in_range,max_pressure,area,semi_axis_along,semi_axis_across,von_mises,"
                    "von_mises_x,von_mises_y,von_mises_depth,shear,shear_depth,alternating,yield_depth,"
                    "stress_1,stress_2,stress_3,strain_1,strain_2,strain_3,load_factor,shakedown_limit,poisson");
  Csv cells = tableAt(folder / "stress_patches.csv", "rail,lateral_force,x,y,pressure");
  const double poisson = config.rail_material.left.poisson;
  writeStressRows(stressOfCases(config), poisson, csv, cells);
  for (const NamedTable& table : tables)
  {
    if (std::find(stress_tables.begin(), stress_tables.end(), table.name) != stress_tables.end())
    {
      writeStressRows(stressUnderForces(config, table, stress_forces.values()), poisson, csv, cells);
    }
  }
}

void writeScan(const ContactModelConfig& config, const std::vector<NamedTable>& tables,
               const std::filesystem::path& folder, const Progress& progress)
{
  ConjugateGradients solver;
  const Scan scan(config, solver, {});
  Csv csv = tableAt(
      folder / "scan.csv",
      "part,rail,inclination,load,y,wheelset_roll,crown_lateral,crown_vertical,rail_turn,other_crown_lateral,"
      "other_crown_vertical,without_max_pressure,without_area,max_pressure,area,deviation_without,deviation_with,"
      "deviation_pair");
  progress("scan: settings for the results without bending");
  const std::vector<ScanRow> starts = scan.start();
  writeScanRows(csv, starts);
  for (const ScanRow& start : scan.nearestStarts(starts, near_start))
  {
    progress("scan: pairs for " + start.rail);
    writeScanRows(csv, {start});
    writeScanRows(csv, scan.shift(start));
    writeScanRows(csv, scan.pair(start));
    writeScanRows(csv, scan.roll(start));
    writeScanRows(csv, scan.rails(start));
  }
  for (const std::string& rail : studied_rails)
  {
    progress("scan: other inclinations of " + rail);
    writeScanRows(csv, scan.alone(rail));
    writeScanRows(csv, scan.inclination(rail));
  }
  Csv search = tableAt(folder / "search.csv", force_columns);
  for (const NamedTable& table : tables)
  {
    progress("scan: positions and lateral forces on " + table.name);
    writeForceRows(
        search, underForces(config, table, DeflectionShare::whole, search_positions.values(), search_forces.values()));
  }
}
}  // namespace wheel_rail_contact::core::paper
