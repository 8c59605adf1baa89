// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "stability_map.h"

namespace wheel_rail_contact::core::stability
{
/// Writes the page doc/stability.md.
void writePage(std::ostream& out, const std::vector<MapTable>& tables);

/// Entries of a page: by title of the table, situation and column. Letters of reasons are left out.
using PageEntries = std::map<std::string, std::map<std::string, std::map<std::string, std::string>>>;
PageEntries readPage(std::istream& in);
}  // namespace wheel_rail_contact::core::stability
