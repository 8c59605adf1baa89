// SPDX-License-Identifier: BSD-3-Clause
#include "half_space/tables.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/balance/patch_result.h"
#include "half_space/models.h"
#include "half_space/planar_gap.h"
#include "tables/csv.h"

namespace wheel_rail_contact::core::half_space
{
namespace
{
constexpr double outline_step = 0.25e-3;  ///< distance of the points of an outline along its parameter [m]

/// The tables of a place; each function adds the rows of one load.
class Tables
{
 public:
  Tables(const ContactModelConfig& config, const std::filesystem::path& folder)
      : config_(config),
        folder_(folder),
        models_(folder / "models.csv"),
        contacts_(folder / "contacts.csv"),
        gaps_(folder / "gaps.csv"),
        openings_(folder / "openings.csv")
  {
    models_.line("load,model,grid,force,max_pressure,area");
    contacts_.line("load,grid,half_space_ratio,turned,model_error");
    gaps_.line("load,grid,row,column,gap,planar_gap");
    openings_.line("load,grid,column,per_up,per_outward,planar_per_up");
  }

  void addModels(const LoadedWheel& wheel, double load)
  {
    for (const Model model : all_models)
    {
      const std::vector<ModelFigures> figures = solveModel(config_, wheel, model);
      for (std::size_t k = 0; k < figures.size(); ++k)
      {
        models_.row(load, toString(model), k, figures[k].force, figures[k].max_pressure, figures[k].area);
      }
    }
  }

  void addGaps(const LoadedWheel& wheel, const std::vector<CellGrid>& grids, double load)
  {
    const PlacedWheel placed(*config_.wheel_profile.left, config_.wheelset, Side::left, wheel.pose());
    for (std::size_t k = 0; k < grids.size(); ++k)
    {
      Eigen::ArrayXXd gap;
      std::vector<SurfaceColumn> columns(static_cast<std::size_t>(grids[k].grid.ny));
      buildSurfaceGap(placed, wheel.rail(), grids[k].origin, grids[k].grid, gap, columns);
      Eigen::Index row = 0, touch = 0;
      gap.minCoeff(&row, &touch);
      const PatchGap planar = planarGap(placed, wheel.rail(), columns, grids[k].grid, touch);
      addContact(wheel, grids[k], load, k);
      addColumns(gap, columns, planar, load, k);
    }
  }

  /// Writes what is the same for all loads: it is taken at the present load.
  void writePlace(const LoadedWheel& wheel, const std::vector<CellGrid>& grids)
  {
    const PlacedWheel placed(*config_.wheel_profile.left, config_.wheelset, Side::left, wheel.pose());
    Csv values(folder_ / "values.csv");
    values.line("modulus,young,poisson,axle_z");
    values.row(wheel.contact().problem().modulus, config_.rail_material.left.young, config_.rail_material.left.poisson,
               wheel.pose().z);
    writeOutlines(placed, wheel.rail());
    writeCells(placed, wheel.rail(), grids);
  }

 private:
  void addContact(const LoadedWheel& wheel, const CellGrid& laid, double load, std::size_t k)
  {
    double ratio = 0;
    bool is_turned = false;
    const Profile& profile = wheel.rail().profile();
    for (const PressedPart& part : wheel.parts())
    {
      const double place = arcLength(profile, laid.origin.rail_u, part.u_first);
      if (place > laid.grid.y(0) && place < laid.grid.y(laid.grid.ny - 1))
      {
        ratio = std::max(ratio, part.half_space_ratio);
        is_turned = is_turned || part.is_turned;
      }
    }
    contacts_.row(load, k, ratio, is_turned ? 1 : 0, modelError(ratio, is_turned));
  }

  void addColumns(const Eigen::ArrayXXd& gap, const std::vector<SurfaceColumn>& columns, const PatchGap& planar,
                  double load, std::size_t grid)
  {
    for (Eigen::Index j = 0; j < gap.cols(); ++j)
    {
      const SurfaceColumn& column = columns[static_cast<std::size_t>(j)];
      openings_.row(load, grid, j, column.perUp(), column.perOutward(), planar.weight);
      for (Eigen::Index i = 0; i < gap.rows(); ++i)
      {
        gaps_.row(load, grid, i, j, gap(i, j), planar.gap.size() > 0 ? planar.gap(i, j) : no_body_gap);
      }
    }
  }

  void writeOutlines(const PlacedWheel& wheel, const PlacedRail& rail)
  {
    Csv csv(folder_ / "outlines.csv");
    csv.line("body,u,y,z");
    const double rail_end = rail.profile().length(), wheel_end = wheel.profile().length();
    for (double u = 0; u < rail_end; u += outline_step)
    {
      const PlanePoint point = rail.at(u);
      csv.row("rail", u, point.y, point.z);
    }
    for (double u = 0; u < wheel_end; u += outline_step)
    {
      PlanePoint point{};
      wheel.section(wheel.profile().at(u), 0, point);
      csv.row("wheel", u, point.y, point.z);
    }
  }

  void writeCells(const PlacedWheel& wheel, const PlacedRail& rail, const std::vector<CellGrid>& grids)
  {
    Csv cells(folder_ / "cells.csv"), column_table(folder_ / "columns.csv");
    cells.line("grid,rows,columns,dx,dy");
    column_table.line("grid,column,rail_u,wheel_u,y,z,angle,wheel_y,wheel_z");
    for (std::size_t k = 0; k < grids.size(); ++k)
    {
      const Grid& grid = grids[k].grid;
      cells.row(k, grid.rows(), grid.ny, grid.dx, grid.dy);
      Eigen::ArrayXXd gap;
      std::vector<SurfaceColumn> columns(static_cast<std::size_t>(grid.ny));
      buildSurfaceGap(wheel, rail, grids[k].origin, grid, gap, columns);
      for (std::size_t j = 0; j < columns.size(); ++j)
      {
        const SurfaceColumn& column = columns[j];
        if (!column.has_bodies)
        {
          throw std::runtime_error("a profile ends inside the cells");
        }
        PlanePoint opposite{};
        wheel.section(wheel.profile().at(column.wheel_u), 0, opposite);
        column_table.row(k, j, column.rail_u, column.wheel_u, column.y, column.z, column.angle(), opposite.y,
                         opposite.z);
      }
    }
  }

  const ContactModelConfig& config_;
  std::filesystem::path folder_;
  Csv models_, contacts_, gaps_, openings_;
};
}  // namespace

void writeTables(const ContactModelConfig& config, double y, const std::vector<double>& loads, const CellCount& count,
                 const std::filesystem::path& folder)
{
  LoadedWheel wheel(config);
  Tables tables(config, folder);
  std::vector<std::vector<PressedPart>> parts;
  for (const double load : loads)
  {
    wheel.solve(y, load);
    parts.push_back(wheel.parts());
    tables.addModels(wheel, load);
  }
  const std::vector<CellGrid> grids = cellGrids(wheel.rail(), parts, count);
  for (const double load : loads)
  {
    wheel.solve(y, load);
    tables.addGaps(wheel, grids, load);
  }
  tables.writePlace(wheel, grids);
}
}  // namespace wheel_rail_contact::core::half_space
