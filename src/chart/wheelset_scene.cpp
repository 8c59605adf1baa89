// SPDX-License-Identifier: BSD-3-Clause
#include "chart/wheelset_scene.h"

#include <cstdio>

#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core::chart
{
namespace
{
constexpr double axle_load = 200e3;    ///< [N]
constexpr double true_balance = 1e-4;  ///< tolerance of height and roll in the reference solution [-]

WheelsetState beside(WheelsetState state, double offset)
{
  state.y += offset * step;
  return state;
}

class WheelsetRun : public MethodRun
{
 public:
  WheelsetRun(WheelsetContact& wheelset, const WheelsetState& state) : wheelset_(wheelset), state_(state)
  {
    wheelset_.reset();
  }

  void solve(double offset) override { result_ = &wheelset_.evaluate(beside(state_, offset)); }
  void reset() override { wheelset_.reset(); }
  Outcome outcome() const override { return outcomeOf(*result_); }

 private:
  WheelsetContact& wheelset_;
  WheelsetState state_;
  const WheelsetResult* result_ = nullptr;
};

/// Shackleton and Iwnicki 2008 (Vehicle System Dynamics 46): S1002 on UIC60, rail inclination 1:40, gauge 1435 mm,
/// back-to-back distance 1360 mm, rolling radius 460 mm.
ContactModelConfig manchester()
{
  ContactModelConfig config;
  config.wheel_profile = std::make_shared<Profile>(s1002Wheel());
  config.rail_profile = std::make_shared<Profile>(railUic60Manchester());
  return config;
}

/// The default rail.
ContactModelConfig on60E1()
{
  ContactModelConfig config = manchester();
  config.rail_profile = std::make_shared<Profile>(rail60E1());
  return config;
}

/// The Manchester wheelset with both rails displaced outward as in Golubenko et al. 2011 (TEKA XI, 78–84).
ContactModelConfig paper()
{
  ContactModelConfig config = manchester();
  config.rail_bending.model = RailBendingConfig::Model::prescribed;
  config.rail_bending.prescribed.lateral = 0.2435e-3;
  return config;
}

/// State under the axle load, with the axle centre at y, to the left positive [m].
WheelsetState loadedAt(double y)
{
  WheelsetState state;
  state.y = y;
  state.force_z = -axle_load;
  return state;
}
}  // namespace

WheelsetContact& WheelsetPool::find(const Choice& choice)
{
  std::unique_ptr<WheelsetContact>& wheelset =
      wheelsets_[{choice.method, choice.grid.along, choice.grid.across, choice.tolerance}];
  if (!wheelset)
  {
    ContactModelConfig config = config_;
    config.contact = contactConfig(choice);
    wheelset = std::make_unique<WheelsetContact>(config);
  }
  return *wheelset;
}

WheelsetScene::WheelsetScene(std::string name, std::string title, std::shared_ptr<WheelsetPool> pool,
                             std::shared_ptr<SolverCache> solver_cache, const WheelsetState& state)
    : Scene(std::move(name), std::move(title)), pool_(std::move(pool)), solvers_(std::move(solver_cache)), state_(state)
{
}

Outcome WheelsetScene::truth(const GridSize& grid, int offset)
{
  ContactModelConfig config = pool_->config();
  config.contact.tolerance = true_balance;
  WheelsetBalance balance(config, solvers_->find({NormalMethod::conjugate_gradient, grid, true_balance}));
  return outcomeOf(balance, balance.solve(beside(state_, offset)));
}

std::unique_ptr<MethodRun> WheelsetScene::makeRun(const Choice& choice)
{
  return std::make_unique<WheelsetRun>(pool_->find(choice), state_);
}

std::vector<std::unique_ptr<Scene>> wheelsetScenes()
{
  const auto solver_cache = std::make_shared<SolverCache>();
  const auto unbent = std::make_shared<WheelsetPool>(manchester());
  std::vector<std::unique_ptr<Scene>> scenes;
  for (const double y : {0.0, 0.5, 3.0, 5.0, 6.5})
  {
    char name[32], title[64];
    std::snprintf(name, sizeof name, "manchester_%g", y);
    std::snprintf(title, sizeof title, "Manchester, y = %g mm", y);
    scenes.push_back(std::make_unique<WheelsetScene>(name, title, unbent, solver_cache, loadedAt(1e-3 * y)));
  }
  scenes.push_back(std::make_unique<WheelsetScene>("onset_4.38", "60E1, onset at y = 4.38 mm",
                                                   std::make_shared<WheelsetPool>(on60E1()), solver_cache,
                                                   loadedAt(4.38e-3)));
  scenes.push_back(std::make_unique<WheelsetScene>(
      "paper", "Paper's case, rails bent", std::make_shared<WheelsetPool>(paper()), solver_cache, loadedAt(0.572e-3)));
  return scenes;
}
}  // namespace wheel_rail_contact::core::chart
