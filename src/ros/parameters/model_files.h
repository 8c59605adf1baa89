// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "ros/parameters/parameters.h"

namespace wheel_rail_contact
{
/// Name of a file or of a shipped profile, with the parameter that gave it.
struct NamedFile
{
  std::string parameter;  ///< full name of the parameter, without the prefix of the node
  std::string value;      ///< as given; empty: not given
  bool mirror = false;    ///< of a profile: its points are mirrored (core::ProfileReading::mirror)
};

inline bool operator==(const NamedFile& a, const NamedFile& b)
{
  return a.value == b.value && a.mirror == b.mirror;
}

/// Files of the model. They are opened after all other values have been checked.
struct ModelFiles
{
  core::Sides<NamedFile> wheel_profile, rail_profile;
  core::Sides<NamedFile> table;  ///< compliance tables
};

/// Opens the files of a configuration. `directory` is that of relative names.
/// @throw std::invalid_argument with the name of the parameter and the reason.
void openFiles(const ModelFiles& files, const std::string& directory, NodeConfig& config);
}  // namespace wheel_rail_contact
