// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scene_profile.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::stability
{
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
