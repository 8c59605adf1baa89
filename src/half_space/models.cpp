// SPDX-License-Identifier: BSD-3-Clause
#include "half_space/models.h"

#include <stdexcept>
#include <string>

#include "half_space/planar_gap.h"

namespace wheel_rail_contact::core::half_space
{
namespace
{
Eigen::Index deepestColumn(const PatchGap& patch)
{
  Eigen::Index row = 0, column = 0;
  patch.gap.minCoeff(&row, &column);
  return column;
}

void setTurn(const std::vector<SurfaceColumn>& columns, const PatchGap& patch, Eigen::ArrayXd& turn)
{
  const double reference = columns[static_cast<std::size_t>(deepestColumn(patch))].angle();
  turn.resize(patch.grid.ny);
  for (Eigen::Index j = 0; j < patch.grid.ny; ++j)
  {
    turn[j] = columns[static_cast<std::size_t>(j)].angle() - reference;
  }
}

/// Changes the problem of the package to that of a model.
void convert(const ContactModelConfig& config, const LoadedWheel& wheel, Model model, CurvedProblem& problem)
{
  const PlacedWheel placed(*config.wheel_profile.left, config.wheelset, Side::left, wheel.pose());
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    PatchGap& patch = problem.patches[k];
    const std::vector<SurfaceColumn>& columns = wheel.contact().grids().columns()[k];
    switch (model)
    {
      case Model::planar:
        patch = planarGap(placed, wheel.rail(), columns, patch.grid, deepestColumn(patch));
        break;
      case Model::curved:
        problem.normals[k].turn.resize(0);
        break;
      case Model::turned:
        setTurn(columns, patch, problem.normals[k].turn);
        break;
    }
    if (patch.gap.size() == 0)
    {
      throw std::runtime_error(std::string("model ") + toString(model) + ": wheel or rail ends inside the grid");
    }
  }
  if (model == Model::planar)
  {
    problem.normals.clear();
    problem.coupling.resize(0, 0);
  }
}
}  // namespace

const char* toString(Model model)
{
  switch (model)
  {
    case Model::planar:
      return "planar";
    case Model::curved:
      return "curved";
    default:
      return "turned";
  }
}

std::vector<ModelFigures> solveModel(const ContactModelConfig& config, const LoadedWheel& wheel, Model model)
{
  CurvedProblem problem = wheel.contact().problem();
  convert(config, wheel, model, problem);
  NormalSolution solution;
  ConjugateGradients solver(fine_solution);
  solver.solveCurved(problem, false, solution);
  if (!isUsable(solution.status))
  {
    throw std::runtime_error(std::string("model ") + toString(model) + ": " + toString(solution.status));
  }
  std::vector<ModelFigures> figures;
  for (const PatchPressure& patch : solution.patches)
  {
    figures.push_back({patch.force, patch.max_pressure, patch.area});
  }
  return figures;
}
}  // namespace wheel_rail_contact::core::half_space
