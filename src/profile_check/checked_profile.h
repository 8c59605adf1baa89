// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "core/profile/nearest_standard.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core::profile_check
{
/// Profile with all that its file shows.
struct CheckedProfile
{
  ProfileKind kind;      ///< wheel or rail
  std::string known_by;  ///< how the kind is known: a phrase with "by"
  DescribedProfile described;
  StandardFit nearest;  ///< nearest standard profile
};

/// Reads a profile from a file, or takes a standard profile by its name.
///
/// If the kind is not given, the extension of the file name states it (.prw and .whl: wheel; .prr and .ban: rail), or
/// the content: if it is a profile of only one kind, and this is within 5 mm (r.m.s.) of a standard profile of its
/// kind. A reversed wheel can have the shape of a rail, but it is not as close to one.
/// @throw std::runtime_error with the file, the reason and what to do, if there is no such profile, or if its kind is
/// not known.
/// @throw std::invalid_argument if an option is out of range.
CheckedProfile checkedProfile(const std::string& name_or_path, std::optional<ProfileKind> kind,
                              const ProfileReading& reading);
}  // namespace wheel_rail_contact::core::profile_check
