// SPDX-License-Identifier: BSD-3-Clause
#include "random_scene.h"

#include "../core/normal/gap_scenes.h"
#include "config/compliance_table_file.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
using scenes::oneIn;
using scenes::Random;
using scenes::spread;
using scenes::uniform;

void drawTrack(TrackConfig& track, Random& random)
{
  constexpr std::array<double, 3> inclinations{0, 0.025, 0.05};
  track.rail_inclination =
      oneIn(random, 4) ? uniform(random, -0.02, 0.08) : inclinations[random() % inclinations.size()];
  track.gauge = oneIn(random, 2) ? 1.435 : uniform(random, 1.42, 1.47);
}

/// Frequency and limits of a method in random scenes.
struct MethodLimits
{
  std::size_t weight;  ///< relative frequency
  double smallest_tolerance;
  int most_cells;  ///< each way, where the grid is given
};

/// The time of the Seidel iteration grows with the square of the number of cells.
MethodLimits limitsOf(NormalMethod method)
{
  switch (method)
  {
    case NormalMethod::automatic:
      return {0, 2e-3, 64};
    case NormalMethod::conjugate_gradient:
      return {3, 2e-3, 64};
    case NormalMethod::seidel:
      return {1, 2e-2, 16};
    case NormalMethod::seidel_printed:
      return {1, 3e-2, 12};
    default:
      return {2, 5e-3, 32};
  }
}

/// All methods except `auto`, each as often as its weight.
std::vector<NormalMethod> weightedMethods()
{
  std::vector<NormalMethod> methods;
  for (const NormalMethod method : all_normal_methods)
  {
    methods.insert(methods.end(), limitsOf(method).weight, method);
  }
  std::stable_sort(methods.begin(), methods.end(),
                   [](NormalMethod a, NormalMethod b) { return limitsOf(a).weight > limitsOf(b).weight; });
  return methods;
}

void drawMethod(ContactConfig& contact, Random& random)
{
  static const std::vector<NormalMethod> methods = weightedMethods();
  contact.method = oneIn(random, 3) ? methods[random() % methods.size()] : NormalMethod::automatic;
  const MethodLimits limits = limitsOf(contact.method);
  contact.tolerance = spread(random, limits.smallest_tolerance, 0.1);
  if (contact.method != NormalMethod::automatic && oneIn(random, 4))
  {
    const auto even = [&]() { return 4 + 2 * static_cast<int>(uniform(random, 0, 0.5 * limits.most_cells - 2)); };
    contact.cells_along = even();
    contact.cells_across = even();
  }
}

void drawRail(const std::vector<NamedTable>& tables, Scene& scene, Random& random)
{
  using Model = RailBendingConfig::Model;
  using LateralForce = RailBendingConfig::LateralForce;
  RailBendingConfig& bending = scene.config.rail_bending;
  if (oneIn(random, 3))
  {
    return;
  }
  if (oneIn(random, 8))
  {
    bending.model = Model::prescribed;
    bending.prescribed = {uniform(random, -3e-3, 6e-3), uniform(random, -3e-3, 1e-3), uniform(random, -0.02, 0.03)};
    return;
  }
  const NamedTable& table = tables[random() % tables.size()];
  bending.model = Model::compliance;
  bending.table = table.table;
  scene.table_name = table.name;
  if (oneIn(random, 6))
  {
    bending.lateral_force = LateralForce::constant;
    bending.lateral_force_value = uniform(random, -2e4, 6e4);
  }
  else if (oneIn(random, 6))
  {
    bending.lateral_force = LateralForce::topic;
  }
}

/// Generates the states of a scene one after the other.
class Walk
{
 public:
  Walk(const WheelsetConfig& wheelset, Random& random) : wheelset_(wheelset), random_(random) { jump(); }

  const WheelsetState& next();

 private:
  void jump();
  void step();
  void drawLoad();

  const WheelsetConfig& wheelset_;
  Random& random_;
  WheelsetState state_;
  bool first_ = true;
  bool small_ = false;  ///< the last step was a small one
};

void Walk::drawLoad()
{
  const double wheel = oneIn(random_, 3) ? spread(random_, 1, 1e6) : spread(random_, 2e4, 1.5e5);
  const double transfer = oneIn(random_, 10) ? uniform(random_, -1.5, 1.5) : uniform(random_, -0.5, 0.5);
  state_.force_z = -2 * wheel;
  state_.torque_x = 2 * transfer * wheel * wheelset_.halfBase();
  for (const Side side : sides)
  {
    state_.rail_lateral_force[side] = uniform(random_, -0.3, 0.6) * wheel;
  }
}

void Walk::jump()
{
  state_.y = oneIn(random_, 20) ? uniform(random_, -0.04, 0.04) : uniform(random_, -0.010, 0.010);
  state_.yaw = oneIn(random_, 2) ? 0 : uniform(random_, -1, 1) * (oneIn(random_, 4) ? 0.06 : 0.01);
  state_.roll = uniform(random_, -5e-4, 5e-4);
  state_.z = wheelset_.rolling_radius.left + uniform(random_, -4e-4, 2e-4);
  drawLoad();
}

void Walk::step()
{
  std::normal_distribution<double> unit;
  state_.y += 3e-4 * unit(random_);
  state_.yaw += state_.yaw != 0 ? 3e-4 * unit(random_) : 0;
  state_.roll += 2e-5 * unit(random_);
  state_.z += 1e-5 * unit(random_);
  const double ratio = std::exp(0.05 * unit(random_));
  state_.force_z *= ratio;
  state_.torque_x *= ratio;
}

const WheelsetState& Walk::next()
{
  const bool was_small = small_;
  small_ = !first_ && !was_small && oneIn(random_, 2);
  if (small_)
  {
    state_.y += small_step;
  }
  else if (!first_)
  {
    oneIn(random_, 3) ? jump() : step();
  }
  first_ = false;
  return state_;
}
}  // namespace

ScenePool readScenePool()
{
  ScenePool pool{wheelProfiles(), railProfiles(), {}};
  for (const auto& entry : std::filesystem::directory_iterator(RAIL_TABLES))
  {
    if (entry.path().extension() == ".yaml")
    {
      const ComplianceTableFile file = readComplianceTable(entry.path());
      pool.tables.push_back({file.name, entry.path().stem(), file.table});
    }
  }
  std::sort(pool.tables.begin(), pool.tables.end(),
            [](const NamedTable& a, const NamedTable& b) { return a.name < b.name; });
  return pool;
}

Scene randomScene(const ScenePool& pool, unsigned long seed)
{
  constexpr int state_count = 30;
  Random random(seed);
  Scene scene;
  scene.wheel = pool.wheels[oneIn(random, 2) ? 0 : random() % pool.wheels.size()];
  scene.rail = pool.rails[oneIn(random, 2) ? 0 : random() % pool.rails.size()];
  scene.config.wheel_profile = scene.wheel.profile;
  scene.config.rail_profile = scene.rail.profile;
  drawTrack(scene.config.track, random);
  scene.config.wheelset.solve_height_and_roll = !oneIn(random, 6);
  drawMethod(scene.config.contact, random);
  drawRail(pool.tables, scene, random);
  Walk walk(scene.config.wheelset, random);
  for (int i = 0; i < state_count; ++i)
  {
    scene.states.push_back(walk.next());
  }
  scene.description = "random scene " + std::to_string(seed) + ": " + describe(scene);
  return scene;
}
}  // namespace wheel_rail_contact::core::stability
