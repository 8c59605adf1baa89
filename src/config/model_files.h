// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "config/node_config.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact
{
/// Name of a file or of a shipped profile, with the parameter that gave it.
struct NamedFile
{
  std::string parameter;         ///< full name of the parameter, without the prefix of the node
  std::string value;             ///< as given; empty: not given
  core::ProfileReading reading;  ///< options of a profile
};

inline bool operator==(const NamedFile& a, const NamedFile& b)
{
  return a.value == b.value && a.reading == b.reading;
}

/// File of a section of a rail.
struct RailSectionFile
{
  double x = 0;  ///< place on the line [m]
  NamedFile file;
};

inline bool operator==(const RailSectionFile& a, const RailSectionFile& b)
{
  return a.x == b.x && a.file == b.file;
}

/// Files of one part of a rail: slices, or sections with their places.
struct RailPartFiles
{
  NamedFile slices;                       ///< empty: not given
  std::vector<RailSectionFile> sections;  ///< used without slices; one: the same everywhere
  core::ProfileReading reading;           ///< options of all of them
};

inline bool operator==(const RailPartFiles& a, const RailPartFiles& b)
{
  return a.slices == b.slices && a.sections == b.sections && a.reading == b.reading;
}

/// Files of a rail: one profile, or parts with sections.
struct RailFiles
{
  std::string parameter;             ///< name of the group with the parts
  NamedFile profile;                 ///< used without parts
  std::vector<RailPartFiles> parts;  ///< the running rail first
  core::RailSections::Placement placement = core::RailSections::Placement::gauge;
};

inline bool operator==(const RailFiles& a, const RailFiles& b)
{
  return a.profile == b.profile && a.parts == b.parts && a.placement == b.placement;
}

/// Files of the model. They are opened after all other values have been checked.
struct ModelFiles
{
  core::Sides<NamedFile> wheel_profile;
  core::Sides<NamedFile> rim;                  ///< tables of OutOfRound; empty: not given
  core::Sides<core::OutOfRound> out_of_round;  ///< the rest of it
  core::Sides<RailFiles> rail;
  core::Sides<NamedFile> table;  ///< compliance tables
  NamedFile line;                ///< irregularities; empty: the ideal track
  core::LineReading line_reading;
};

/// Opens a standard profile by its name, or a file if the name contains a dot or a slash.
/// @throw std::exception with the reason.
core::DescribedProfile openProfile(const std::string& name, core::ProfileKind kind, const core::ProfileReading& reading,
                                   const FileSearch& search);

/// Opens the files of a configuration.
/// @throw std::invalid_argument with the name of the parameter and the reason.
void openFiles(const ModelFiles& files, const FileSearch& search, NodeConfig& config);
}  // namespace wheel_rail_contact
