// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "wheel_rail_contact/core/contact_geometry.h"

namespace wheel_rail_contact::core::contact_geometry
{
/// Amplitudes of the wave [m].
struct Amplitudes
{
  double first, last, step;
};

/// Writes the contact geometry at each lateral displacement as CSV, in SI units. Where there is no result, only the
/// displacement and the reason are written.
/// @throw std::runtime_error if the file cannot be written
void writePoints(const ContactGeometry& geometry, const std::filesystem::path& file);

/// Writes equivalent conicity and wavelength for each amplitude as CSV, in SI units. Where there is no result, only the
/// amplitude and the reason are written.
/// @throw std::runtime_error if the file cannot be written
void writeConicity(const ContactGeometry& geometry, const WheelsetConfig& wheelset, const Amplitudes& amplitudes,
                   const std::filesystem::path& file);
}  // namespace wheel_rail_contact::core::contact_geometry
