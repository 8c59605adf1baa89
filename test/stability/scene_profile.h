// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core::stability
{
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
}  // namespace wheel_rail_contact::core::stability
