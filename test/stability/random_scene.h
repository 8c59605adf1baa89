// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace wheel_rail_contact::core::stability
{
struct NamedTable
{
  std::string name;
  std::string file;  ///< without folder and extension
  ComplianceTable table;
};

/// Profiles and compliance tables of random scenes.
struct ScenePool
{
  std::vector<SceneProfile> wheels, rails;
  std::vector<NamedTable> tables;
};

/// Reads the profiles of scene.h and the tables of config/rails.
/// @throw std::exception if a file cannot be read.
ScenePool readScenePool();

/// Scene with random profiles, track, method, tolerance, grid and rail model, and thirty states: jumps to any place,
/// steps of about 0.3 mm, and steps of `small_step`. A seed gives the same scene only as long as the random draws are
/// unchanged. Regression scenes are therefore stored in files (scene_file.h).
Scene randomScene(const ScenePool& pool, unsigned long seed);
}  // namespace wheel_rail_contact::core::stability
