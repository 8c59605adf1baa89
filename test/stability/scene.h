// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../manchester_scene.h"
#include "../standard_headers.h"

namespace wheel_rail_contact::core::stability
{
/// S1002 on rigid rails 60E1.
inline ContactModelConfig standard()
{
  ContactModelConfig config = manchesterScene();
  config.rail_profile = std::make_shared<Profile>(rail60E1());
  return config;
}

/// The same on rails that bend.
inline ContactModelConfig standardOn(const ComplianceTable& table)
{
  ContactModelConfig config = standard();
  bend(config, table);
  return config;
}

/// A profile as a scene file names it.
struct SceneProfile
{
  std::string name;                        ///< of a standard profile or of a file
  std::optional<double> noise;             ///< standard deviation of the points of the file across the curve [m]
  std::shared_ptr<const Profile> profile;  ///< the curve
};

/// Loads a standard profile by name, or a file. A file is looked up in `folder`, then in test/stability/profiles.
/// @param noise  standard deviation of the points of a file [m]; without it the default of the file format.
/// @throw FileError, std::invalid_argument as loadProfile() and readProfile().
SceneProfile loadSceneProfile(const std::string& name, ProfileKind kind, std::optional<double> noise = std::nullopt,
                              const std::string& folder = "");

/// The profiles of random scenes and of doc/stability.md: standard profiles, and profiles from the points in
/// test/stability/profiles. "wavy": splines through points with noise of 0.5 um. "measured", "hollow", "worn": points
/// with noise of 5 um, smoothed; "hollow" and "worn" are worn profiles. The standard wheel or rail is the first.
std::vector<SceneProfile> wheelProfiles();
/// Same for the rails.
std::vector<SceneProfile> railProfiles();

/// A configuration and the sequence of states that is evaluated with it. `config` refers to both profiles.
struct Scene
{
  std::string description;  ///< for a regression scene: the fault that was found
  SceneProfile wheel, rail;
  std::string table_name;  ///< of the compliance table; empty without one
  ContactModelConfig config;
  std::vector<WheelsetState> states;
};

/// Lateral step between two neighbouring states whose results are compared [m].
constexpr double small_step = 1e-6;

/// True if the states differ by `small_step` in y only.
bool areNeighbours(const WheelsetState& before, const WheelsetState& after);

/// Lateral displacement of a wheelset beyond its flange clearance [m]: a flange of standard thickness (32.5 mm) would
/// overlap a vertical gauge face by this length. Negative within the clearance.
double beyondClearance(const ContactModelConfig& config, const WheelsetState& state);

/// Model of the rails in words.
std::string railModel(const Scene& scene);
/// Profiles, method, rails and track on one line.
std::string describe(const Scene& scene);
/// All numbers of a state except `x` and `rail_displacement`.
std::string describe(const WheelsetState& state);
}  // namespace wheel_rail_contact::core::stability
