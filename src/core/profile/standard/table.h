// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Standard profile and its name in parameters.
struct StandardProfile
{
  const char* name;
  ProfileKind kind;   ///< wheel or rail
  Profile (*make)();  ///< makes the profile
};

/// Standard profile with exactly this name, or nullptr.
const StandardProfile* findStandardProfile(const std::string& name);

/// Names of all standard profiles, separated by a comma and a blank, for messages.
std::string listOfStandardProfiles();
}  // namespace wheel_rail_contact::core
