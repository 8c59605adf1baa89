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
/// Receives the name of the next step.
using Progress = std::function<void(const std::string&)>;

/// Solves the cases of the paper and writes figures.csv, profiles.csv, contacts.csv, patches.csv and methods.csv.
void writeCases(const ContactModelConfig& config, const std::filesystem::path& folder, const Progress& progress);

/// Writes pressure and area under lateral forces for each table to forces.csv.
void writeForces(const ContactModelConfig& config, const std::vector<NamedTable>& tables,
                 const std::filesystem::path& folder, const Progress& progress);

/// Writes the highest stresses in the rail to stress.csv, and the pressures above them to stress_patches.csv.
void writeStress(const ContactModelConfig& config, const std::vector<NamedTable>& tables,
                 const std::filesystem::path& folder, const Progress& progress);

/// Searches for settings that give the printed results. Writes scan.csv, and search.csv for rails that bend by the
/// tables.
void writeScan(const ContactModelConfig& config, const std::vector<NamedTable>& tables,
               const std::filesystem::path& folder, const Progress& progress);
}  // namespace wheel_rail_contact::core::paper
