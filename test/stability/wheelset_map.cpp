// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "../core/balance/wheelset_scene.h"
#include "random_scene.h"
#include "stability_map.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
struct Situation
{
  std::string name;
  ContactModelConfig config;
  WheelsetState state;
};

std::string inMillimetres(double y)
{
  const long tenths = std::lround(1e4 * y);
  return std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10)) + " mm";
}

ContactModelConfig standard()
{
  ContactModelConfig config = manchesterScene();
  config.rail_profile = std::make_shared<Profile>(rail60E1());
  return config;
}

ContactModelConfig withGauge(double gauge)
{
  ContactModelConfig config = standard();
  config.track.gauge = gauge;
  return config;
}

ContactModelConfig onPads(const ComplianceTable& table)
{
  ContactModelConfig config = standard();
  config.rail_bending.model = RailBendingConfig::Model::compliance;
  config.rail_bending.table = table;
  return config;
}

ContactModelConfig withWheel(const NamedProfile& wheel)
{
  ContactModelConfig config = standard();
  config.wheel_profile = wheel.profile;
  return config;
}

ContactModelConfig withRail(const NamedProfile& rail)
{
  ContactModelConfig config = standard();
  config.rail_profile = rail.profile;
  return config;
}

WheelsetState unloading()
{
  WheelsetState state = stateAt(0, 1e5);
  state.torque_x = 1.2 * 2e5 * standard().wheelset.halfBase();
  return state;
}

/// Held above the rails by 10 mm.
Situation lifted()
{
  ContactModelConfig config = standard();
  config.wheelset.solve_height_and_roll = false;
  WheelsetState state;
  state.z = config.wheelset.rolling_radius + 0.010;
  return {"both wheels lifted off, height given", config, state};
}

std::vector<Situation> situations()
{
  const Pool pool = makePool({});
  std::vector<Situation> list{{"centred, 100 kN a wheel", standard(), stateAt(0, 1e5)},
                              {"1 N a wheel", standard(), stateAt(0, 1)},
                              {"1 MN a wheel", standard(), stateAt(0, 1e6)},
                              {"a wheel unloaded", standard(), unloading()},
                              lifted()};
  for (const double y : {3e-3, 5e-3, 5.5e-3, 6e-3, 6.5e-3, 7e-3, 8e-3})
  {
    list.push_back({"y = " + inMillimetres(y), standard(), stateAt(y, 1e5)});
  }
  list.push_back({"climbing, y = 10 mm", standard(), stateAt(0.010, 1e5)});
  list.push_back({"on the flange's tip, y = 40 mm", standard(), stateAt(0.040, 1e5)});
  list.push_back({"derailed, y = 95 mm", standard(), stateAt(0.095, 1e5)});
  list.push_back({"yaw 60 mrad", standard(), stateAt(0, 1e5, 0.06)});
  list.push_back({"yaw 60 mrad, y = 6 mm", standard(), stateAt(6e-3, 1e5, 0.06)});
  list.push_back({"yaw -60 mrad, y = 6 mm", standard(), stateAt(6e-3, 1e5, -0.06)});
  list.push_back({"gauge 1.42 m, y = 3 mm", withGauge(1.42), stateAt(3e-3, 1e5)});
  list.push_back({"gauge 1.47 m, y = 8 mm", withGauge(1.47), stateAt(8e-3, 1e5)});
  for (const double y : {6e-3, 6.5e-3, 7.5e-3, 8e-3})
  {
    list.push_back({"pads 40/100, y = " + inMillimetres(y), onPads(softPads()), stateAt(y, 1e5)});
  }
  list.push_back({"pads 10/25, y = 6.5 mm", onPads(verySoftPads()), stateAt(6.5e-3, 1e5)});
  const auto at_both_places = [&list](const std::string& name, const ContactModelConfig& config)
  {
    for (const double y : {1e-3, 6e-3})
    {
      list.push_back({name + ", y = " + inMillimetres(y), config, stateAt(y, 1e5)});
    }
  };
  for (std::size_t k = 1; k < pool.wheels.size(); ++k)
  {
    at_both_places(pool.wheels[k].name, withWheel(pool.wheels[k]));
  }
  for (std::size_t k = 1; k < pool.rails.size(); ++k)
  {
    at_both_places(pool.rails[k].name, withRail(pool.rails[k]));
  }
  return list;
}

WheelsetResult result(ContactModelConfig config, NormalMethod method, const WheelsetState& state)
{
  config.contact.method = method;
  return WheelsetContact(config).evaluate(state);
}

/// By conjugate gradients on 64 · `finer` × 128 · `finer` cells, with height, roll and planes settled five times
/// closer.
WheelsetResult reference(ContactModelConfig config, const WheelsetState& state, int finer)
{
  config.contact.tolerance = 0.002;
  config.contact.cells_along = 64 * finer;
  config.contact.cells_across = 128 * finer;
  return result(config, NormalMethod::conjugate_gradient, state);
}

double pressureError(const WheelsetResult& found, const WheelsetResult& truth)
{
  double error = 0;
  for (const Side side : {Side::left, Side::right})
  {
    const double expected = wheelTotal(truth, side).max_pressure;
    const double value = wheelTotal(found, side).max_pressure;
    error = std::max(error, expected > 0 ? std::abs(value / expected - 1) : value > 0 ? 1 : 0);
  }
  return error;
}

/// `sure`: the truth's own error is within that of an answer that is right.
std::string verdict(const WheelsetResult& found, const WheelsetResult& truth, bool sure)
{
  if (!isUsable(found.status))
  {
    return "refused: " + found.reason;
  }
  if (!isUsable(truth.status) || !sure)
  {
    return verdictSaid("no reference", found.above_tolerance);
  }
  return found.patches.empty() && truth.patches.empty()
             ? found.reason
             : verdictSaid(verdictOf(pressureError(found, truth)), found.above_tolerance);
}

MapTable solveAll()
{
  constexpr std::array<NormalMethod, 6> methods{NormalMethod::automatic,      NormalMethod::conjugate_gradient,
                                                NormalMethod::seidel,         NormalMethod::seidel_printed,
                                                NormalMethod::kik_piotrowski, NormalMethod::hertz};
  MapTable table{
      "Wheelsets",
      "S1002 on 60E1, inclination 1:40, gauge 1.435 m, tolerance 0.01, unless the row says otherwise; y is the way to "
      "the left. The reference is `conjugate_gradient` on 128 × 256 cells, and none where it differs from 64 × 128 by "
      "more than \"right\". \"And says so\" means that the answer's error estimate is above the tolerance, which its "
      "status text tells. `auto` is right or refuses; on a wheel and a rail drawn through noisy points, with waves "
      "of 0.5 mm that the reference hardly resolves to 2 %, it says that its estimate is above the tolerance.",
      {"auto", "conjugate_gradient", "seidel", "seidel_printed", "kik_piotrowski", "hertz"},
      {}};
  for (const Situation& situation : situations())
  {
    const WheelsetResult truth = reference(situation.config, situation.state, 2);
    const bool sure = verdictOf(pressureError(reference(situation.config, situation.state, 1), truth)) == "right";
    MapRow row{situation.name, {}};
    for (const NormalMethod method : methods)
    {
      row.verdicts.push_back(verdict(result(situation.config, method, situation.state), truth, sure));
    }
    table.rows.push_back(row);
  }
  return table;
}
}  // namespace

const MapTable& wheelsetMap()
{
  static const MapTable table = solveAll();
  return table;
}
}  // namespace wheel_rail_contact::core::stability
