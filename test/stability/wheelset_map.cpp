// SPDX-License-Identifier: BSD-3-Clause
#include "../core/balance/conformal_reference.h"
#include "../core/balance/wheelset_scene.h"
#include "scene.h"
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
  return digits(1e3 * y) + " mm";
}

std::string withoutExtension(const std::string& file)
{
  return std::filesystem::path(file).stem();
}

ContactModelConfig withGauge(double gauge)
{
  ContactModelConfig config = standard();
  config.track.gauge = gauge;
  return config;
}

ContactModelConfig withWheel(const SceneProfile& wheel)
{
  ContactModelConfig config = standard();
  config.wheel_profile = wheel.profile;
  return config;
}

ContactModelConfig withRail(const SceneProfile& rail)
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

/// The axle is 10 mm above its height on the rails.
Situation lifted()
{
  ContactModelConfig config = standard();
  config.wheelset.solve_height_and_roll = false;
  WheelsetState state;
  state.z = config.wheelset.rolling_radius.left + 0.010;
  return {"both wheels above the rails, height given", config, state};
}

std::vector<Situation> situations()
{
  std::vector<Situation> list{{"centred, 100 kN per wheel", standard(), stateAt(0, 1e5)},
                              {"1 N per wheel", standard(), stateAt(0, 1)},
                              {"1 MN per wheel", standard(), stateAt(0, 1e6)},
                              {"one wheel unloaded", standard(), unloading()},
                              lifted()};
  for (const double y : {3e-3, 5e-3, 5.5e-3, 6e-3, 6.5e-3, 7e-3, 8e-3})
  {
    list.push_back({"y = " + inMillimetres(y), standard(), stateAt(y, 1e5)});
  }
  list.push_back({"climbing, y = 10 mm", standard(), stateAt(0.010, 1e5)});
  list.push_back({"flange tip on the rail, y = 40 mm", standard(), stateAt(0.040, 1e5)});
  list.push_back({"derailed, y = 95 mm", standard(), stateAt(0.095, 1e5)});
  list.push_back({"yaw 60 mrad", standard(), stateAt(0, 1e5, 0.06)});
  list.push_back({"yaw 60 mrad, y = 6 mm", standard(), stateAt(6e-3, 1e5, 0.06)});
  list.push_back({"yaw -60 mrad, y = 6 mm", standard(), stateAt(6e-3, 1e5, -0.06)});
  list.push_back({"gauge 1.428 m, y = 3 mm", withGauge(1.428), stateAt(3e-3, 1e5)});
  list.push_back({"gauge 1.47 m, y = 8 mm", withGauge(1.47), stateAt(8e-3, 1e5)});
  for (const double y : {6e-3, 6.5e-3, 7.5e-3, 8e-3})
  {
    list.push_back({"pads 40/100, y = " + inMillimetres(y), standardOn(softPads()), stateAt(y, 1e5)});
  }
  list.push_back({"pads 10/25, y = 6.5 mm", standardOn(verySoftPads()), stateAt(6.5e-3, 1e5)});
  const auto at_both_places = [&list](const std::string& name, const ContactModelConfig& config)
  {
    for (const double y : {1e-3, 6e-3})
    {
      list.push_back({name + ", y = " + inMillimetres(y), config, stateAt(y, 1e5)});
    }
  };
  const std::vector<SceneProfile> wheels = wheelProfiles(), rails = railProfiles();
  for (std::size_t k = 1; k < wheels.size(); ++k)
  {
    at_both_places("wheel " + withoutExtension(wheels[k].name), withWheel(wheels[k]));
  }
  for (std::size_t k = 1; k < rails.size(); ++k)
  {
    at_both_places("rail " + withoutExtension(rails[k].name), withRail(rails[k]));
  }
  return list;
}

WheelsetResult result(ContactModelConfig config, NormalMethod method, const WheelsetState& state)
{
  config.contact.method = method;
  return WheelsetContact(config).evaluate(state);
}

/// Result of conjugate gradients on 64 · `finer` × 128 · `finer` cells. The tolerance of height and roll is five times
/// smaller than in the situations.
WheelsetResult reference(ContactModelConfig config, const WheelsetState& state, int finer)
{
  config.contact.tolerance = 0.002;
  config.contact.cells_along = 64 * finer;
  config.contact.cells_across = 128 * finer;
  return result(config, NormalMethod::conjugate_gradient, state);
}

/// Largest relative error of the maximum pressure of a wheel [-]; infinite if a pressure is not a number.
double pressureError(const WheelsetResult& found, const WheelsetResult& truth)
{
  double error = 0;
  for (const Side side : {Side::left, Side::right})
  {
    const double expected = wheelTotal(truth, side).max_pressure;
    const double value = wheelTotal(found, side).max_pressure;
    const double one = expected > 0 ? std::abs(value / expected - 1) : value > 0 ? 1 : 0;
    error = std::isfinite(value) ? std::max(error, one) : std::numeric_limits<double>::infinity();
  }
  return error;
}

/// Largest error estimate of all patches [-].
double estimateOf(const WheelsetResult& result)
{
  double estimate = 0;
  for (const PatchResult& patch : result.patches)
  {
    estimate = std::max(estimate, patch.error_estimate);
  }
  return estimate;
}

/// A reference, and its difference from one on half as many cells each way [-].
struct Reference
{
  WheelsetResult result;
  double difference;
};

Verdict verdict(const WheelsetResult& found, const Reference& truth, double tolerance)
{
  if (!isUsable(found.status))
  {
    return Verdict::refused(found.reason);
  }
  const double estimate = estimateOf(found);
  Verdict unknown = Verdict("no reference").withFlag(estimate, tolerance);
  if (!isUsable(truth.result.status))
  {
    return unknown;
  }
  const bool nothing_touches = found.patches.empty() && truth.result.patches.empty();
  return Verdict::byLimit(truth.difference, error_classes.front().upper, unknown,
                          nothing_touches
                              ? "no contact"
                              : Verdict::ofError(pressureError(found, truth.result)).withFlag(estimate, tolerance));
}
}  // namespace

MapTable wheelsetMap()
{
  MapTable table{
      "Wheelsets",
      "Wheel S1002 on rail 60E1, rail inclination 1:40, gauge 1.435 m, 100 kN per wheel, tolerance 0.01, unless the "
      "situation gives another value. y is the lateral displacement to the left. \"pads 40/100\" gives the lateral and "
      "vertical stiffness of the rail pads in kN/mm; the rails are rigid in all other situations. Profiles with names "
      "in small letters are in `test/stability/profiles`. The \"wavy\" ones pass through all of their points, which "
      "have noise of 0.5 µm. The points of the others have noise of 5 µm and are smoothed; \"hollow\" and \"worn\" "
      "profiles are worn. The reference is `conjugate_gradient` on 128 × 256 cells. There is no reference where it "
      "differs from the result on 64 × 128 cells by more than 2 %.",
      methodNames(),
      {}};
  for (const Situation& situation : situations())
  {
    Reference truth{reference(situation.config, situation.state, 2), 0};
    truth.difference = pressureError(reference(situation.config, situation.state, 1), truth.result);
    MapRow row{situation.name, {}};
    for (const NormalMethod method : all_normal_methods)
    {
      row.verdicts.push_back(
          verdict(result(situation.config, method, situation.state), truth, situation.config.contact.tolerance));
    }
    table.rows.push_back(row);
  }
  return table;
}

namespace
{
/// Error of the left wheel against the reference code: the larger one of highest pressure and area.
Verdict againstReferenceCode(const WheelsetResult& found, const ConformalReference& expected, double tolerance)
{
  if (!isUsable(found.status))
  {
    return Verdict::refused(found.reason);
  }
  const WheelTotal total = wheelTotal(found, Side::left);
  return Verdict::ofError(std::max(std::abs(total.max_pressure / expected.max_pressure - 1),
                                   std::abs(total.area / expected.area - 1)))
      .withFlag(estimateOf(found), tolerance);
}
}  // namespace

MapTable conformalMap()
{
  MapTable table{
      "Conformal contacts",
      "Wheel S1002 on rail UIC60_manchester, other values as above; left wheel. Between y = 6.2 and 6.4 mm the root of "
      "the flange touches the gauge corner, and the normals turn by up to 0.9 rad over the contact. The reference is "
      "CONTACT, conformal with turned normals (`test/core/balance/conformal_reference.h`). The error is the larger one "
      "of highest pressure and area. Only `auto` and `conjugate_gradient` take into account that the normals turn. "
      "Last column: `half_space_ratio` of the result of `auto`.",
      methodNames(),
      {}};
  table.columns.emplace_back("half_space_ratio");
  const ContactModelConfig config = manchesterScene();
  for (const ConformalReference& expected : conformal_references)
  {
    const double y = -expected.y;  // mirrored: the reference is a right wheel
    MapRow row{"y = " + inMillimetres(y), {}};
    double ratio = 0;
    for (const NormalMethod method : all_normal_methods)
    {
      const WheelsetResult found = result(config, method, stateAt(y, 1e5));
      row.verdicts.push_back(againstReferenceCode(found, expected, config.contact.tolerance));
      for (const PatchResult& patch : found.patches)
      {
        ratio = method == NormalMethod::automatic ? std::max(ratio, patch.half_space_ratio) : ratio;
      }
    }
    row.verdicts.push_back(Verdict::rounded(ratio, 0.05));
    table.rows.push_back(row);
  }
  return table;
}
}  // namespace wheel_rail_contact::core::stability
