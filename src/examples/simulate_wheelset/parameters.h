// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simulate_wheelset
{
/// Mass and inertia of the wheelset.
struct WheelsetParameters
{
  double mass = 1500;         ///< [kg]
  double yaw_inertia = 900;   ///< about the vertical and the longitudinal axis through the centre [kg m^2]
  double spin_inertia = 110;  ///< about the axle [kg m^2], for the gyroscopic moments
  double gyroscopic = 1;      ///< 1: with gyroscopic moments; 0: without
  double line_inertia = 1;    ///< 1: with the inertia of height and roll that follow a line; 0: without
  /// Vertical force on the axle centre, down positive: share of the vehicle and weight of the wheelset [N].
  double axle_load = 200e3;
};

/// Primary suspension to a bogie frame that moves steadily along the track, per axle box.
struct SuspensionParameters
{
  double half_spacing = 1.0;              ///< lateral distance of an axle box from the centre [m]
  double longitudinal_stiffness = 0.1e6;  ///< [N/m], >= 0
  double lateral_stiffness = 0.1e6;       ///< [N/m], >= 0
  double vertical_stiffness = 1.0e6;      ///< [N/m], >= 0
  double longitudinal_damping = 0;        ///< [N s/m], >= 0
  double lateral_damping = 0;             ///< [N s/m], >= 0
};

/// Largest number of steps of a run.
constexpr int most_steps = 10'000'000;

/// Start and run of the simulation.
struct RunParameters
{
  double speed = 40;       ///< running speed V [m/s]
  double duration = 10;    ///< simulated time [s]
  double step = 1e-3;      ///< [s]; used is stepNanoseconds()
  double start = 0;        ///< place along the track at the start [m]
  double y = 0.003;        ///< lateral displacement at the start, to the left positive [m]
  double yaw = 0;          ///< yaw at the start, to the left positive [rad]
  double held_steps = 20;  ///< largest number of successive steps without a usable result, a whole number

  /// Time step, rounded to the resolution of stamps [ns].
  std::int64_t stepNanoseconds() const;
  /// Number of steps that cover the duration, at most most_steps.
  int steps() const;
};

/// All parameters of the simulation.
struct Parameters
{
  WheelsetParameters wheelset;
  SuspensionParameters suspension;
  RunParameters run;
};

/// Reads a YAML file with the groups wheelset, suspension and run. Values that are not given keep their default.
/// @throw std::invalid_argument with the file, the name, the value and the broken rule.
Parameters readParameters(const std::string& file);

/// @throw std::invalid_argument if a value breaks its rule, with the name and the value.
void validate(const Parameters& parameters);

/// The ways to the contact calculation.
enum class ContactWay
{
  in_process,
  topics,
  service
};

/// Command line of the program.
struct Options
{
  bool help = false;                            ///< --help
  ContactWay contact = ContactWay::in_process;  ///< --contact
  std::string config;                           ///< --config; empty: the defaults of Parameters
  std::string contact_config;                   ///< --contact-config, for in_process; over contact_parameters
  std::string out;                              ///< --out; empty: no table
  std::string node = "contact_node";            ///< --node: name of the contact node
  std::string frame = "track";                  ///< --frame: its parameter track/frame
  std::optional<double> speed, duration, step;  ///< over the values of the file [m/s], [s], [s]
};

/// Text of --help.
std::string usage();

/// @param arguments without the name of the program and without those of ROS
/// @throw std::invalid_argument with the option, the value and the broken rule.
Options parseOptions(const std::vector<std::string>& arguments);

/// Parameters of the file, with the values of the command line over them.
/// @throw std::invalid_argument with the name, the value and the broken rule.
Parameters parametersOf(const Options& options);
}  // namespace simulate_wheelset
