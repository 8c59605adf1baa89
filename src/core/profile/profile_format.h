// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace wheel_rail_contact::core
{
/// True if the first line of a file is that of an old MiniProf file, whose header is free text.
bool beginsOldMiniProf(const std::string& line);
/// True if a line contains the titles of a table with columns of y and z.
bool namesCoordinates(const std::string& line);
}  // namespace wheel_rail_contact::core
