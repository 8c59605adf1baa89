// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "ros/markers/marker_config.h"
#include "ros/parameters/parameter_tree.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact
{
/// Another wheelset on the same track, whose forces bend the rails here too.
struct NeighbourConfig
{
  std::string topic;                ///< of its answers (WheelsetContact), as subscribed to
  double distance = 0;              ///< along the track [m], > 0
  core::ComplianceTable influence;  ///< at that distance, from the table
};

/// Everything the live node and the replay are told by parameters.
struct NodeConfig
{
  core::ContactModelConfig model;  ///< what the core is told
  /// Largest |Y|/Q up to which the compliance table holds [-]; infinite without a table.
  double linear_range = std::numeric_limits<double>::infinity();
  std::vector<NeighbourConfig> neighbours;  ///< none unless the rails bend by a table
  std::string track_frame = "track";        ///< tf name of the track frame
  double slop = 0;                          ///< largest distance of the stamps of one pair [s], >= 0; 0: equal stamps
  MarkerConfig markers;                     ///< how markers are drawn
};

/// Reads all parameters of the node. Schema (defaults: the structs above; config/default.yaml lists every name):
///
///   track/{gauge, gauge_depth, rail_inclination}            [m, m, rad]
///   track/frame                                 tf name
///   wheelset/{rolling_radius, flange_back_distance, tape_circle}   [m]
///   wheelset/free                               [z, roll] (solved from the load) or [] (taken from the pose)
///   wheel/profile, rail/profile                 required: name of a shipped profile, or a file
///   material/{wheel,rail}/{young, poisson}      [Pa, -]
///   rail_bending/model                          none, prescribed or compliance
///   rail_bending/table                          file, required with model compliance
///   rail_bending/lateral_force                  contact, topic, or a constant [N], outward positive
///   rail_bending/neighbours                     list of {topic, distance [m]}; not empty only with model compliance
///   rail_bending/prescribed/{lateral, vertical, roll}   [m, m, rad], required with model prescribed
///   contact/method                              auto, conjugate_gradient, hertz, kik_piotrowski, seidel
///                                               or seidel_printed
///   contact/tolerance                           relative
///   contact/grid/{along, across}                cells; 0: chosen from the tolerance
///   sync/slop                                   [s]
///   markers/{rate, rail_length, force_scale, max_pressure, zoom, zoom_height, pressure_height}
///
/// Files: `package://name/...`, absolute, or relative to `directory` or else to this package.
/// @param prefix is written before each name in messages (the node's namespace with '/')
/// @throw std::invalid_argument with the full name, the value and the broken rule, for a wrong type or value, a missing
/// required value, or an unknown name; with file and reason for a file that cannot be used.
NodeConfig readNodeConfig(const ParameterTree& tree, const std::string& prefix, const std::string& directory);

/// The names of all parameters.
std::set<std::string> parameterNames();
}  // namespace wheel_rail_contact
