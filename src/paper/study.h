// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "paper/forces.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core::paper
{
/// Is told what comes next.
using Progress = std::function<void(const std::string&)>;

/// Solves the paper's cases and writes figures.csv, profiles.csv, contacts.csv, patches.csv and methods.csv.
void writeCases(const ContactModelConfig& config, const std::filesystem::path& folder, const Progress& progress);

/// Pressure and area under lateral forces for each table: forces.csv.
void writeForces(const ContactModelConfig& config, const std::vector<NamedTable>& tables,
                 const std::filesystem::path& folder, const Progress& progress);

/// What settings lead to the printed figures: scan.csv, and search.csv for rails that give way by the tables.
void writeScan(const ContactModelConfig& config, const std::vector<NamedTable>& tables,
               const std::filesystem::path& folder, const Progress& progress);
}  // namespace wheel_rail_contact::core::paper
