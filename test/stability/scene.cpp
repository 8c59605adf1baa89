// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
constexpr double measurement_noise = 5e-6;  ///< [m]

std::string resolved(const std::string& file, const std::string& folder)
{
  const std::filesystem::path nearby = std::filesystem::path(folder) / file;
  return std::filesystem::exists(nearby) ? nearby.string()
                                         : (std::filesystem::path(STABILITY_FOLDER) / "profiles" / file).string();
}

/// All numbers of a state but y.
auto besidesY(const WheelsetState& s)
{
  const auto offset = [](const RailDeflection& d) { return std::tuple(d.lateral, d.vertical, d.roll); };
  return std::tuple(s.x, s.z, s.yaw, s.roll, s.force_z, s.torque_x, s.rail_lateral_force,
                    offset(s.rail_displacement.left), offset(s.rail_displacement.right));
}
}  // namespace

SceneProfile loadSceneProfile(const std::string& name, ProfileKind kind, std::optional<double> noise,
                              const std::string& folder)
{
  const bool is_file = name.find_first_of("./") != std::string::npos;
  return {name, noise,
          std::make_shared<Profile>(is_file ? readProfile(resolved(name, folder), kind, {noise})
                                            : loadProfile(name, kind))};
}

std::vector<SceneProfile> wheelProfiles()
{
  return {loadSceneProfile("S1002", ProfileKind::wheel), loadSceneProfile("s1002_wavy.csv", ProfileKind::wheel, 0),
          loadSceneProfile("s1002_measured.csv", ProfileKind::wheel, measurement_noise),
          loadSceneProfile("s1002_hollow.csv", ProfileKind::wheel, measurement_noise)};
}

std::vector<SceneProfile> railProfiles()
{
  return {loadSceneProfile("60E1", ProfileKind::rail), loadSceneProfile("UIC60_manchester", ProfileKind::rail),
          loadSceneProfile("60e1_wavy.csv", ProfileKind::rail, 0),
          loadSceneProfile("60e1_measured.csv", ProfileKind::rail, measurement_noise),
          loadSceneProfile("60e1_worn.csv", ProfileKind::rail, measurement_noise)};
}

bool areNeighbours(const WheelsetState& before, const WheelsetState& after)
{
  constexpr double rounding = 1e-12;  // [m]
  return std::abs(after.y - before.y - small_step) < rounding && besidesY(before) == besidesY(after);
}

double beyondClearance(const ContactModelConfig& config, const WheelsetState& state)
{
  constexpr double flange_thickness = 0.0325;
  const double over_flanges = config.wheelset.flange_back_distance + 2 * flange_thickness;
  return std::abs(state.y) - 0.5 * (config.track.gauge - over_flanges);
}

std::string railModel(const Scene& scene)
{
  using LateralForce = RailBendingConfig::LateralForce;
  switch (scene.config.rail_bending.model)
  {
    case RailBendingConfig::Model::none:
      return "rigid";
    case RailBendingConfig::Model::prescribed:
      return "prescribed deflection";
    default:
      break;
  }
  switch (scene.config.rail_bending.lateral_force)
  {
    case LateralForce::constant:
      return scene.table_name + ", constant force";
    case LateralForce::topic:
      return scene.table_name + ", force of the state";
    default:
      return scene.table_name + ", force of the contact";
  }
}

std::string describe(const Scene& scene)
{
  const ContactConfig& contact = scene.config.contact;
  char method[100], track[120];
  std::snprintf(method, sizeof method, "%s, tolerance %.3g, grid %d x %d", toString(contact.method), contact.tolerance,
                contact.cells_along, contact.cells_across);
  std::snprintf(track, sizeof track, "inclination %.4g rad, gauge %.4f m, height and roll %s",
                scene.config.track.rail_inclination.left, scene.config.track.gauge,
                scene.config.wheelset.solve_height_and_roll ? "from the load" : "given");
  return scene.wheel.name + " on " + scene.rail.name + "; " + method + "; rails: " + railModel(scene) + "; " + track;
}

std::string describe(const WheelsetState& state)
{
  char text[300];
  std::snprintf(text, sizeof text,
                "y %.9g m, z %.9g m, yaw %.9g rad, roll %.9g rad, force_z %.9g N, torque_x %.9g N m, "
                "rail forces %.9g N and %.9g N",
                state.y, state.z, state.yaw, state.roll, state.force_z, state.torque_x, state.rail_lateral_force.left,
                state.rail_lateral_force.right);
  return text;
}
}  // namespace wheel_rail_contact::core::stability
