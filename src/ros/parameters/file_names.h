// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace wheel_rail_contact
{
/// The file that `name` stands for: `package://name/...` by ROS's package path, an absolute name as it is, a relative
/// one in `directory` or else in this package.
/// @throw std::invalid_argument naming the places where the file was sought.
std::string resolveFile(const std::string& name, const std::string& directory);
}  // namespace wheel_rail_contact
