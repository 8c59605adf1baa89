// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/profile/file_profile.h"

namespace wheel_rail_contact::core
{
/// Checks that points in the profile frame are a plausible profile of the given kind. Returns them in order from the
/// gauge (flange) side to the field side, without points too close to the preceding one, and without those at which a
/// measurement of two strokes runs back.
/// @throw TextError with the line and the broken rule.
std::vector<FilePoint> orderedPoints(const TextFile& file, const std::vector<FilePoint>& points, ProfileKind kind);

/// Checks number and extent of points [m].
/// @throw TextError
void checkSize(const TextFile& file, const std::vector<FilePoint>& points);
/// Checks the shape of points in order: that of a wheel, of a rail, or of a section of one.
/// @throw TextError
void checkShape(const TextFile& file, const std::vector<FilePoint>& points, ProfileKind kind);

/// Height of a curve at y = 0 [m], the nearest to 0 if there are several; infinite if it does not cross y = 0.
double heightAtOrigin(const std::vector<FilePoint>& points);

/// Text of a length, in millimetres.
std::string millimetres(double length);
}  // namespace wheel_rail_contact::core
