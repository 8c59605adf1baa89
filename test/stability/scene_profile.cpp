// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <filesystem>

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
}  // namespace wheel_rail_contact::core::stability
