// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "config/node_config.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact
{
/// Array of numbers with a row for each state, and a column for each Side.
using SideColumns = Eigen::ArrayX2d;

/// Numbers of the results of many states, as arrays with a row for each state. NaN where a result is not usable.
struct ManyResults
{
  explicit ManyResults(std::size_t count);

  std::vector<core::ContactStatus> status;
  std::vector<std::string> status_text;  ///< as statusTextOf()
  Eigen::Array<bool, Eigen::Dynamic, 1> above_tolerance, implausible_force;
  Eigen::ArrayXd z;                              ///< height of the axle centre [m]
  Eigen::ArrayXd roll;                           ///< roll of the axle [rad]
  Eigen::Array<int, Eigen::Dynamic, 2> patches;  ///< number of patches; 0 where a result is not usable
  Eigen::ArrayXd rotation;                       ///< about the axle, given or free; 0 without creep forces [rad/s]
  SideColumns vertical_force;                    ///< whole Q of the wheel on the rail, down positive [N]
  SideColumns lateral_force;                     ///< whole Y of the wheel on the rail, outward positive [N]
  SideColumns friction_vertical_force;           ///< part of Q by friction [N]
  SideColumns friction_lateral_force;            ///< part of Y by friction [N]
  SideColumns adhesion_share;                    ///< largest one of all patches [-]
  SideColumns friction_power;                    ///< dissipated in all patches [W]
  SideColumns max_pressure;                      ///< highest pressure of all patches; 0 without a patch [Pa]
  SideColumns area;                              ///< contact area of all patches [m²]
  SideColumns error_estimate;                    ///< largest one of all patches [-]
  SideColumns contact_angle;        ///< of the patch with the largest normal force [rad]; NaN without a patch
  SideColumns rolling_radius;       ///< of the patch with the largest normal force [m]; NaN without a patch
  SideColumns mean_rolling_radius;  ///< of all patches, weighted by their normal forces [m]; NaN without a patch
  SideColumns wheel_von_mises;      ///< highest von Mises stress in the wheel; 0 without a patch or StressConfig [Pa]
  SideColumns rail_von_mises;       ///< the same in the rail [Pa]
  SideColumns rail_lateral;         ///< displacement of the rail, outward positive [m]
  SideColumns rail_vertical;        ///< displacement of the rail, up positive [m]
  SideColumns rail_roll;            ///< rotation of the rail, positive if the crown moves outward [rad]
  /// With the pressures; empty unless they are kept.
  std::vector<std::shared_ptr<core::WheelsetResult>> results;

  /// True for each usable result.
  Eigen::Array<bool, Eigen::Dynamic, 1> usable() const;
  /// Sets row i.
  void set(std::size_t i, const core::WheelsetResult& result, const core::Sides<double>& linear_range);

 private:
  void setSide(Eigen::Index row, core::Side side, const core::WheelsetResult& result);
};

/// Sequences of states.
struct StateSequences
{
  /// State with an index; called by several threads.
  std::function<core::WheelsetState(std::size_t)> state;
  /// Index after the last state of each sequence, increasing. The first state of a sequence starts cold, each other one
  /// from the one before it.
  std::vector<std::size_t> ends;
};

/// How many states are evaluated.
struct ManyOptions
{
  int threads = 1;            ///< >= 1
  bool keep_results = false;  ///< true: ManyResults::results is filled
};

/// Evaluates many states on several threads, each sequence on one. A result depends neither on other sequences nor on
/// the number of threads.
/// @param is_interrupted is called at intervals and at the end, in the calling thread, with the number of states done;
/// true ends the evaluation, and the remaining results stay as they are at the beginning.
/// @throw an exception of the evaluation, after all threads have ended.
ManyResults evaluateMany(const NodeConfig& config, const StateSequences& sequences, const ManyOptions& options,
                         const std::function<bool(std::size_t done)>& is_interrupted);
}  // namespace wheel_rail_contact
