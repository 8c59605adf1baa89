// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/profile/profile_placing.h"

namespace wheel_rail_contact::core
{
/// Unit and axes of a file, see knownAxes().
/// @throw TextError that names what is not known, and the values by which the points are a profile.
FileAxes requiredAxes(const TextFile& file, const FileProfile& content, ProfileKind kind,
                      const ProfileReading& reading);

/// Names the directions of y and z by which the points are a profile, for the message of a refusal; empty if there are
/// none.
std::string hintFor(const TextFile& file, const FileProfile& content, ProfileKind kind, const FileAxes& axes,
                    const ProfileReading& reading);
}  // namespace wheel_rail_contact::core
