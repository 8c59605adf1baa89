// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact
{
/// Places where files are searched.
struct FileSearch
{
  std::string directory = ".";  ///< of relative names
  /// Folder of a ROS package by its name; empty if there is no such package. ros::package::getPath is such a function.
  /// Without a function no package is found.
  std::function<std::string(const std::string& package)> package_folder;

  /// Path of an existing file. `package://PACKAGE/...` is in the folder of a package; an absolute name is used as it
  /// is; a relative name is searched in `directory`, then in the package wheel_rail_contact.
  /// @throw std::invalid_argument with all searched paths if there is no such file.
  std::string find(const std::string& name) const;
};

/// The file with all parameters and their defaults.
constexpr const char* default_parameters = "package://wheel_rail_contact/config/default.yaml";

/// Parameters as a YAML file or as the text of a YAML document.
struct ParameterSource
{
  /// What `value` is.
  enum Kind
  {
    file,  ///< the name of a file
    text   ///< the text of a document
  };
  Kind kind = file;   ///< see Kind
  std::string value;  ///< name as for FileSearch::find(), or the text
};

/// Another wheelset on the same rails, whose forces also deflect the rails here.
struct NeighbourConfig
{
  std::string topic;                             ///< topic of its results (WheelsetContact), unresolved
  double distance = 0;                           ///< along the track [m], > 0
  core::Sides<core::ComplianceTable> influence;  ///< compliances of each rail at this distance, from its table
};

/// Parameters of the contact of a wheelset.
struct ContactParameters
{
  core::ContactModelConfig model;  ///< parameters of the core
  /// Largest |Y|/Q for which the compliance table of each rail is valid [-]; infinite without a table.
  core::Sides<double> linear_range = std::numeric_limits<double>::infinity();
  std::vector<NeighbourConfig> neighbours;  ///< empty unless rail_bending/model is compliance
  bool displacement_topic = false;          ///< the displacements of the rails are an input: wheelset/rail_displacement
  bool distance_topic = false;        ///< the place along the line is an input: wheelset/distance; false: x of the pose
  std::vector<std::string> notes;     ///< what was understood of each profile file, one line each
  std::vector<std::string> warnings;  ///< what is possible, but rarely meant, one line each

  /// Notes and warnings, as commands print them.
  std::vector<std::string> remarks() const;
};

/// Reads parameters: those of the node, which config/default.yaml explains. Each source is applied over those before. A
/// parameter that no source gives has its default; only wheel/profile and rail/profile have none. Parameters that only
/// the node uses (sync, markers and others) are checked as well.
/// @throw std::invalid_argument with the name of the parameter, the value and the violated rule for a wrong type or
/// value, a missing required value, or an unknown name; with the file and the reason for an invalid file.
ContactParameters readContactParameters(const std::vector<ParameterSource>& sources, const FileSearch& search);
}  // namespace wheel_rail_contact
