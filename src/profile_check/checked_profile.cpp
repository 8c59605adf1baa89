// SPDX-License-Identifier: BSD-3-Clause
#include "profile_check/checked_profile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <variant>

namespace wheel_rail_contact::core::profile_check
{
namespace
{
constexpr double farthest_standard = 5e-3;  ///< of a profile whose kind its content shows, root mean square [m]
constexpr double largest_rotation = 0.15;   ///< of such a profile from the standard one [rad]
constexpr const char* give_kind = "; give --wheel or --rail";

/// Profile, or the reason why there is none.
using Attempt = std::variant<CheckedProfile, std::string>;

std::string reasonOf(const ProfileError& error)
{
  return (error.line() > 0 ? "line " + std::to_string(error.line()) + ": " : "") + error.reason();
}

Attempt attempt(const std::string& name, ProfileKind kind, const std::string& known_by, const ProfileReading& reading)
{
  const bool is_file = std::filesystem::exists(name);
  try
  {
    DescribedProfile described = describedProfile(name, kind, reading);
    StandardFit nearest = nearestStandard(described.profile, kind);
    return CheckedProfile{kind, known_by, std::move(described), std::move(nearest)};
  }
  catch (const ProfileError& error)
  {
    return reasonOf(error);
  }
  catch (const std::invalid_argument& error)
  {
    if (is_file)
    {
      throw;  // an option is out of range
    }
    return std::string(error.what());
  }
}

/// Profile of an attempt.
/// @throw std::runtime_error with its reason if there is none.
CheckedProfile profileOf(const std::string& name, Attempt&& result)
{
  if (const auto* reason = std::get_if<std::string>(&result))
  {
    throw std::runtime_error(name + ": " + *reason);
  }
  return std::get<CheckedProfile>(std::move(result));
}

/// Kind that the extension of a file name states.
std::optional<ProfileKind> kindByExtension(const std::string& name)
{
  std::string extension = std::filesystem::path(name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".prw" || extension == ".whl")
  {
    return ProfileKind::wheel;
  }
  return extension == ".prr" || extension == ".ban" ? std::optional(ProfileKind::rail) : std::nullopt;
}

bool isNearStandard(const Attempt& result)
{
  const auto* profile = std::get_if<CheckedProfile>(&result);
  return profile && profile->nearest.rms < farthest_standard &&
         std::abs(profile->nearest.motion.rotation) < largest_rotation;
}

bool isProfile(const Attempt& result)
{
  return std::holds_alternative<CheckedProfile>(result);
}

/// Reason why the content does not show the kind.
std::string unknownKind(const Attempt& wheel, const Attempt& rail)
{
  if (!isProfile(wheel) && !isProfile(rail))
  {
    const auto &as_wheel = std::get<std::string>(wheel), &as_rail = std::get<std::string>(rail);
    return as_wheel == as_rail ? as_wheel : "as a wheel: " + as_wheel + "; as a rail: " + as_rail + give_kind;
  }
  if (isProfile(wheel) && isProfile(rail))
  {
    return std::string("can be a wheel or a rail") + give_kind;
  }
  const bool is_rail = isProfile(rail);
  return std::string(is_rail ? "can be a rail" : "can be a wheel") + ", but is far from every standard profile; as a " +
         (is_rail ? "wheel: " : "rail: ") + std::get<std::string>(is_rail ? wheel : rail) + give_kind;
}
}  // namespace

CheckedProfile checkedProfile(const std::string& name_or_path, std::optional<ProfileKind> kind,
                              const ProfileReading& reading)
{
  if (kind)
  {
    return profileOf(name_or_path, attempt(name_or_path, *kind, "by option", reading));
  }
  if (const std::optional<ProfileKind> stated = kindByExtension(name_or_path))
  {
    return profileOf(name_or_path, attempt(name_or_path, *stated, "by its extension", reading));
  }
  Attempt wheel = attempt(name_or_path, ProfileKind::wheel, "by its content", reading);
  Attempt rail = attempt(name_or_path, ProfileKind::rail, "by its content", reading);
  if (isProfile(wheel) != isProfile(rail) && (isNearStandard(wheel) || isNearStandard(rail)))
  {
    return std::get<CheckedProfile>(std::move(isProfile(wheel) ? wheel : rail));
  }
  throw std::runtime_error(name_or_path + ": " + unknownKind(wheel, rail));
}
}  // namespace wheel_rail_contact::core::profile_check
