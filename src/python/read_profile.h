// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "wheel_rail_contact/core/profile.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact
{
/// Profile for Python.
struct ReadProfile
{
  std::shared_ptr<const core::Profile> profile;  ///< not null
  std::string report;                            ///< what was understood of its file, in one line; may be empty
};

/// Kind by its name: "wheel", "rail" or "rail_section".
/// @throw std::invalid_argument for another name.
core::ProfileKind kindOf(const std::string& name);
}  // namespace wheel_rail_contact
