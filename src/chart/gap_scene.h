// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "chart/method_run.h"
#include "chart/solver_cache.h"

namespace wheel_rail_contact::core::chart
{
/// Gap at (x, y) [m], even in x.
using Gap = std::function<double(double, double)>;

/// Region of a patch.
struct Box
{
  double length = 0;              ///< along the track, about x = 0 [m]
  double y_begin = 0, y_end = 0;  ///< across the track [m]
};

/// One patch of a scene.
struct GapPatch
{
  Gap gap;
  Box box;                 ///< contains the overlap of the undeformed bodies; need not be tight
  double first_touch = 0;  ///< least gap [m]
  double weight = 1;       ///< as in PatchGap
};

/// A contact given by its gap: normal problem only, on a grid laid closely around the overlap of the undeformed
/// bodies, as in the balance.
class GapScene : public Scene
{
 public:
  /// @param load  [N]
  GapScene(std::string name, std::string title, std::shared_ptr<SolverCache> solver_cache,
           std::vector<GapPatch> patches, double load);

  const char* kind() const override { return "normal"; }
  int statesPerStep() const override { return 1; }
  Outcome truth(const GridSize& grid, int offset) override;
  std::unique_ptr<MethodRun> makeRun(const Choice& choice) override;

  const std::vector<GapPatch>& patches() const { return patches_; }
  /// Normal problem on a grid, with the bodies displaced by `offset` steps across the grid.
  NormalProblem problem(const GridSize& size, int offset) const;

 private:
  void tighten();

  std::shared_ptr<SolverCache> solvers_;
  std::vector<GapPatch> patches_;
  double load_;
};

/// Hertz 1:1 and 1:5, a curvature discontinuity, two patches, merged lobes, nearly conformal arcs.
std::vector<std::unique_ptr<Scene>> gapScenes();
}  // namespace wheel_rail_contact::core::chart
