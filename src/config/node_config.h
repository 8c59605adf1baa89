// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "config/parameter_tree.h"
#include "wheel_rail_contact/config_file.h"

namespace wheel_rail_contact
{
/// Appearance of the markers.
struct MarkerConfig
{
  double rate = 20;             ///< maximum rate of the markers, in wall time [Hz], > 0
  double rail_length = 0.4;     ///< drawn length of both rails [m], > 0
  double force_scale = 2.5e-6;  ///< length of a force arrow [m/N], >= 0; 0: no arrows
  double max_pressure = 0;      ///< upper end of the colour scale [Pa], >= 0; 0: follows the pressures (PressureScale)
  double zoom = 15;             ///< magnification of the patches above the rails [-], >= 0; 0: not drawn
  double zoom_height = 0.12;    ///< height of the magnified patches above the true patches [m], >= 0
  double pressure_height = 0.10;  ///< height of the magnified pressure surface at the upper end of the scale [m], >= 0
};

constexpr int longest_hold = 200;  ///< upper limit of contact/hold_last [results]

/// All parameters of the live node and the replay.
struct NodeConfig : ContactParameters
{
  std::string track_frame = "track";  ///< tf name of the track frame
  double slop = 0;                    ///< largest difference of the stamps of a pair [s], >= 0; 0: equal stamps
  bool interpolate_load =
      false;                 ///< true: the load is interpolated at the stamp of the pose; false: matched by its stamp
  int hold_last = 0;         ///< largest number of results in a row that are held (HoldLast), at most longest_hold
  double longest_gap = 0.1;  ///< largest difference of the stamps of two loads that are interpolated [s], > 0
  MarkerConfig markers;      ///< appearance of the markers
};

/// Reads all parameters of the node. The defaults are those of the structs above; config/default.yaml lists all names.
/// Schema:
///
///   track/{gauge, gauge_depth}                  [m]
///   track/rail_inclination                      [rad], or a ratio 1:N, which is atan(1/N). A number between 60 and
///                                               120 is the ratio 1:N with N = number - 60: YAML 1.1 parsers (rosparam,
///                                               roslaunch) read an unquoted 1:N as the sexagesimal number 60 + N.
///                                               The former name track/cant is refused
///   track/frame                                 tf name
///   track/line                                  file with the irregularities, or the group {file, axes, longest_gap},
///                                               axes: rep103 or railway, longest_gap [m]
///   track/displacement                          none or topic
///   track/distance                              pose or topic
///   wheelset/{rolling_radius, flange_back_distance, tape_circle}   [m]
///   wheelset/free                               [z, roll] (solved from the load) or [] (taken from the pose)
///   wheel/profile, rail/profile                 required: name of a shipped profile, or a file, or the group
///                                               {file, unit, y, z, origin, shift, rotate, mirror, smoothing},
///                                               see readProfileOptions()
///   material/{wheel,rail}/{young, poisson}      [Pa, -]
///   wheel/{left,right}/{profile, rolling_radius, material/...}          of one side; default: the value for both sides
///   rail/{left,right}/{profile, inclination, table, material/...}       the same
///   rail_bending/model                          none, prescribed or compliance
///   rail_bending/table                          file, required with model compliance
///   rail_bending/lateral_force                  contact, topic, or a constant [N], outward positive
///   rail_bending/neighbours                     list of {topic, distance [m]}; not empty only with model compliance
///   rail_bending/prescribed/{lateral, vertical, roll}   [m, m, rad], required with model prescribed
///   contact/method                              auto, conjugate_gradient, hertz, kik_piotrowski, seidel
///                                               or seidel_printed
///   contact/tolerance                           relative error [-]
///   contact/grid/{along, across}                number of cells; 0: chosen from the tolerance
///   creep/method                                none, linear, fastsim or exact
///   creep/{friction, slip_share, slip_decay}    [-, -, s/m]
///   creep/{left,right}/{friction, slip_share, slip_decay}               of one side; default: the value for both sides
///   creep/rotation                              free or topic
///   creep/field                                 true only with creep/method exact
///   contact/hold_last                           number of results, 0 to longest_hold
///   sync/{slop, longest_gap}                    [s]
///   sync/load                                   match or interpolate
///   markers/{rate, rail_length, force_scale, max_pressure, zoom, zoom_height, pressure_height}
///
/// @param prefix text before each name in messages (the namespace of the node with '/')
/// @throw std::invalid_argument with the full name, the value and the violated rule, for a wrong type or value, a
/// missing required value, or an unknown name; with file and reason for an invalid file.
NodeConfig readNodeConfig(const ParameterTree& tree, const std::string& prefix, const FileSearch& search);
}  // namespace wheel_rail_contact
