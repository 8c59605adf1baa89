// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "chart/method_run.h"
#include "core/balance/grid_levels.h"

namespace wheel_rail_contact::core::chart
{
/// Solvers by choice. Each is created once, because preparing a solver costs more than many solutions.
class SolverCache
{
 public:
  const GridLevels& find(const Choice& choice);

 private:
  std::map<std::tuple<NormalMethod, int, int, double>, std::unique_ptr<GridLevels>> solvers_;
};
}  // namespace wheel_rail_contact::core::chart
