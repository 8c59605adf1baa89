// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "chart/method_run.h"
#include "chart/solver_cache.h"

namespace wheel_rail_contact::core::chart
{
/// Wheelsets of one configuration by choice. Each is created once.
class WheelsetPool
{
 public:
  explicit WheelsetPool(ContactModelConfig config) : config_(std::move(config)) {}

  const ContactModelConfig& config() const { return config_; }
  WheelsetContact& find(const Choice& choice);

 private:
  ContactModelConfig config_;
  std::map<std::tuple<NormalMethod, int, int, double>, std::unique_ptr<WheelsetContact>> wheelsets_;
};

/// A wheelset at one pose under one load: whole calculation.
class WheelsetScene : public Scene
{
 public:
  WheelsetScene(std::string name, std::string title, std::shared_ptr<WheelsetPool> pool,
                std::shared_ptr<SolverCache> solver_cache, const WheelsetState& state);

  const char* kind() const override { return "wheelset"; }
  int statesPerStep() const override { return 10; }
  Outcome truth(const GridSize& grid, int offset) override;
  std::unique_ptr<MethodRun> makeRun(const Choice& choice) override;

 private:
  std::shared_ptr<WheelsetPool> pool_;
  std::shared_ptr<SolverCache> solvers_;
  WheelsetState state_;
};

/// Wheel S1002 on rail UIC60 with the track of the Manchester contact benchmark, 100 kN per wheel; the same on rail
/// 60E1, where a second contact begins at the gauge corner; and the case of the paper.
std::vector<std::unique_ptr<Scene>> wheelsetScenes();
}  // namespace wheel_rail_contact::core::chart
