// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "config/parameter_tree.h"
#include "core/track/track_frame.h"
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
  std::string track_frame = "track";            ///< tf name of the track frame
  std::string fixed_frame;                      ///< parent of the published track frame; empty: it is not published
  std::shared_ptr<const core::TrackPath> path;  ///< of the track frame in the fixed frame; null without one
  std::string wheelset_frame;     ///< tf name of the wheelset; empty: from the namespace of its topics (WheelsetFrames)
  bool publish_tf = false;        ///< the wheelset is broadcast on /tf
  bool publish_wrenches = false;  ///< the force on each wheel is published, and its centre of pressure on /tf
  double slop = 0;                ///< largest difference of the stamps of a pair [s], >= 0; 0: equal stamps
  bool interpolate_load =
      false;                 ///< true: the load is interpolated at the stamp of the pose; false: matched by its stamp
  int hold_last = 0;         ///< largest number of results in a row that are held (HoldLast), at most longest_hold
  double longest_gap = 0.1;  ///< largest difference of the stamps of two loads that are interpolated [s], > 0
  MarkerConfig markers;      ///< appearance of the markers
  double min_rate = 0;       ///< least rate of each input topic in the diagnostics [Hz], >= 0; 0: no bound
  double max_delay = 0;      ///< largest delay of its messages, from stamp to arrival [s], >= 0; 0: no bound
};

/// Reads all parameters of the node. config/default.yaml lists their names, units and meanings; the defaults are those
/// of the structs above. The former name track/cant is refused.
/// @param prefix text before each name in messages (the namespace of the node with '/')
/// @throw std::invalid_argument with the full name, the value and the violated rule, for a wrong type or value, a
/// missing required value, or an unknown name; with file and reason for an invalid file.
NodeConfig readNodeConfig(const ParameterTree& tree, const std::string& prefix, const FileSearch& search);
}  // namespace wheel_rail_contact
