// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace wheel_rail_contact
{
/// Path of an existing file. `package://PACKAGE/...` is resolved with the ROS package path; an absolute name is used as
/// it is; a relative name is searched in `directory`, then in this package.
/// @throw std::invalid_argument with all searched paths if there is no such file.
std::string resolveFile(const std::string& name, const std::string& directory);
}  // namespace wheel_rail_contact
